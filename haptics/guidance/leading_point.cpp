#include "haptics/guidance/leading_point.h"

#include <algorithm>

namespace touchline {
namespace {

constexpr int most_edges = 64;

const Leg& leg_at(const Scene& scene, int leg) {
    return scene.legs[static_cast<std::size_t>(leg)];
}

Position point_at(const Scene& scene, const Leg& leg, int point) {
    const auto points = scene.curves.points(leg.piece, 0);
    return points[static_cast<std::size_t>(point) % points.size()];
}

}  // namespace

void LeadingPoint::go_straight(Position to, double speed_m_per_s) {
    from_ = position_;
    to_ = to;
    profile_ = SpeedProfile(norm(to - from_), speed_m_per_s);
    t_s_ = gone_m_ = 0.0;
    has_arrived_ = false;
    is_straight_ = true;
}

void LeadingPoint::go_along(const Scene& scene, int leg, double speed_m_per_s) {
    const Leg& first = leg_at(scene, leg);
    profile_ = SpeedProfile(first.run_m, speed_m_per_s);
    t_s_ = gone_m_ = 0.0;
    has_arrived_ = false;
    is_straight_ = false;
    leg_ = leg;
    point_ = first.first;
    on_edge_m_ = 0.0;
}

void LeadingPoint::step(const Scene& scene, double dt_s) {
    if (has_arrived_) return;
    t_s_ += dt_s;
    const bool is_over = t_s_ >= profile_.duration_s();
    const double way_m = profile_.gone_m(t_s_);
    if (is_straight_) {
        const double whole_m = norm(to_ - from_);
        has_arrived_ = is_over;
        position_ = is_over ? to_ : from_ + way_m / whole_m * (to_ - from_);
        return;
    }
    // At the end goes a trace beyond the length, which was summed in another order.
    constexpr double trace_m = 1e-6;
    walk(scene, way_m - gone_m_ + (is_over ? trace_m : 0.0));
}

void LeadingPoint::walk(const Scene& scene, double way_m) {
    for (int edges = 0; edges < most_edges && way_m > 0.0; ++edges) {
        const Leg& leg = leg_at(scene, leg_);
        const Position a = point_at(scene, leg, point_);
        const Position b = point_at(scene, leg, point_ + 1);
        const double length_m = norm(b - a);
        const double left_m = length_m - on_edge_m_;
        if (way_m < left_m) {
            on_edge_m_ += way_m;
            gone_m_ += way_m;
            position_ = a + on_edge_m_ / length_m * (b - a);
            return;
        }
        way_m -= left_m;
        gone_m_ += left_m;
        on_edge_m_ = 0.0;
        position_ = b;
        if (++point_ < leg.last) continue;
        has_arrived_ = leg.rests_at_end;
        if (has_arrived_) return;
        point_ = leg_at(scene, ++leg_).first;
    }
}

bool LeadingPoint::fits(const Scene& scene) const {
    if (has_arrived_ || is_straight_) return leg_ < static_cast<int>(scene.legs.size());
    if (leg_ < 0 || leg_ >= static_cast<int>(scene.legs.size())) return false;
    const Leg& leg = leg_at(scene, leg_);
    return point_ >= leg.first && point_ < leg.last;
}

}  // namespace touchline
