#include "app/documents/decode/map_svg.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/one_line.h"
#include "app/documents/decode/svg_nodes.h"
#include "app/documents/decode/svg_shapes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <exception>
#include <sstream>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>
#include <pugixml.hpp>

namespace touchline {
namespace decode {
namespace {

/// A digit from 1 to 5, and nothing else.
std::optional<int> grade_of(std::string_view text) {
    if (text.size() != 1 || text[0] < '1' || text[0] > '5') return std::nullopt;
    return text[0] - '0';
}

class MapReader {
  public:
    MapReader(const ViewBox& box, const LanguageTag& language) : box_(box), language_(language) {
        map_.area = area_of(box);
    }

    Result<TactileMap> read(const pugi::xml_node& root) {
        map_.title = words_in(root, "title", language_);
        map_.description = words_in(root, "desc", language_);
        if (auto walked = walk(root, {}, 0); !walked) return tl::unexpected(walked.error());
        if (map_.outlines.empty())
            return failure("the map holds no outline; draw at least one <path>");
        return std::move(map_);
    }

  private:
    Result<void> walk(const pugi::xml_node& parent, const Affine& to_view_box, int depth) {
        if (depth > max_nesting)
            return failure(
                fmt::format("the map nests groups more than {} deep; ungroup them", max_nesting));
        for (const pugi::xml_node& element : parent.children()) {
            if (element.type() != pugi::node_element || is_hidden(element)) continue;
            if (auto taken = take(element, to_view_box, depth); !taken) return taken;
        }
        return {};
    }

    Result<void> take(const pugi::xml_node& element, const Affine& to_view_box, int depth) {
        const auto own = parse_svg_transform(element.attribute("transform").value());
        if (!own) return wrong(element, "its transform cannot be read");
        const Affine transform = to_view_box * *own;
        const std::string_view name = local_name(element);
        if (name == "g" || name == "a" || name == "svg") return walk(element, transform, depth + 1);
        if (name == "text") return take_label(element, transform);

        SvgTracer tracer(transform, points_left_);
        const auto drawn = draw_shape(element, name, tracer);
        if (!drawn) return {};
        if (!*drawn) return wrong(element, drawn->error().line);
        if (!tracer.is_good())
            return wrong(element, fmt::format("its points are not finite, or the map has more "
                                              "than {}",
                                              max_map_points));
        return take_outlines(element, tracer.take());
    }

    Result<void> take_outlines(const pugi::xml_node& element,
                               const std::vector<Subpath>& subpaths) {
        Outline common;
        common.label = words_of_shape(element, language_);
        if (const auto weight = element.attribute("data-weight")) {
            const auto value = parse_svg_length(weight.value());
            if (!value || !(*value > 0.0)) return wrong(element, "data-weight must be above 0");
            common.weight = *value;
        }
        if (const auto detail = element.attribute("data-detail")) {
            const auto grade = grade_of(detail.value());
            if (!grade) return wrong(element, "data-detail must be 1, 2, 3, 4 or 5");
            common.detail = *grade;
        }
        for (const Subpath& subpath : subpaths) {
            Outline outline = common;
            outline.id = unique_id(element.attribute("id").value());
            outline.is_closed = subpath.is_closed;
            outline.points.reserve(subpath.points.size());
            for (const UserPoint p : subpath.points) {
                outline.points.push_back(from_view_box(p.x, p.y, box_));
                if (!is_finite(outline.points.back())) return wrong(element, "it is too large");
            }
            points_left_ -= subpath.points.size();
            map_.outlines.push_back(std::move(outline));
        }
        return {};
    }

