// What the servo reports to the rest of the kiosk, once a tick: the hand, and what became of the
// force. Threads: plain values and pure functions; handed over by haptics/servo/exchange.h.
#pragma once

#include "config/types/guidance.h"
#include "config/types/level_terms.h"
#include "config/types/vec2.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace touchline {

/// The shape that a hand holds to probe a picture.
/// none: a point, as for nearly everybody.
enum class HeldShape : std::uint8_t { none, disc, bar, ell, key };

inline constexpr std::size_t held_shape_count = 5;

/// The largest stiffness that can be set.
inline constexpr double most_stiffness_N_per_m = 20'000.0;

struct StiffnessBound {
    double share = 1.0;  // of the stiffness set; below 1 without real-time priority
    double most_N_per_m = most_stiffness_N_per_m;  // what the loop's rate and delay allow

    friend bool operator==(const StiffnessBound&, const StiffnessBound&) = default;
};

/// Returns the stiffness that acts for the one that is set.
[[nodiscard]] constexpr double possible_N_per_m(const StiffnessBound& bound, double set_N_per_m) {
    return std::min(bound.share * set_N_per_m, bound.most_N_per_m);
}

/// The paper's three contact states: no contact, one edge, held at a vertex.
enum class ContactState : std::uint8_t { free = 0, edge = 1, vertex = 2 };

/// How an outline feels.
enum class Mode : std::uint8_t { wall, groove, ridge, stay };

struct HandState {
    double time_s = 0.0;  // since the servo started
    Position p_WH;        // handle
    Position p_WP;        // proxy; never crosses an outline
    Force force;          // commanded, after the force chain
    double speed_m_per_s = 0.0;
    double level = 0.0;  // rendered level, with its fraction
    bool is_level_auto = true;
    LevelTerms level_terms;  // for the wanted level; the rendered one may be on its way there
    double stiffness_N_per_m = 0.0;  // before spring_gain; moves to what is set and possible
    StiffnessBound stiffness_bound;
    double spring_gain = 1.0;  // below 1 if the loop rang and was softened
    Mode mode = Mode::wall;
    ContactState state = ContactState::free;
    int outline = -1;  // index in the map of the outline touched, -1 when free
    std::uint64_t ticks = 0;
    std::uint64_t missed_ticks = 0;  // ticks that could not run in their period and were skipped
    std::uint64_t map_version = 0;   // of the map felt
    GuidanceStatus guidance;
    HeldShape shape = HeldShape::none;  // shape felt with
    bool is_shape_placed = false;       // false: lines still pass through it, and nothing is felt
    double angle_rad = 0.0;             // the handle's turn
    double proxy_angle_rad = 0.0;
    double torque_Nm = 0.0;        // of the shape on the hand, whether or not a motor can show it
    std::uint32_t hand_moves = 0;  // how often a hand, and no force, has moved the handle by 4 mm
};

/// off: zero, because no force is wanted. armed: zero until a hand is there and the wanted force
/// has been small for a while, so that nobody is pushed when force comes on. ramp: the gain is on
/// its way up or down. live: full gain. fault: zero until its cause is cleared; tracking, events
/// and sound go on.
enum class ForceState : std::uint8_t { off, armed, ramp, live, fault };

inline constexpr std::size_t force_state_count = 5;

/// Causes of the fault state, the gravest last.
enum class Fault : std::uint8_t {
    none,
    device_lost,    // the device does not answer, or takes no torques
    too_fast,       // the handle was faster than a hand can be
    energy,         // the device gave the hand more energy than it may
    ringing,        // the loop rings although it was softened
    knob_lost,      // the loop rings and only the device's own mass moves
    position_jump,  // the handle cannot have moved so far
    not_finite,     // NaN or infinity: a bug or a broken device
    emergency_stop
};

inline constexpr std::size_t fault_count = 9;

/// What reduced the force in a tick, the gravest last.
enum class Limit : std::uint8_t {
    none,
    gain,    // on the way up or down, or off
    slew,    // limit on change and growth
    torque,  // limit of a motor
    force,   // limit on the vector's length
    heat,    // motor too warm
    damped,  // energy was given to the hand: damping is added
    pose,    // near a singular pose
    speed,   // nothing may drive on a fast hand
    hand,    // nobody seems to hold the handle
    unreachable,
    fault
};

inline constexpr std::size_t limit_count = 12;

/// Why the hand feels what it feels, for the operator.
struct ForceStatus {
    ForceState state = ForceState::off;
    Fault fault = Fault::none;
    Limit limit = Limit::none;                         // the gravest of this tick
    std::array<std::uint32_t, limit_count> limited{};  // ticks so far in which each limit acted
};

}  // namespace touchline
