#include "app/decode/map_svg.h"
#include "app/decode/svg_shapes.h"
#include "config/types/map_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace touchline::decode {
namespace {

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
        const Arc arc = arc_between(pen_, to, radii, rotation_deg * std::numbers::pi / 180.0,
                                    is_large, is_sweeping);
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
