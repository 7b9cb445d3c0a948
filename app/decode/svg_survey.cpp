#include "app/decode/svg_survey.h"

#include "app/decode/ascii.h"
#include "app/decode/svg_nodes.h"

#include <algorithm>

#include <pugixml.hpp>

namespace touchline {
namespace decode {
namespace {

std::string language_in(std::string_view tag) {
    return lower(tag.substr(0, tag.find('-')));
}

std::string tag_of(const pugi::xml_node& element) {
    const auto attribute = element.attribute("xml:lang");
    return attribute ? attribute.value() : element.attribute("lang").value();
}

void note(SaidLanguages& said, const std::string& tag) {
    if (std::find(said.begin(), said.end(), tag) == said.end()) said.push_back(tag);
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

/// Visits what the map's reader takes (map_svg_reader.cpp), in the order of the document.
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

}  // namespace
}  // namespace decode

Result<SvgSurvey> survey_svg(std::string_view text) {
    pugi::xml_document document;
    const pugi::xml_node root = document.load_buffer(text.data(), text.size())
                                    ? decode::child_named(document, "svg")
                                    : pugi::xml_node();
    if (!root) return failure("the picture is no SVG; save it again as SVG");
    SvgSurvey made{decode::languages_of(root, "title"), decode::languages_of(root, "desc"), {}};
    decode::LineCounter lines(text);
    decode::survey(root, 0, lines, made);
    return made;
}

bool speaks(const SaidLanguages& said, std::string_view language, std::string_view untagged) {
    return std::any_of(said.begin(), said.end(), [&](const std::string& tag) {
        return decode::language_in(tag.empty() ? untagged : std::string_view(tag)) ==
               decode::language_in(language);
    });
}

int xml_error_line(std::string_view text) {
    pugi::xml_document document;
    const auto parsed = document.load_buffer(text.data(), text.size());
    return parsed ? 0 : decode::LineCounter(text).line_at(parsed.offset);
}

}  // namespace touchline
