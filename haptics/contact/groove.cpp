#include "haptics/contact/groove.h"

#include <cmath>

namespace touchline {
namespace {

constexpr double handover_margin_m = 2e-4;
constexpr int walks = 256;

Foot foot_on(const Scene& scene, double level, Position handle, SegmentRef segment) {
    return foot(handle, scene.curves.rendered_segment(segment.piece, level, segment.index));
}

/// The nearest point reached by walking along the outline while the distance falls.
Closest follow(const Scene& scene, double level, Position handle, const GrooveState& state) {
    SegmentRef at = state.segment;
    Foot best = foot_on(scene, level, handle, at);
    for (int walk = 0; walk < walks; ++walk) {
        bool is_nearer = false;
        for (const SegmentRef next :
             {scene.curves.next(at, level), scene.curves.previous(at, level)}) {
            if (next.piece < 0) continue;
            const Foot there = foot_on(scene, level, handle, next);
            if (there.distance_m < best.distance_m) {
                best = there;
                at = next;
                is_nearer = true;
                break;
            }
        }
        if (!is_nearer) break;
    }
    return {at, best.parameter, best.point, best.distance_m, 0, true};
}

double profile_N(const ContactSettings& settings, double distance_m) {
    const double share = distance_m / settings.capture_m;
    if (!(share < 1.0)) return 0.0;
    const double pull_N = settings.stiffness_N_per_m * distance_m;
    if (settings.mode == Mode::stay) return pull_N * (1.0 - std::pow(share, 8));
    const double fade = 1.0 - share * share;
    return (settings.mode == Mode::ridge ? -1.0 : 1.0) * pull_N * fade * fade;
}

}  // namespace

GrooveForce groove_step(const Scene& scene, double level, Position handle,
                        const ContactSettings& settings, const Budget& budget, GrooveState& state) {
    Closest attached;
    attached.distance_m = settings.capture_m;
    const bool is_known =
        state.segment.piece >= 0 &&
        state.segment.index < scene.curves.rendered_count(state.segment.piece, level);
    if (is_known) attached = follow(scene, level, handle, state);
    const bool is_held = is_known && attached.distance_m < settings.capture_m;
    const double within = is_held ? attached.distance_m - handover_margin_m : settings.capture_m;
    const Closest other = scene.tree.closest_point(scene.curves, handle, level, within, budget);
    if (other.segment.piece >= 0) attached = other;
    const bool is_attached = is_held || other.segment.piece >= 0;
    state = is_attached ? GrooveState{attached.segment, attached.parameter} : GrooveState{};
    if (!is_attached) return {{}, handle, 0.0, Side::left, other.boxes, other.is_complete};
    const Segment s =
        scene.curves.rendered_segment(attached.segment.piece, level, attached.segment.index);
    const Side side = cross(s.b - s.a, handle - attached.point) < 0.0 ? Side::right : Side::left;
    const Direction to_line = direction_of(attached.point - handle);
    return {along<Force>(to_line, profile_N(settings, attached.distance_m)),
            attached.point,
            attached.distance_m,
            side,
            other.boxes,
            other.is_complete};
}

}  // namespace touchline
