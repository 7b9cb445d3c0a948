// The known units, as far as two stops tell them apart. The reading between the stops is a turn
// times a count, so a stop in another place, another encoder or other links may read alike.
// Threads: immutable values and pure functions.
#pragma once

#include "config/types/vec2.h"
#include "haptics/pantograph/kinematics.h"
#include "haptics/pantograph/profile.h"

#include <cstdint>
#include <span>
#include <vector>

namespace touchline {

struct KnownUnits {
    double turn_rad = 0.0;  // both joints together, from stop to stop
    double scale = 1.0;   // true turn over the turn that a board reports, driven as the chosen kind
    bool are_own = true;  // of the chosen kind
    bool are_straight = false;   // bent arms lie in one line at their stop
    bool have_own_links = true;  // as long as those of the chosen kind
    Geometry links;
    JointAngles at_check;  // rad, where the chosen kind has its check stop
};

/// Returns the units of the chosen kind first, then those of all other kinds but those that differ
/// neither in their links nor in their stops.
[[nodiscard]] std::vector<KnownUnits> known_units(
    const DeviceProfile& chosen, std::span<const DeviceProfile> kinds = device_profiles());

[[nodiscard]] double turn_of_both_rad(JointAngles turn);

/// Returns whether the turn read from stop to stop is at most 2.5 % off that of a unit of the
/// chosen kind and nearer to it than to any other with the same links, leaving aside units that a
/// question tells from it.
[[nodiscard]] bool is_of_kind(const std::vector<KnownUnits>& known, JointAngles read);

/// Whose links a unit has.
enum class LinksOf : std::uint8_t { chosen_kind, other_kind, either };

/// Tells a unit of other links that would read the same turn from stop to stop, and that no
/// question tells from the chosen kind, by a place where no arms of its links, or of the kind's,
/// could be. `turned` is the turn read from the check stop to that place.
[[nodiscard]] LinksOf links_of(const std::vector<KnownUnits>& known, JointAngles read,
                               JointAngles turned);

/// Returns whether a unit whose arms lie differently at their stop would read the same.
[[nodiscard]] bool needs_an_answer(const std::vector<KnownUnits>& known, JointAngles read);

/// Returns whether the arms of the chosen kind lie in one line.
[[nodiscard]] bool are_own_straight(const std::vector<KnownUnits>& known);

}  // namespace touchline
