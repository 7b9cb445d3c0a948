#include "app/decode/svg_shapes.h"

#include "app/decode/svg_scanner.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace touchline::decode {
namespace {

/// Reads the lengths of one element, and remembers the first bad one.
class Lengths {
  public:
    explicit Lengths(const pugi::xml_node& element) : element_(element) {}

    std::optional<double> find(const char* name) {
        const pugi::xml_attribute attribute = element_.attribute(name);
        if (!attribute || std::string_view(attribute.value()) == "auto") return std::nullopt;
        const auto length = parse_svg_length(attribute.value());
        if (!length && result_) {
            result_ = failure(fmt::format("{} is no finite length in millimetres", name));
        }
        return length;
    }

    double operator()(const char* name) { return find(name).value_or(0.0); }

    [[nodiscard]] const Result<void>& result() const { return result_; }

  private:
    pugi::xml_node element_;
    Result<void> result_;
};

Result<void> draw_points(const char* points, bool is_closed, SvgTracer& tracer) {
    SvgScanner scanner(points);
    scanner.skip_space();
    for (bool is_first = true; !scanner.is_at_end(); is_first = false) {
        const auto x = scanner.take_number();
        const auto y = x ? scanner.take_number() : x;
        if (!y) {
            return failure(fmt::format("at character {} of points: pairs of finite numbers needed",
                                       scanner.position() + 1));
        }
        if (is_first) {
            tracer.move_to({*x, *y});
        } else {
            tracer.line_to({*x, *y});
        }
    }
    if (is_closed) tracer.close();
    return {};
}

Result<void> draw_line(const pugi::xml_node& element, SvgTracer& tracer) {
    Lengths length(element);
    tracer.move_to({length("x1"), length("y1")});
    tracer.line_to({length("x2"), length("y2")});
    return length.result();
}

/// Draws the rectangle as SVG defines it: from the left end of the upper side, clockwise on the
/// screen.
Result<void> draw_rectangle(const pugi::xml_node& element, SvgTracer& tracer) {
    Lengths length(element);
    const double x = length("x");
    const double y = length("y");
    const double width = length("width");
    const double height = length("height");
    const auto given_rx = length.find("rx");
    const auto given_ry = length.find("ry");
    if (!(width > 0.0 && height > 0.0)) return length.result();
    const double rx = std::clamp(given_rx.value_or(given_ry.value_or(0.0)), 0.0, width / 2.0);
    const double ry = std::clamp(given_ry.value_or(given_rx.value_or(0.0)), 0.0, height / 2.0);
    const double right = x + width;
    const double bottom = y + height;
    const auto corner = [&](UserPoint to) { tracer.arc_to(rx, ry, 0.0, false, true, to); };
    tracer.move_to({x + rx, y});
    tracer.line_to({right - rx, y});
    corner({right, y + ry});
    tracer.line_to({right, bottom - ry});
    corner({right - rx, bottom});
    tracer.line_to({x + rx, bottom});
    corner({x, bottom - ry});
    tracer.line_to({x, y + ry});
    corner({x + rx, y});
    tracer.close();
    return length.result();
}

Result<void> draw_ellipse(const pugi::xml_node& element, const char* name_rx, const char* name_ry,
                          SvgTracer& tracer) {
    Lengths length(element);
    const double x = length("cx");
    const double y = length("cy");
    const double rx = length(name_rx);
    const double ry = length(name_ry);
    if (!(rx > 0.0 && ry > 0.0)) return length.result();
    tracer.move_to({x + rx, y});
    tracer.arc_to(rx, ry, 0.0, false, true, {x - rx, y});
    tracer.arc_to(rx, ry, 0.0, false, true, {x + rx, y});
    tracer.close();
    return length.result();
}

}  // namespace

std::optional<Result<void>> draw_shape(const pugi::xml_node& element, std::string_view name,
                                       SvgTracer& tracer) {
    if (name == "path") return draw_path(element.attribute("d").value(), tracer);
    if (name == "polyline") return draw_points(element.attribute("points").value(), false, tracer);
    if (name == "polygon") return draw_points(element.attribute("points").value(), true, tracer);
    if (name == "line") return draw_line(element, tracer);
    if (name == "rect") return draw_rectangle(element, tracer);
    if (name == "circle") return draw_ellipse(element, "r", "r", tracer);
    if (name == "ellipse") return draw_ellipse(element, "rx", "ry", tracer);
    return std::nullopt;
}

}  // namespace touchline::decode