    Result<void> take_label(const pugi::xml_node& element, const Affine& transform) {
        std::string text = words_of_text(element, language_);
        if (text.empty()) return {};
        const auto coordinate = [&](const char* name) -> std::optional<double> {
            const pugi::xml_attribute attribute = element.attribute(name);
            if (!attribute) return 0.0;
            SvgScanner scanner(attribute.value());  // the first of a list is where the text begins
            scanner.skip_space();
            return scanner.take_number();
        };
        const auto x = coordinate("x");
        const auto y = coordinate("y");
        if (!x || !y) return wrong(element, "its place is not finite");
        UserPoint place{*x, *y};
        if (transform != Affine{}) {
            place = transform(place);
            place = {on_nanometre_grid_mm(place.x), on_nanometre_grid_mm(place.y)};
        }
        const Position p_W = from_view_box(place.x, place.y, box_);
        if (!is_finite(p_W)) return wrong(element, "its place is not finite");
        map_.labels.push_back({std::move(text), p_W});
        return {};
    }

    std::string unique_id(const std::string& wished) {
        if (wished.empty()) return wished;
        std::string id = wished;
        // Counts on from the last suffix, so that a thousand equal ids take linear time.
        for (int& used = uses_[wished]; !ids_.insert(id).second;) {
            used = std::max(used, 1) + 1;
            id = fmt::format("{}-{}", wished, used);
        }
        return id;
    }

    static tl::unexpected<Error> wrong(const pugi::xml_node& element, std::string_view what) {
        const std::string_view id = element.attribute("id").value();
        return failure(fmt::format("the map's <{}>{}{} cannot be used: {}; correct it",
                                   one_line(element.name()), id.empty() ? "" : " ", one_line(id),
                                   one_line(what)));
    }

