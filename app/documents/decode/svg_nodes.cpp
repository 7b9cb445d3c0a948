#include "app/documents/decode/svg_nodes.h"

#include "app/documents/decode/one_line.h"
#include "app/documents/decode/svg_numbers.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace touchline::decode {
namespace {

constexpr std::string_view space = " \t\r\n";

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(space);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(space) - first + 1);
}

/// Takes texts with their tags one by one and keeps the one that serves a language best: one with
/// the same tag, else of the same language ("de" for "de-AT" and the other way round), else without
/// a tag, else any. Among equals the first counts. Ignores the case of tags.
class BestWords {
  public:
    explicit BestWords(const LanguageTag& wanted)
        : wanted_(wanted.text.empty() ? LanguageTag{}.text : in_small_letters(wanted.text)) {}

    /// O(tag + text). Ignores an empty text.
    void offer(std::string_view tag, std::string text) {
        const int rank = rank_of(tag);
        if (text.empty() || rank <= rank_) return;
        best_ = std::move(text);
        rank_ = rank;
    }

    /// Offers every child of this name.
    void offer_children(const pugi::xml_node& parent, std::string_view name) {
        for (const pugi::xml_node& child : parent.children())
            if (child.type() == pugi::node_element && local_name(child) == name)
                offer(tag_of(child), text_of(child));
    }

    [[nodiscard]] std::string take() { return std::move(best_); }

  private:
    [[nodiscard]] int rank_of(std::string_view tag) const {
        if (tag.empty()) return 1;
        const std::string has = in_small_letters(tag);
        if (has == wanted_) return 3;
        return language_in(has) == language_in(wanted_) ? 2 : 0;
    }

    std::string wanted_;
    std::string best_;
    int rank_ = -1;
};

}  // namespace

std::string_view local_name(const pugi::xml_node& element) {
    const std::string_view name = element.name();
    const auto colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

bool is_shape(std::string_view name) {
    constexpr std::array<std::string_view, 7> shapes{"path", "polyline", "polygon", "line",
                                                     "rect", "circle",   "ellipse"};
    return std::ranges::find(shapes, name) != shapes.end();
}

pugi::xml_node svg_root_in(std::string_view text, pugi::xml_document& document) {
    if (!document.load_buffer(text.data(), text.size())) return {};
    return child_named(document, "svg");
}

bool is_in_millimetres(const pugi::xml_node& root, double width_mm, double height_mm,
                       const Area& area) {
    const std::string_view width = root.attribute("width").value();
    return width.ends_with("mm") &&
           parse_svg_length(width.substr(0, width.size() - 2)) == width_mm &&
           width_mm <= 1000.0 * area.width_m + 1e-9 && height_mm <= 1000.0 * area.height_m + 1e-9;
}

pugi::xml_node child_named(const pugi::xml_node& parent, std::string_view name) {
    return parent.find_child([&](const pugi::xml_node& child) {
        return child.type() == pugi::node_element && local_name(child) == name;
    });
}

void append_words(std::string& text, std::string_view more) {
    for (auto begin = more.find_first_not_of(space); begin != std::string_view::npos;) {
        const auto end = std::min(more.find_first_of(space, begin), more.size());
        if (!text.empty()) text += ' ';
        text += more.substr(begin, end - begin);
        begin = more.find_first_not_of(space, end);
    }
}

/// Walks without recursion, because the nesting comes from the file.
std::string text_of(pugi::xml_node element) {
    constexpr int nowhere = std::numeric_limits<int>::max();

    struct Collector : pugi::xml_tree_walker {
        bool for_each(pugi::xml_node& node) override {
            if (depth() > told_depth) return true;  // inside a title
            const std::string_view name = local_name(node);
            told_depth = name == "title" || name == "desc" ? depth() : nowhere;
            const bool is_text =
                node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
            if (is_text) append_words(text, node.value());
            return true;
        }

        std::string text;
        int told_depth = nowhere;
    } collector;

    element.traverse(collector);
    return std::move(collector.text);
}

std::string_view property_of(const pugi::xml_node& element, const char* name) {
    std::string_view style = element.attribute("style").value();
    while (!style.empty()) {
        const auto end = std::min(style.find(';'), style.size());
        const std::string_view entry = style.substr(0, end);
        const auto colon = entry.find(':');
        if (colon != std::string_view::npos && trimmed(entry.substr(0, colon)) == name)
            return trimmed(entry.substr(colon + 1));
        style.remove_prefix(std::min(end + 1, style.size()));
    }
    return trimmed(element.attribute(name).value());
}

bool is_hidden(const pugi::xml_node& element) {
    return property_of(element, "display").starts_with("none");
}

std::string_view tag_of(const pugi::xml_node& element) {
    const auto attribute = element.attribute("xml:lang");
    return attribute ? attribute.value() : element.attribute("lang").value();
}

std::string words_in(const pugi::xml_node& parent, std::string_view name,
                     const LanguageTag& language) {
    BestWords best(language);
    best.offer_children(parent, name);
    return best.take();
}

std::string words_of_shape(const pugi::xml_node& shape, const LanguageTag& language) {
    std::string label;
    append_words(label, shape.attribute("data-label").value());
    BestWords best(language);
    best.offer({}, std::move(label));
    best.offer_children(shape, "title");
    return best.take();
}

std::string words_of_text(const pugi::xml_node& text, const LanguageTag& language) {
    BestWords best(language);
    best.offer(tag_of(text), text_of(text));
    best.offer_children(text, "title");
    return best.take();
}

}  // namespace touchline::decode
