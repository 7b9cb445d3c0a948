#include "app/decode/svg_nodes.h"

#include <algorithm>
#include <array>
#include <limits>

namespace touchline::decode {
namespace {

constexpr std::string_view space = " \t\r\n";

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(space);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(space) - first + 1);
}

}  // namespace

std::string_view local_name(const pugi::xml_node& element) {
    const std::string_view name = element.name();
    const auto colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

bool is_shape(std::string_view name) {
    constexpr std::array<std::string_view, 7> shapes{"path", "polyline", "polygon", "line",
                                                     "rect", "circle",   "ellipse"};
    return std::find(shapes.begin(), shapes.end(), name) != shapes.end();
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

}  // namespace touchline::decode