    ViewBox box_;
    LanguageTag language_;
    TactileMap map_;
    std::size_t points_left_ = max_map_points;
    std::unordered_set<std::string> ids_;
    std::unordered_map<std::string, int> uses_;  // the last suffix given to an id
};

Result<ViewBox> view_box_in(const pugi::xml_node& root) {
    constexpr auto advice = "write viewBox=\"0 0 WIDTH HEIGHT\" in millimetres in <svg>";
    const pugi::xml_attribute attribute = root.attribute("viewBox");
    if (!attribute) return failure(fmt::format("the map has no viewBox; {}", advice));
    SvgScanner scanner(attribute.value());
    scanner.skip_space();
    const auto x = scanner.take_number();
    const auto y = scanner.take_number();
    const auto width = scanner.take_number();
    const auto height = scanner.take_number();
    const bool is_valid =
        x && y && width && height && scanner.is_at_end() && *width > 0.0 && *height > 0.0;
    if (!is_valid)
        return failure(
            fmt::format("the map's viewBox \"{}\" is not four finite numbers with sizes "
                        "above 0; {}",
                        one_line(attribute.value()), advice));
    return ViewBox{*x, *y, *width, *height};
}

/// The root element; the reason if it is no SVG.
Result<pugi::xml_node> root_in(std::string_view text, pugi::xml_document& document) {
    if (text.empty()) return failure("the map is empty; copy it again");
    const auto parsed = document.load_buffer(text.data(), text.size());
    if (!parsed)
        return failure(fmt::format("the map is no XML: {} at byte {}; save it again as SVG",
                                   parsed.description(), parsed.offset));
    const pugi::xml_node root = child_named(document, "svg");
    if (!root) return failure("the map is XML but no SVG; save it again as SVG");
    return root;
}

Result<std::optional<int>> difficulty_in(std::string_view text) {
    pugi::xml_document document;
    const auto root = root_in(text, document);
    if (!root) return tl::unexpected(root.error());
    const auto attribute = root->attribute("data-difficulty");
    if (!attribute) return std::nullopt;
    const auto grade = grade_of(attribute.value());
    if (!grade) return failure("the map's data-difficulty must be 1, 2, 3, 4 or 5; correct it");
    return grade;
}

/// Only Touchline writes these attributes.
bool is_marked(const pugi::xml_node& root) {
    if (root.attribute("data-difficulty")) return true;
    return static_cast<bool>(
        root.find_node([](const pugi::xml_node& node) { return node.attribute("data-detail"); }));
}

/// `own`: takes only a map of Touchline's own, no larger than this.
Result<TactileMap> parse(std::string_view text, const LanguageTag& language, const Area* own) {
    pugi::xml_document document;
    const auto root = root_in(text, document);
    if (!root) return tl::unexpected(root.error());
    const auto box = view_box_in(*root);
    if (!box) return tl::unexpected(box.error());
    if (own != nullptr &&
        (!is_in_millimetres(*root, box->width_mm, box->height_mm, *own) || !is_marked(*root)))
        return failure("the SVG is a picture, no map");
    return MapReader(*box, language).read(*root);
}

Result<TactileMap> parse_or_say_why(std::string_view text, const LanguageTag& language,
                                    const Area* own) {
    try {
        return parse(text, language, own);
    } catch (const std::exception& problem) {
        return failure("the map cannot be read: " + one_line(problem.what()));
    }
}

}  // namespace
}  // namespace decode

Result<TactileMap> parse_map_svg(std::string_view text, const LanguageTag& language) {
    return decode::parse_or_say_why(text, language, nullptr);
}

Result<TactileMap> parse_own_map(std::string_view text, const Area& area,
                                 const LanguageTag& language) {
    return decode::parse_or_say_why(text, language, &area);
}

Result<std::optional<int>> difficulty_of_map_svg(std::string_view text) {
    return decode::difficulty_in(text);
}

SvgWords words_of_svg(std::string_view text, const LanguageTag& language) {
    pugi::xml_document document;
    const auto root = decode::root_in(text, document);
    if (!root) return {};
    return {decode::words_in(*root, "title", language), decode::words_in(*root, "desc", language)};
}

Result<TactileMap> read_map_svg(const std::string& path, const LanguageTag& language) {
    const auto bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    auto map = parse_map_svg(as_text(*bytes), language);
    if (!map) return failure(one_line(path) + ": " + map.error().line);
    return map;
}

namespace {

void append_number(std::string& text, double value) {
    std::array<char, 32> digits{};  // the longest double takes 24
    text.append(digits.data(), std::to_chars(digits.begin(), digits.end(), value).ptr);
}

void put(pugi::xml_node node, const char* name, const std::string& value) {
    node.append_attribute(name).set_value(value.c_str());
}

void append_text(pugi::xml_node parent, const char* name, const std::string& text) {
    if (!text.empty()) parent.append_child(name).text().set(text.c_str());
}

void append_outline(pugi::xml_node parent, const Outline& outline, const ViewBox& box) {
    pugi::xml_node path = parent.append_child("path");
    if (!outline.id.empty()) put(path, "id", outline.id);
    if (!outline.label.empty()) put(path, "data-label", outline.label);
    put(path, "data-weight", svg_number(outline.weight));
    put(path, "data-detail", std::to_string(outline.detail));
    put(path, "d", path_data(outline.points, outline.is_closed, box));
}

void append_label(pugi::xml_node parent, const Label& label, const ViewBox& box) {
    pugi::xml_node text = parent.append_child("text");
    const ViewBoxPoint place = to_view_box(label.place, box);
    put(text, "data-label", "1");
    put(text, "x", svg_number(place.u_mm));
    put(text, "y", svg_number(place.v_mm));
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
    put(declaration, "version", "1.0");
    put(declaration, "encoding", "UTF-8");
    pugi::xml_node root = document.append_child("svg");
    put(root, "xmlns", "http://www.w3.org/2000/svg");
    put(root, "width", width + "mm");
    put(root, "height", height + "mm");
    put(root, "viewBox", fmt::format("0 0 {} {}", width, height));
    append_text(root, "title", map.title);
    append_text(root, "desc", map.description);

    pugi::xml_node lines = root.append_child("g");
    put(lines, "fill", "none");
    put(lines, "stroke", "black");
    put(lines, "stroke-width", "0.6");
    put(lines, "stroke-linecap", "round");
    put(lines, "stroke-linejoin", "round");
    for (const Outline& outline : map.outlines) append_outline(lines, outline, box);
    if (!map.labels.empty()) {
        pugi::xml_node words = root.append_child("g");
        put(words, "font-family", "sans-serif");
        put(words, "font-size", "4");
        for (const Label& label : map.labels) append_label(words, label, box);
    }
    std::ostringstream text;
    document.save(text, "  ");
    return text.str();
}

}  // namespace touchline
