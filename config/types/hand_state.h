// What the servo reports to the rest of the kiosk, once a tick.
// Threads: a plain value; handed over by haptics/servo/exchange.h.
#pragma once

#include "config/types/guidance.h"
#include "config/types/held_shape.h"
#include "config/types/level_terms.h"
#include "config/types/stiffness_bound.h"
#include "config/types/vec2.h"

#include <cstdint>

namespace touchline {

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
    double torque_Nm = 0.0;  // of the shape on the hand, whether or not a motor can show it
};

}  // namespace touchline
