#include "app/decode/map_svg.h"

#include <array>
#include <charconv>
#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

namespace touchline {
namespace {

void append_number(std::string& text, double value) {
    std::array<char, 32> digits{};  // the longest double takes 24
    text.append(digits.data(), std::to_chars(digits.begin(), digits.end(), value).ptr);
}

void set(pugi::xml_node node, const char* name, const std::string& value) {
    node.append_attribute(name).set_value(value.c_str());
}

void append_text(pugi::xml_node parent, const char* name, const std::string& text) {
    if (!text.empty()) parent.append_child(name).text().set(text.c_str());
}

void append_outline(pugi::xml_node parent, const Outline& outline, const ViewBox& box) {
    pugi::xml_node path = parent.append_child("path");
    if (!outline.id.empty()) set(path, "id", outline.id);
    if (!outline.label.empty()) set(path, "data-label", outline.label);
    set(path, "data-weight", svg_number(outline.weight));
    set(path, "data-detail", std::to_string(outline.detail));
    set(path, "d", path_data(outline.points, outline.is_closed, box));
}

void append_label(pugi::xml_node parent, const Label& label, const ViewBox& box) {
    pugi::xml_node text = parent.append_child("text");
    const ViewBoxPoint place = to_view_box(label.place, box);
    set(text, "data-label", "1");
    set(text, "x", svg_number(place.u_mm));
    set(text, "y", svg_number(place.v_mm));
    text.text().set(label.text.c_str());
}

}  // namespace

std::string svg_number(double value) {
    std::string text;
    append_number(text, value);
    return text;
}

std::string path_data(std::span<const Position> points, bool is_closed, const ViewBox& box) {
    std::string d;
    for (const Position point : points) {
        d += d.empty() ? "M" : " L";
        const ViewBoxPoint written = to_view_box(point, box);
        append_number(d, written.u_mm);
        d += ' ';
        append_number(d, written.v_mm);
    }
    if (is_closed) d += " Z";
    return d;
}

std::string format_map_svg(const TactileMap& map) {
    const ViewBox box = view_box_of(map.area);
    const std::string width = svg_number(box.width_mm);
    const std::string height = svg_number(box.height_mm);
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    set(declaration, "version", "1.0");
    set(declaration, "encoding", "UTF-8");
    pugi::xml_node root = document.append_child("svg");
    set(root, "xmlns", "http://www.w3.org/2000/svg");
    set(root, "width", width + "mm");
    set(root, "height", height + "mm");
    set(root, "viewBox", fmt::format("0 0 {} {}", width, height));
    append_text(root, "title", map.title);
    append_text(root, "desc", map.description);

    pugi::xml_node lines = root.append_child("g");
    set(lines, "fill", "none");
    set(lines, "stroke", "black");
    set(lines, "stroke-width", "0.6");
    set(lines, "stroke-linecap", "round");
    set(lines, "stroke-linejoin", "round");
    for (const Outline& outline : map.outlines) append_outline(lines, outline, box);
    if (!map.labels.empty()) {
        pugi::xml_node words = root.append_child("g");
        set(words, "font-family", "sans-serif");
        set(words, "font-size", "4");
        for (const Label& label : map.labels) append_label(words, label, box);
    }
    std::ostringstream text;
    document.save(text, "  ");
    return text.str();
}

}  // namespace touchline
