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
// Of a joint's angle away from the stops: the count's tolerance over 120 degrees, and a stop that
// stands 3 mm away.
constexpr double doubt_rad = 0.1;

JointAngles bent_of(const DeviceProfile& kind) {
    return kind.home_place == StopPlace::towards ? kind.check.angles : kind.home;
}

bool is_straight(JointAngles bent) {
    return std::abs(bent.x - std::numbers::pi) < straight_rad && std::abs(bent.y) < straight_rad;
}

JointAngles stretched_of(const DeviceProfile& kind) {
    return kind.home_place == StopPlace::towards ? kind.home : kind.check.angles;
}

bool have_same_links(const Geometry& a, const Geometry& b) {
    return a.proximal_m == b.proximal_m && a.distal_m == b.distal_m && a.base_m == b.base_m;
}

/// Whether a unit of the kind could be taken for one of the chosen kind and would then have wrong
/// links or wrong stops.
bool is_another(const DeviceProfile& kind, const DeviceProfile& chosen) {
    if (!have_same_links(kind.geometry, chosen.geometry)) return true;
    const JointAngles off = bent_of(kind) - bent_of(chosen);
    const double off_m = chosen.geometry.proximal_m * std::max(std::abs(off.x), std::abs(off.y));
    return kind.handle.has_value() == chosen.handle.has_value() && off_m > kinds_apart_m;
}

/// Adds a kind's units, on boards driven as the chosen kind's. A decoder that sees each edge is
/// known on boards that are told twice their resolution.
void add_known(const DeviceProfile& kind, const DeviceProfile& chosen, bool are_own,
               std::vector<KnownUnits>& known) {
    const bool is_bent_at_check = chosen.home_place == StopPlace::towards;
    KnownUnits units{turn_of_both_rad(kind.check.angles - kind.home),
                     1.0,
                     are_own,
                     is_straight(bent_of(kind)),
                     have_same_links(kind.geometry, chosen.geometry),
                     kind.geometry,
                     is_bent_at_check ? bent_of(kind) : stretched_of(kind)};
    const double driven = turn_of_both_rad(chosen.counts_per_turn);
    for (const double counts :
         {turn_of_both_rad(kind.counts_per_turn), 2.0 * kind.other_counts_per_turn}) {
        if (!(counts > 0.0)) continue;
        units.scale = driven / counts;
        known.push_back(units);
        units.scale = 0.5 * driven / counts;
        if (kind.wiring.told_per_count > 1.0) known.push_back(units);
    }
}

/// The share by which this turn misses that of a unit.
double off_by(const KnownUnits& units, JointAngles read) {
    return std::abs(units.scale * turn_of_both_rad(read) / units.turn_rad - 1.0);
}

/// The same of the nearest unit for which `counts` is true.
template <class Counts>
double least_off_by(const std::vector<KnownUnits>& known, JointAngles read, Counts counts) {
    double least = std::numeric_limits<double>::infinity();
    for (const KnownUnits& units : known)
        if (counts(units)) least = std::min(least, off_by(units, read));
    return least;
}

/// Returns whether arms of these links could be at the angles, or anywhere near them.
bool can_be_at(const Geometry& links, JointAngles angles) {
    for (const double off_1 : {-doubt_rad, 0.0, doubt_rad})
        for (const double off_2 : {-doubt_rad, 0.0, doubt_rad})
            if (forward(links, angles + JointAngles{off_1, off_2})) return true;
    return false;
}

}  // namespace

double turn_of_both_rad(JointAngles turn) {
    return std::abs(turn.x) + std::abs(turn.y);
}

std::vector<KnownUnits> known_units(const DeviceProfile& chosen,
                                    std::span<const DeviceProfile> kinds) {
    std::vector<KnownUnits> known;
    add_known(chosen, chosen, true, known);
    for (const DeviceProfile& kind : kinds)
        if (is_another(kind, chosen)) add_known(kind, chosen, false, known);
    return known;
}

bool is_of_kind(const std::vector<KnownUnits>& known, JointAngles read) {
    const bool are_straight = are_own_straight(known);
    const double own =
        least_off_by(known, read, [](const KnownUnits& units) { return units.are_own; });
    const double alike = least_off_by(known, read, [&](const KnownUnits& units) {
        return !units.are_own && units.have_own_links && units.are_straight == are_straight;
    });
    return own <= scale_tolerance && own < alike;
}

LinksOf links_of(const std::vector<KnownUnits>& known, JointAngles read, JointAngles turned) {
    bool is_alone = true;
    bool can_be_own = false;
    bool can_be_other = false;
    for (const KnownUnits& units : known) {
        const bool is_asked = units.are_straight != are_own_straight(known);
        if (is_asked || !(off_by(units, read) <= scale_tolerance)) continue;
        const bool can_be = can_be_at(units.links, units.at_check + units.scale * turned);
        is_alone = is_alone && units.have_own_links;
        (units.have_own_links ? can_be_own : can_be_other) |= can_be;
    }
    if (is_alone || (can_be_own && !can_be_other)) return LinksOf::chosen_kind;
    return can_be_own ? LinksOf::either : LinksOf::other_kind;
}

bool needs_an_answer(const std::vector<KnownUnits>& known, JointAngles read) {
    const bool are_straight = are_own_straight(known);
    const double other = least_off_by(
        known, read, [&](const KnownUnits& units) { return units.are_straight != are_straight; });
    return other <= scale_tolerance;
}

bool are_own_straight(const std::vector<KnownUnits>& known) {
    return !known.empty() && known.front().are_straight;
}

}  // namespace touchline
