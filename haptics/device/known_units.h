// Which units there are, as far as two stops tell them from each other: what is read between the
// stops is a turn times a count, so a stop that stands elsewhere and another encoder may read
// alike. Threads: immutable values and pure functions.
#pragma once

#include "config/types/vec2.h"
#include "haptics/pantograph/profile.h"

#include <vector>

namespace touchline {

struct KnownUnits {
    double turn_rad = 0.0;      // of both joints together, from stop to stop
    double scale = 1.0;         // true turn over what a board says, driven as the chosen kind
    bool are_own = true;        // they are of the chosen kind
    bool are_straight = false;  // bent arms lie in one line at their stop
};

/// Those of the chosen kind first, then those of the same links that are stopped elsewhere.
[[nodiscard]] std::vector<KnownUnits> known_units(const DeviceProfile& chosen);

[[nodiscard]] double turn_of_both_rad(JointAngles turn);

/// What was read from stop to stop is nearest to a unit of the chosen kind, but perhaps for one
/// that a question tells from it.
[[nodiscard]] bool is_of_kind(const std::vector<KnownUnits>& known, JointAngles read);

/// A unit whose arms lie otherwise at their stop would read so too.
[[nodiscard]] bool needs_an_answer(const std::vector<KnownUnits>& known, JointAngles read);

/// Whether those of the chosen kind lie in one line.
[[nodiscard]] bool are_own_straight(const std::vector<KnownUnits>& known);

}  // namespace touchline
