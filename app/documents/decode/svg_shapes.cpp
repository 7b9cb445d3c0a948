#include "app/documents/decode/svg_shapes.h"

#include "app/documents/decode/map_svg.h"
#include "config/types/angle.h"
#include "config/types/map_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

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

constexpr std::string_view commands = "MLHVCSQTAZ";
constexpr std::array<std::size_t, 10> argument_counts{2, 2, 1, 1, 6, 4, 4, 2, 7, 0};

char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

class PathReader {
  public:
    PathReader(std::string_view d, SvgTracer& tracer) : scanner_(d), tracer_(tracer) {}

    Result<void> read() {
        scanner_.skip_space();
        while (!scanner_.is_at_end()) {
            if (auto taken = take_command(); !taken) return taken;
            if (auto taken = take_arguments(); !taken) return taken;
            draw();
            previous_ = upper(command_);
        }
        return {};
    }

  private:
    Result<void> wrong(std::string_view what) const {
        return failure(fmt::format("at character {} of d: {}", scanner_.position() + 1, what));
    }

    /// Takes a letter, or repeats the last one; a move is followed by lines.
    Result<void> take_command() {
        const char next = scanner_.peek();
        if (commands.find(upper(next)) != std::string_view::npos) {
            command_ = scanner_.take();
            scanner_.skip_space();
        } else if (previous_ == '\0' || previous_ == 'Z') {
            return wrong("a command is missing");
        } else if (command_ == 'M' || command_ == 'm') {
            command_ = command_ == 'M' ? 'L' : 'l';
        }
        if (previous_ == '\0' && upper(command_) != 'M') return wrong("a path begins with M");
        return {};
    }

    Result<void> take_arguments() {
        const bool is_arc = upper(command_) == 'A';
        const std::size_t count = argument_counts[commands.find(upper(command_))];
        for (std::size_t i = 0; i < count; ++i) {
            const bool is_flag = is_arc && (i == 3 || i == 4);
            const auto number = is_flag ? scanner_.take_flag() : scanner_.take_number();
            if (!number) {
                return wrong(fmt::format("{} needs {} finite numbers at a time", command_, count));
            }
            arguments_[i] = *number;
        }
        return {};
    }

    [[nodiscard]] UserPoint point(std::size_t i) const {
        return origin() + UserPoint{arguments_[i], arguments_[i + 1]};
    }

    /// The origin of the numbers: the pen for a small letter.
    [[nodiscard]] UserPoint origin() const {
        return command_ == upper(command_) ? UserPoint{} : tracer_.pen();
    }

    /// The last control point, mirrored at the pen, if the last command was such a curve.
    [[nodiscard]] UserPoint mirrored_control(std::string_view after) const {
        const bool continues = after.find(previous_) != std::string_view::npos;
        return continues ? 2.0 * tracer_.pen() - control_ : tracer_.pen();
    }

    void draw_quadratic(UserPoint control, UserPoint to) {
        control_ = control;
        tracer_.quadratic_to(control, to);
    }

    void draw_cubic(UserPoint control_1, UserPoint control_2, UserPoint to) {
        control_ = control_2;
        tracer_.cubic_to(control_1, control_2, to);
    }

    void draw() {
        const auto& v = arguments_;
        switch (upper(command_)) {
            case 'M':
                return tracer_.move_to(point(0));
            case 'L':
                return tracer_.line_to(point(0));
            case 'H':
                return tracer_.line_to({origin().x + v[0], tracer_.pen().y});
            case 'V':
                return tracer_.line_to({tracer_.pen().x, origin().y + v[0]});
            case 'C':
                return draw_cubic(point(0), point(2), point(4));
            case 'S':
                return draw_cubic(mirrored_control("CS"), point(0), point(2));
            case 'Q':
                return draw_quadratic(point(0), point(2));
            case 'T':
                return draw_quadratic(mirrored_control("QT"), point(0));
            case 'A':
                return tracer_.arc_to(v[0], v[1], v[2], v[3] != 0.0, v[4] != 0.0, point(5));
            default:
                return tracer_.close();
        }
    }

    SvgScanner scanner_;
    SvgTracer& tracer_;
    char command_ = '\0';
    char previous_ = '\0';  // in capitals; 0 before the first
    std::array<double, 7> arguments_{};
    UserPoint control_;
};

/// Ends nearer than this meet: sums of relative steps miss by rounding, and the grid for writing
/// maps is ten times coarser.
constexpr double meeting_mm = 1e-7;

/// The number of equal parts of the parameter that keep a curve within the tolerance of its chords:
/// the chord's error is at most max|B''| / (8 n^2).
double parts_for(double second_derivative_mm) {
    return std::max(1.0,
                    std::ceil(std::sqrt(second_derivative_mm / (8.0 * flattening_tolerance_mm))));
}

/// The angle whose chord stays within the tolerance of a circle.
double step_for(double radius_mm) {
    if (!(radius_mm > flattening_tolerance_mm)) return std::numbers::pi / 2.0;
    return 2.0 * std::acos(1.0 - flattening_tolerance_mm / radius_mm);
}

/// An arc by its centre; its angles are in the ellipse's own parameter.
struct Arc {
    UserPoint centre;
    UserPoint axis_x;  // from the centre to the point at angle 0
    UserPoint axis_y;  // from the centre to the point a quarter turn on
    double begin_rad = 0.0;
    double sweep_rad = 0.0;

    [[nodiscard]] UserPoint at(double angle_rad) const {
        return centre + std::cos(angle_rad) * axis_x + std::sin(angle_rad) * axis_y;
    }
};

