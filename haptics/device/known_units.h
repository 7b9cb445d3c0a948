// The known units, as far as two stops tell them apart. The reading between the stops is a turn
// times a count, so a stop in another place and another encoder may read alike. Threads: immutable
// values and pure functions.
#pragma once

#include "config/types/vec2.h"
#include "haptics/pantograph/profile.h"

#include <vector>

namespace touchline {

struct KnownUnits {
    double turn_rad = 0.0;  // both joints together, from stop to stop
    double scale = 1.0;   // true turn over the turn that a board reports, driven as the chosen kind
    bool are_own = true;  // of the chosen kind
    bool are_straight = false;  // bent arms lie in one line at their stop
};

/// Returns the units of the chosen kind first, then those with the same links but other stops.
[[nodiscard]] std::vector<KnownUnits> known_units(const DeviceProfile& chosen);

[[nodiscard]] double turn_of_both_rad(JointAngles turn);

/// Returns whether the turn read from stop to stop is nearest to a unit of the chosen kind, leaving
/// aside units that a question tells from it, and is at most 2.5 % off that unit's turn.
[[nodiscard]] bool is_of_kind(const std::vector<KnownUnits>& known, JointAngles read);

/// Returns whether a unit whose arms lie differently at their stop would read the same.
[[nodiscard]] bool needs_an_answer(const std::vector<KnownUnits>& known, JointAngles read);

/// Returns whether the arms of the chosen kind lie in one line.
[[nodiscard]] bool are_own_straight(const std::vector<KnownUnits>& known);

}  // namespace touchline
