// A change of the rendered level under a shape, as a motion of the lines.
#include "haptics/probe/kept_distance.h"
#include "haptics/probe/probe_proxy.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double largest_jump_N = 0.015;  // change of the force in a tick by a change of level
constexpr int most_halvings = 4;

/// Returns how far an edge is from a line along a direction, which is at most their distance.
double room_along(Direction normal, const Segment& edge, const Segment& line) {
    return std::min(dot(normal, edge.a), dot(normal, edge.b)) -
           std::max(dot(normal, line.a), dot(normal, line.b));
}

}  // namespace

/// Changes the rendered level under the shape, as a motion of the lines.
void ProbeProxy::change_level(double level, const ProbePose& handle, const Springs& springs,
                              Spender& spender) {
    const double from = front_.level();
    double next =
        std::clamp(within_octave(from, level), from - largest_octaves, from + largest_octaves);
    for (int i = 0; i <= most_halvings; ++i) {
        if (try_level(next, handle, springs, spender)) return;
        next = 0.5 * (from + next);
    }
}

/// Within an octave every point of a line moves straight. So two lines that lie apart along a
/// direction before and after lie apart all the time.
ProbeProxy::Room ProbeProxy::room_at(double level, const Springs& springs, Spender& spender) {
    const double from = front_.level();
    const int finer = static_cast<int>(std::floor(std::min(from, level)));
    const CurveSet& curves = front_.outlines().scene().curves;
    const double jump_m = largest_jump_N / springs.k_N_per_m;
    Room room{true, true};
    constraints_.clear();
    wide_.look(placed_, keep_m_, probe_touch_m, spender);
    if (!std::isinf(wide_.unopened_m())) return {false, false};
    for (const NearPair& pair : wide_.near()) {
        if (pair.node.level != finer + 1) continue;  // a piece without that octave
        const RenderedPiece before = curves.blend(pair.node.piece, finer, from - finer);
        const RenderedPiece after = curves.blend(pair.node.piece, finer, level - finer);
        const Segment edge = placed_(pair.geometry.edge);
        for (int j = 2 * pair.node.index; j <= 2 * pair.node.index + 1; ++j) {
            if (j >= before.segment_count()) continue;
            const Separation at = separation(edge, before.segment(j));
            const double room_m = room_along(at.normal, edge, after.segment(j));
            const bool touches = at.distance_m <= keep_m_ + probe_touch_m;
            if (room_m < least_distance_m(keep_m_, at.distance_m)) room.is_free = false;
            if (touches && std::abs(room_m - at.distance_m) > jump_m) room.is_possible = false;
            if (!touches && !(room_m >= least_distance_m(keep_m_, at.distance_m) - jump_m)) {
                room.is_possible = false;
            }
            if (room_m > keep_m_ + probe_touch_m) continue;
            if (constraints_.size() == constraints_.capacity()) return {false, false};
            const Touching touching(edge, before.segment(j), at, pose_.place(), springs.lever_m);
            constraints_.push_back({touching.row(), room_m - keep_m_});
        }
    }
    return room;
}

bool ProbeProxy::try_level(double level, const ProbePose& handle, const Springs& springs,
                           Spender& spender) {
    wide_.set_level(std::floor(std::min(front_.level(), level)) + 0.5);
    Room room = room_at(level, springs, spender);
    if (!room.is_possible) return false;
    if (!room.is_free) {
        // The shape goes first; the lines follow.
        const LeastMove least = least_move(constraints_, {});
        const ProbeMove move = move_of(least.move, springs);
        const double reach_m = move.reach_m(shape_->r_max_m());
        const ProbePose start = pose_;
        const double work_J =
            springs.energy_J(handle - (pose_ + move)) - springs.energy_J(handle - pose_);
        if (!(springs.k_N_per_m * std::sqrt(square(least.move)) <= largest_jump_N)) return false;
        if (!(work_J <= account_.balance_J())) return false;
        if (!(clear_share_of(move, spender, false) >= 1.0)) return false;
        put(start + move);
        front_.spend(reach_m);
        wide_.spend(reach_m);
        room = room_at(level, springs, spender);
        if (!room.is_free) {
            put(start);
            front_.spend(reach_m);
            return false;
        }
        if (path_ != nullptr) path_->push_back(pose_);
        (void)account_.spend(work_J);
    }
    front_.set_level(level);
    return true;
}

}  // namespace touchline