/// SVG 1.1, F.6.5 and F.6.6; the radii are positive.
Arc arc_between(UserPoint from, UserPoint to, UserPoint radii, double rotation_rad, bool is_large,
                bool is_sweeping) {
    const UserPoint right{std::cos(rotation_rad), std::sin(rotation_rad)};
    const UserPoint half = 0.5 * (from - to);
    UserPoint on_circle{dot(half, right) / radii.x, cross(right, half) / radii.y};
    const double overlong = norm(on_circle);
    if (overlong > 1.0) {  // enlarges radii that do not reach
        radii = overlong * radii;
        on_circle = (1.0 / overlong) * on_circle;
    }
    const double length_squared = dot(on_circle, on_circle);
    const double aside = std::sqrt(std::max(0.0, 1.0 / length_squared - 1.0));
    const UserPoint centre_on_circle =
        (is_large == is_sweeping ? 1.0 : -1.0) * aside * left_of(on_circle);

    const UserPoint begin = on_circle - centre_on_circle;
    const UserPoint end = -on_circle - centre_on_circle;
    double sweep = std::atan2(end.y, end.x) - std::atan2(begin.y, begin.x);
    if (is_sweeping && sweep < 0.0) sweep += 2.0 * std::numbers::pi;
    if (!is_sweeping && sweep > 0.0) sweep -= 2.0 * std::numbers::pi;

    Arc arc;
    arc.axis_x = radii.x * right;
    arc.axis_y = radii.y * left_of(right);
    arc.centre =
        0.5 * (from + to) + centre_on_circle.x * arc.axis_x + centre_on_circle.y * arc.axis_y;
    arc.begin_rad = std::atan2(begin.y, begin.x);
    arc.sweep_rad = sweep;
    return arc;
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

Result<void> draw_path(std::string_view d, SvgTracer& tracer) {
    return PathReader(d, tracer).read();
}

void SvgTracer::move_to(UserPoint to) {
    end_subpath(false);
    start_ = pen_ = to;
}

void SvgTracer::line_to(UserPoint to) {
    begin_if_needed();
    add_end(to);
}

void SvgTracer::quadratic_to(UserPoint control, UserPoint to) {
    // The same parabola as a cubic.
    cubic_to(pen_ + (2.0 / 3.0) * (control - pen_), to + (2.0 / 3.0) * (control - to), to);
}

void SvgTracer::cubic_to(UserPoint control_1, UserPoint control_2, UserPoint to) {
    begin_if_needed();
    const UserPoint b0 = to_view_box_(pen_);
    const UserPoint b1 = to_view_box_(control_1);
    const UserPoint b2 = to_view_box_(control_2);
    const UserPoint b3 = to_view_box_(to);
    const double parts =
        parts_for(6.0 * std::max(norm(b0 - 2.0 * b1 + b2), norm(b1 - 2.0 * b2 + b3)));
    if (!can_add(parts)) return;
    const int count = static_cast<int>(parts);  // can_add: at most max_map_points
    for (int i = 1; i < count; ++i) {
        const double t = i / parts;
        const double s = 1.0 - t;
        add_computed((s * s * s) * b0 + (3.0 * s * s * t) * b1 + (3.0 * s * t * t) * b2 +
                     (t * t * t) * b3);
    }
    add_end(to);
}

void SvgTracer::arc_to(double radius_x, double radius_y, double rotation_deg, bool is_large,
                       bool is_sweeping, UserPoint to) {
    begin_if_needed();
    const UserPoint radii{std::abs(radius_x), std::abs(radius_y)};
    if (to == pen_) return;
    if (radii.x > 0.0 && radii.y > 0.0) {
        const Arc arc = arc_between(pen_, to, radii, radians(rotation_deg), is_large, is_sweeping);
        const double radius_mm =
            std::max(norm(arc.axis_x), norm(arc.axis_y)) * to_view_box_.stretch();
        const double parts = std::ceil(std::abs(arc.sweep_rad) / step_for(radius_mm));
        if (!can_add(parts)) return;
        const int count = static_cast<int>(parts);
        for (int i = 1; i < count; ++i) {
            add_computed(to_view_box_(arc.at(arc.begin_rad + arc.sweep_rad * (i / parts))));
        }
    }
    add_end(to);
}

void SvgTracer::close() {
    end_subpath(true);
    pen_ = start_;
}

std::vector<Subpath> SvgTracer::take() {
    end_subpath(false);
    return std::move(done_);
}

bool SvgTracer::can_add(double count) {
    is_good_ = is_good_ && count <= static_cast<double>(points_left_);  // false for NaN as well
    return is_good_;
}

void SvgTracer::begin_if_needed() {
    if (is_open_) return;
    is_open_ = true;
    add_end(pen_);
}

void SvgTracer::add_end(UserPoint to) {
    pen_ = to;
    if (is_exact_) {
        add(to);
    } else {
        add_computed(to_view_box_(to));
    }
}

void SvgTracer::add_computed(UserPoint in_view_box) {
    add({on_nanometre_grid_mm(in_view_box.x), on_nanometre_grid_mm(in_view_box.y)});
}

void SvgTracer::add(UserPoint in_view_box) {
    if (!subpath_.points.empty() && subpath_.points.back() == in_view_box) return;
    if (!is_finite(in_view_box) || !can_add(1.0)) {
        is_good_ = false;
        return;
    }
    --points_left_;
    subpath_.points.push_back(in_view_box);
}

void SvgTracer::end_subpath(bool is_closed) {
    is_open_ = false;
    Subpath subpath = std::exchange(subpath_, {});
    auto& points = subpath.points;
    const bool meets = points.size() > 2 && norm(points.back() - points.front()) <= meeting_mm;
    if (meets) points.pop_back();
    subpath.is_closed = (is_closed || meets) && points.size() > 2;
    if (points.size() > 1) done_.push_back(std::move(subpath));
}

}  // namespace touchline::decode
