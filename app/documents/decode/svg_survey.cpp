#include "app/documents/decode/svg_survey.h"

#include "app/documents/decode/svg_nodes.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include <pugixml.hpp>

namespace touchline {
namespace decode {
namespace {

void note(SaidLanguages& said, std::string_view tag) {
    if (std::ranges::find(said, tag) == said.end()) said.emplace_back(tag);
}

SaidLanguages languages_of(const pugi::xml_node& parent, std::string_view name) {
    SaidLanguages said;
    for (const pugi::xml_node& child : parent.children())
        if (child.type() == pugi::node_element && local_name(child) == name &&
            !text_of(child).empty())
            note(said, tag_of(child));
    return said;
}

/// Counts lines up to places that only grow.
class LineCounter {
  public:
    explicit LineCounter(std::string_view text) : text_(text) {}

    int line_at(std::ptrdiff_t offset) {
        const auto wanted =
            std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), text_.size());
        for (; at_ < wanted; ++at_)
            if (text_[at_] == '\n') ++line_;
        return line_;
    }

  private:
    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
};

/// Visits what the map's reader takes (map_svg.cpp), in the order of the document.
void survey(const pugi::xml_node& parent, int depth, LineCounter& lines, SvgSurvey& made) {
    if (depth > max_nesting) return;
    for (const pugi::xml_node& element : parent.children()) {
        if (element.type() != pugi::node_element || is_hidden(element)) continue;
        const std::string_view name = local_name(element);
        if (name == "g" || name == "a" || name == "svg") survey(element, depth + 1, lines, made);
        if (name != "text" && !is_shape(name)) continue;
        SurveyedPart part{element.attribute("id").value(), lines.line_at(element.offset_debug()),
                          languages_of(element, "title")};
        if (name == "text" && !text_of(element).empty()) note(part.name, tag_of(element));
        if (name != "text" && element.attribute("data-label")) note(part.name, "");
        made.parts.push_back(std::move(part));
    }
}

constexpr int deepest = 1000;  // nesting and references together
constexpr std::size_t too_many = most_drawn_again + 1;

constexpr std::array<const char*, 9> painted_with{"fill",         "stroke",     "mask",
                                                  "clip-path",    "filter",     "marker",
                                                  "marker-start", "marker-mid", "marker-end"};

/// NAME of "#NAME" and of "url(#NAME)"; empty if it refers to nothing in this file.
std::string_view target_of(std::string_view reference) {
    const auto from = reference.find('#');
    if (from == std::string_view::npos) return {};
    const std::string_view name = reference.substr(from + 1);
    return name.substr(0, name.find_first_of("\"')"));
}

struct Drawn {
    std::size_t in_all = 0;
    std::size_t again = 0;

    void add(const Drawn& other) {
        in_all = std::min(in_all + other.in_all, too_many);
        again = std::min(again + other.again, too_many);
    }
};

class Counter {
  public:
    explicit Counter(const pugi::xml_node& root) {
        for_each_element(root, [this](const pugi::xml_node& element) {
            if (const auto id = element.attribute("id")) named_.emplace(id.value(), element);
        });
    }

    /// A reference back to an element being counted draws nothing: librsvg breaks such circles.
    Drawn count(const pugi::xml_node& element, int depth) {
        if (depth > deepest) return {too_many, too_many};
        const auto [known, is_new] = counted_.try_emplace(element.hash_value());
        if (!is_new) return known->second;
        Drawn drawn{1, 0};
        for (const pugi::xml_node& child : element.children())
            if (child.type() == pugi::node_element) drawn.add(count(child, depth + 1));
        for (const char* name : {"href", "xlink:href"})
            drawn.add(referred(element.attribute(name).value(), depth));
        for (const char* name : painted_with)
            drawn.add(referred(property_of(element, name), depth));
        return counted_[element.hash_value()] = drawn;
    }

  private:
    Drawn referred(std::string_view reference, int depth) {
        const auto target = named_.find(target_of(reference));
        if (target == named_.end()) return {};
        const std::size_t drawn = count(target->second, depth + 1).in_all;
        return {drawn, drawn};
    }

    std::unordered_map<std::string_view, pugi::xml_node> named_;
    std::unordered_map<std::size_t, Drawn> counted_;
};

}  // namespace

std::size_t drawn_again(std::string_view svg) {
    pugi::xml_document document;
    if (!document.load_buffer(svg.data(), svg.size())) return 0;
    return Counter(document).count(document, 0).again;
}

}  // namespace decode

Result<SvgSurvey> survey_svg(std::string_view text) {
    pugi::xml_document document;
    const pugi::xml_node root = decode::svg_root_in(text, document);
    if (!root) return failure("the picture is no SVG; save it again as SVG");
    SvgSurvey made{decode::languages_of(root, "title"), decode::languages_of(root, "desc"), {}};
    decode::LineCounter lines(text);
    decode::survey(root, 0, lines, made);
    return made;
}

bool speaks(const SaidLanguages& said, std::string_view language, std::string_view untagged) {
    const auto is_meant =
        [language = in_small_letters(decode::language_in(language))](std::string_view tag) {
            return in_small_letters(decode::language_in(tag)) == language;
        };
    return std::ranges::any_of(said, [&](const std::string& tag) {
        return is_meant(tag.empty() ? untagged : std::string_view(tag));
    });
}

int xml_error_line(std::string_view text) {
    pugi::xml_document document;
    const auto parsed = document.load_buffer(text.data(), text.size());
    return parsed ? 0 : decode::LineCounter(text).line_at(parsed.offset);
}

}  // namespace touchline
