// The servo step over the workload's hand, arranged for counting: one function a step, the same
// steps every time. Threads: one.
#pragma once

#include "haptics/collision/scene.h"
#include "haptics/contact/contact_machine.h"
#include "haptics/resolution/level_rule.h"
#include "tests/lab/bench/workload.h"

#include <cstddef>
#include <string_view>

namespace touchline::bench {

inline constexpr std::size_t warm_up_steps = 2000;
inline constexpr std::size_t counted_steps = 20000;

/// Who sets the level: the rule by speed, or nobody (level 0).
enum class LevelChoice { automatic, finest };

[[nodiscard]] constexpr std::string_view name_of(LevelChoice choice) {
    return choice == LevelChoice::automatic ? "auto" : "0";
}

/// A step's settings and state: wall, 500 N/m, a point proxy, no friction, no budget, 1 ms.
struct Servo {
    LevelRule rule;
    LevelChoice choice;
    ContactMachine machine;
    ContactSettings settings;
    ContactReport report;  // the last step's
};

/// Builds a scene of the radial curve. Ends the program with one line on stderr if that fails.
[[nodiscard]] Scene radial_scene(std::size_t edges);

/// Returns a servo at the hand's first position, not yet stepped. `scene` must outlive it.
[[nodiscard]] Servo start(const Scene& scene, LevelChoice choice, Position hand);

/// Ends the program with one line on stderr once the hand has slipped off (10 mm from the proxy),
/// because the count after that would be of other work.
void expect_held(const Servo& servo, Position hand);

}  // namespace touchline::bench

/// Does one servo step. Callgrind counts inside the function of this name, so it is neither inlined
/// nor cloned, and its name is not mangled.
extern "C" [[gnu::noipa]] void touchline_servo_step(touchline::bench::Servo& servo,
                                                    const touchline::Position& hand);
