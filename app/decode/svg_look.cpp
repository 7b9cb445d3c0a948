#include "app/decode/svg_look.h"

#include "app/decode/map_svg.h"
#include "app/decode/svg_nodes.h"
#include "app/decode/svg_shapes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace touchline::decode {
namespace {

constexpr std::size_t most_shapes = 2000;
constexpr std::size_t most_points_of_a_shape = 100'000;

/// What children take over from their parents.
struct Paint {
    std::string_view fill = "black";
    std::string_view stroke = "none";
};

struct Box {
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
    double bottom = 0.0;

    [[nodiscard]] bool meets(const Box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

template <std::size_t count>
bool is_one_of(std::string_view name, const std::array<std::string_view, count>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_nothing(std::string_view paint) {
    return paint == "none" || paint == "transparent";
}

bool is_white(std::string_view paint) {
    constexpr std::array<std::string_view, 8> whites{
        "white",   "#fff",    "#ffffff",          "#FFF",
        "#FFFFFF", "#fffFFF", "rgb(255,255,255)", "rgb(100%,100%,100%)"};
    return is_one_of(paint, whites);
}

/// Properties that change what is seen of a shape.
bool is_plain(const pugi::xml_node& element) {
    for (const char* name : {"clip-path", "mask", "filter", "marker-start", "marker-mid",
                             "marker-end", "marker", "mix-blend-mode"}) {
        const auto value = property_of(element, name);
        if (!value.empty() && value != "none" && value != "normal") return false;
    }
    for (const char* name : {"opacity", "fill-opacity", "stroke-opacity"})
        if (const auto value = property_of(element, name); !value.empty() && value != "1")
            return false;
    const auto visibility = property_of(element, "visibility");
    return (visibility.empty() || visibility == "visible") && !element.attribute("class");
}

std::optional<Box> box_of(const pugi::xml_node& element, const Affine& transform) {
    SvgTracer tracer(transform, most_points_of_a_shape);
    const auto drawn = draw_shape(element, local_name(element), tracer);
    if (!drawn || !*drawn || !tracer.is_good()) return std::nullopt;
    std::optional<Box> box;
    for (const Subpath& subpath : tracer.take())
        for (const UserPoint p : subpath.points) {
            if (!box) box = Box{p.x, p.y, p.x, p.y};
            box->left = std::min(box->left, p.x);
            box->top = std::min(box->top, p.y);
            box->right = std::max(box->right, p.x);
            box->bottom = std::max(box->bottom, p.y);
        }
    return box ? box : Box{};
}

class Look {
  public:
    explicit Look(const ViewBox& box) : box_(box) {}

    bool is_of_lines(const pugi::xml_node& parent, const Affine& transform, Paint paint,
                     int depth) {
        if (depth > max_nesting) return false;
        for (const pugi::xml_node& element : parent.children()) {
            if (element.type() != pugi::node_element || is_hidden(element)) continue;
            if (!takes(element, transform, paint, depth)) return false;
        }
        return true;
    }

  private:
    static constexpr std::array<std::string_view, 5> never_drawn{"title", "desc", "metadata",
                                                                 "defs", "namedview"};
    static constexpr std::array<std::string_view, 7> shapes{"path", "polyline", "polygon", "line",
                                                            "rect", "circle",   "ellipse"};

    bool takes(const pugi::xml_node& element, const Affine& outer, Paint paint, int depth) {
        const std::string_view name = local_name(element);
        if (name == "defs") return !child_named(element, "style");
        if (is_one_of(name, never_drawn)) return true;
        const auto own = parse_svg_transform(element.attribute("transform").value());
        if (!own || !is_plain(element)) return false;
        if (const auto fill = property_of(element, "fill"); !fill.empty()) paint.fill = fill;
        if (const auto stroke = property_of(element, "stroke"); !stroke.empty())
            paint.stroke = stroke;
        const Affine transform = outer * *own;
        if (name == "g" || name == "a") return is_of_lines(element, transform, paint, depth + 1);
        if (name == "text") return true;  // a label
        return is_one_of(name, shapes) && takes_shape(element, transform, paint);
    }

    /// A shape is seen, or is the paper; a filled one must not cover another.
    bool takes_shape(const pugi::xml_node& element, const Affine& transform, const Paint& paint) {
        const auto box = box_of(element, transform);
        if (!box || boxes_.size() >= most_shapes) return false;
        const bool is_filled = !is_nothing(paint.fill) && local_name(element) != "line";
        if (is_filled && (is_white(paint.fill) || is_whole(*box))) return false;
        if (!is_filled && (is_nothing(paint.stroke) || is_white(paint.stroke))) return false;
        if (paint.fill.starts_with("url") || paint.stroke.starts_with("url")) return false;
        const auto is_covered = [&box](const Box& other) { return box->meets(other); };
        if (is_filled && std::any_of(boxes_.begin(), boxes_.end(), is_covered)) return false;
        boxes_.push_back(*box);
        return true;
    }

    [[nodiscard]] bool is_whole(const Box& box) const {
        return box.left <= box_.x0_mm && box.top <= box_.y0_mm &&
               box.right >= box_.x0_mm + box_.width_mm && box.bottom >= box_.y0_mm + box_.height_mm;
    }

    ViewBox box_;
    std::vector<Box> boxes_;
};

}  // namespace

bool is_line_drawing(const pugi::xml_node& root, const ViewBox& box) {
    Paint paint;
    if (const auto fill = property_of(root, "fill"); !fill.empty()) paint.fill = fill;
    if (const auto stroke = property_of(root, "stroke"); !stroke.empty()) paint.stroke = stroke;
    return is_plain(root) && Look(box).is_of_lines(root, Affine{}, paint, 0);
}

}  // namespace touchline::decode
