#include "haptics/device/known_units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace touchline {
namespace {

// The counts of units of one kind differ by less than this. With more, units stopped at 168 degrees
// could not be told from those stopped at 172, which turn by 5.6 per cent farther.
constexpr double scale_tolerance = 0.025;
constexpr double straight_rad = 0.05;
// Measured at the elbows. Smaller differences cannot be read if the stretched arms lie straight, as
// those of a gen 2 do.
constexpr double kinds_apart_m = 2e-3;

JointAngles bent_of(const DeviceProfile& kind) {
    return kind.home_place == StopPlace::towards ? kind.check.angles : kind.home;
}

bool is_straight(JointAngles bent) {
    return std::abs(bent.x - std::numbers::pi) < straight_rad && std::abs(bent.y) < straight_rad;
}

bool is_alike(const DeviceProfile& kind, const DeviceProfile& chosen) {
    const Geometry& links = kind.geometry;
    const Geometry& others = chosen.geometry;
    return links.proximal_m == others.proximal_m && links.distal_m == others.distal_m &&
           links.base_m == others.base_m && kind.handle.has_value() == chosen.handle.has_value();
}

/// Adds a kind's units, on boards driven as the chosen kind's. A decoder that sees each edge is
/// known on boards that are told twice their resolution.
void add_known(const DeviceProfile& kind, const DeviceProfile& chosen, bool are_own,
               std::vector<KnownUnits>& known) {
    const double turn_rad = turn_of_both_rad(kind.check.angles - kind.home);
    const double driven = turn_of_both_rad(chosen.counts_per_turn);
    const bool are_straight = is_straight(bent_of(kind));
    for (const double counts :
         {turn_of_both_rad(kind.counts_per_turn), 2.0 * kind.other_counts_per_turn}) {
        if (!(counts > 0.0)) continue;
        known.push_back({turn_rad, driven / counts, are_own, are_straight});
        if (kind.wiring.told_per_count > 1.0)
            known.push_back({turn_rad, 0.5 * driven / counts, are_own, are_straight});
    }
}

/// The share by which this turn misses that of the nearest unit for which `counts` is true.
template <class Counts>
double off_by(const std::vector<KnownUnits>& known, JointAngles read, Counts counts) {
    double least = std::numeric_limits<double>::infinity();
    for (const KnownUnits& units : known) {
        const double share = units.scale * turn_of_both_rad(read) / units.turn_rad;
        if (counts(units)) least = std::min(least, std::abs(share - 1.0));
    }
    return least;
}

}  // namespace

double turn_of_both_rad(JointAngles turn) {
    return std::abs(turn.x) + std::abs(turn.y);
}

std::vector<KnownUnits> known_units(const DeviceProfile& chosen) {
    std::vector<KnownUnits> known;
    add_known(chosen, chosen, true, known);
    for (const DeviceProfile& kind : device_profiles()) {
        const JointAngles off = bent_of(kind) - bent_of(chosen);
        const double off_m =
            chosen.geometry.proximal_m * std::max(std::abs(off.x), std::abs(off.y));
        if (is_alike(kind, chosen) && off_m > kinds_apart_m) add_known(kind, chosen, false, known);
    }
    return known;
}

bool is_of_kind(const std::vector<KnownUnits>& known, JointAngles read) {
    const bool are_straight = are_own_straight(known);
    const double own = off_by(known, read, [](const KnownUnits& units) { return units.are_own; });
    const double alike = off_by(known, read, [&](const KnownUnits& units) {
        return !units.are_own && units.are_straight == are_straight;
    });
    return own <= scale_tolerance && own < alike;
}

bool needs_an_answer(const std::vector<KnownUnits>& known, JointAngles read) {
    const bool are_straight = are_own_straight(known);
    const double other = off_by(
        known, read, [&](const KnownUnits& units) { return units.are_straight != are_straight; });
    return other <= scale_tolerance;
}

bool are_own_straight(const std::vector<KnownUnits>& known) {
    return !known.empty() && known.front().are_straight;
}

}  // namespace touchline
