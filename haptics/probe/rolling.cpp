// The move along distances that curve: a roll about a pivot, as far as its way follows them.
#include "haptics/probe/kept_distance.h"
#include "haptics/probe/probe_proxy.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr int most_bends = 6;        // corrections of a move for curving distances
constexpr int most_shortenings = 4;  // of a roll
constexpr double fits = 1.0 - 1e-9;  // of how long a roll may be
constexpr double about_fits = 0.95;  // where nothing depends on it
constexpr double least_flat = 0.4;   // share of a roll: if less follows the curve, lift off
constexpr double most_sink_m = 0.75 * probe_slack_m;  // half-way of a roll
constexpr double most_bend_m = 3.0 * probe_slack_m;   // of a straight way: a chord sinks a quarter
constexpr double least_turn_rad = 1e-6;               // a smaller turn needs no pivot
constexpr double most_pivot = 4.0;                    // times the shape's largest radius
constexpr double least_crossing = 0.1;  // sine between two normals: less gives no common pivot

}  // namespace

/// Finds the move along distances that curve: a roll whose way follows them, as long as it may be;
/// or, if only a short part of it does, a straight one that lifts off what curves away. Returns
/// false if neither is worth it.
bool ProbeProxy::curved_move(const Coupled& wanted, const Springs& springs,
                             const Following& following, const LeastMove& held, ProbeMove& move) {
    const CurvedEnergy energy(touching_, held);
    energy.see(constraints_, seen_);
    LeastMove whole = held;
    const Coupled wanted_seen = energy.see(wanted);
    whole.move = energy.least(seen_, wanted_seen, whole);
    double share = shortening(whole.move, springs, following.longest_m);
    const auto is_worth = [&](const Coupled& curved) {
        return left_of_move(wanted, curved) <= square(wanted);
    };
    const double least_fit = following.longest_m == longest_move_m ? about_fits : fits;
    for (int i = 0; i < most_shortenings; ++i) {
        const auto end_of_way = [&](double most_m) {
            return curved_end(energy, share * wanted_seen, share * whole.move, springs, most_m,
                              whole);
        };
        const Coupled curved = end_of_way(INFINITY);
        move = rolling(curved, springs, held);
        const double fit = following.longest_m / move.reach_m(shape_->r_max_m());
        const double sink = sink_m(move) / most_sink_m;
        if (fit >= least_fit && sink <= 1.0 && is_worth(curved)) return true;
        const double flat = sink > 1.0 ? 0.8 / std::sqrt(sink) : 1.0;
        if (flat < least_flat || (flat < 1.0 && move.pivot == Position{})) {
            const Coupled lifted = end_of_way(most_bend_m);
            move = move_of(lifted, springs);
            if (is_worth(lifted)) return true;
        }
        share *= std::min(fit, std::max(flat, 0.1));
    }
    return false;
}

/// Returns the share of a move that is looked at once.
double ProbeProxy::shortening(const Coupled& move, const Springs& springs, double longest_m) const {
    const double reach_m = move_of(move, springs).reach_m(shape_->r_max_m());
    return reach_m > longest_m ? longest_m / reach_m : 1.0;
}

/// Returns the pivot under which the way bends least towards what holds the shape back.
Position ProbeProxy::pivot_of(const ProbeMove& move, const LeastMove& held) const {
    if (held.active_count == most_active || std::abs(move.turn_rad) < least_turn_rad) return {};
    const auto touching = [&](int i) {
        return touching_[static_cast<std::size_t>(held.active[static_cast<std::size_t>(i)])];
    };
    const Touching first = touching(0);
    const Direction n = first.normal();
    const double p = first.pivot_m(move);
    Position pivot = along<Position>(n, p);
    if (held.active_count == 2) {
        const Touching second = touching(1);
        const Direction m = second.normal();
        const double size = cross(n, m);
        const double q = second.pivot_m(move);
        if (std::abs(size) > least_crossing)
            pivot = {(p * m.y - q * n.y) / size, (q * n.x - p * m.x) / size};
    }
    const double far = norm(pivot) / (most_pivot * shape_->r_max_m());
    return far > 1.0 ? (1.0 / far) * pivot : pivot;
}

/// Returns a move to the same place, under the pivot.
ProbeMove ProbeProxy::rolling(const Coupled& move, const Springs& springs,
                              const LeastMove& held) const {
    ProbeMove out = move_of(move, springs);
    out.pivot = pivot_of(out, held);
    if (out.pivot == Position{}) return out;
    out.by = out.by + Rotation(out.turn_rad)(out.pivot) - out.pivot;
    return out;
}

/// Returns how much nearer than at the start and than kept a touching line is half-way.
double ProbeProxy::sink_m(const ProbeMove& move) const {
    const ProbePlacement half = ProbePlacement{}.after(0.5 * move);
    double most_m = 0.0;
    for (std::size_t i = 0; i < touching_.size(); ++i) {
        const double start_m = std::min(pairs_[i].geometry.at.distance_m, keep_m_);
        most_m = std::max(most_m, start_m - touching_[i].distance_m(half));
    }
    return most_m;
}

/// Returns the least move along distances that curve: finds what they are after the move, then the
/// move again. A bend counts up to `most_bend_m`. seen_ holds the constraints as the energy sees
/// them; `held`: what holds back a move like it.
Coupled ProbeProxy::curved_end(const CurvedEnergy& energy, const Coupled& wanted_seen, Coupled move,
                               const Springs& springs, double most_bend_m, LeastMove held) {
    for (int round = 0; round < most_bends; ++round) {
        const ProbePlacement moved = ProbePlacement{}.after(move_of(move, springs));
        for (std::size_t i = 0; i < touching_.size(); ++i) {
            const double start_m = pairs_[i].geometry.at.distance_m;
            const double straight_m = start_m + dot3(touching_[i].row(), move);
            const double bend_m = touching_[i].distance_m(moved) - straight_m;
            seen_[i].gap_m = start_m - keep_m_ + sunk_m_ + std::min(bend_m, most_bend_m);
        }
        const Coupled before = move;
        move = energy.least(seen_, wanted_seen, held);
        if (left_of_move(before, move) < probe_rest_m * probe_rest_m) break;
    }
    return move;
}

}  // namespace touchline
