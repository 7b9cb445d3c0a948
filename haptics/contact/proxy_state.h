// What the contact machine keeps from step to step, and its settings.
// Threads: plain values.
#pragma once

#include "config/types/fields.h"
#include "config/types/hand_state.h"
#include "config/types/vec2.h"
#include "haptics/curve/curve_set.h"

#include <array>
#include <cstdint>

namespace touchline {

/// How lines feel, from the operator to the law of contact, within the ranges in contact_fields().
struct ContactSettings {
    Mode mode = Mode::wall;
    double stiffness_N_per_m = 500.0;  // K; the servo ramps its rises
    double friction = 0.0;             // mu of the Coulomb cone along a line
    double radius_m = 0.0;             // of the proxy, at most the scene's
    double capture_m = 0.003;          // w, half width of groove and ridge
    double pop_through_N = 0.0;        // push that a wall gives way to; 0: none does
    double pop_through_s = 0.3;        // how long it must last

    friend bool operator==(const ContactSettings&, const ContactSettings&) = default;
};

template <class Fields, class Settings>
constexpr void contact_fields(Fields& f, Settings& s) {
    f.choice(s.mode, Mode::stay);
    f.number(s.stiffness_N_per_m, 1e-9, most_stiffness_N_per_m);
    f.number(s.friction, 0.0, 1.0);
    f.number(s.radius_m, 0.0, 0.02);
    f.number(s.capture_m, 1e-9, 0.1);
    f.number(s.pop_through_N, 0.0, 100.0);
    f.number(s.pop_through_s, 0.0, 100.0);
}

static_assert(
    [] {
        constexpr ContactSettings any;
        FieldEnd end;
        contact_fields(end, any);
        return end.bytes();
    }() == sizeof(ContactSettings),
    "contact_fields() must name every member in its order");

enum class Side : std::int8_t { right = -1, left = 1 };

[[nodiscard]] inline double sign_of(Side side) {
    return static_cast<double>(side);
}

/// The normal of a segment towards one side.
[[nodiscard]] inline Direction normal_of(const Segment& segment, Side side) {
    return sign_of(side) * left_of(direction_of(segment.b - segment.a));
}

/// The point at a parameter; exactly the segment's end at 0 and 1.
[[nodiscard]] inline Position point_of(const Segment& segment, double parameter) {
    return parameter < 0.5 ? segment.a + parameter * (segment.b - segment.a)
                           : segment.b + (parameter - 1.0) * (segment.b - segment.a);
}

/// Where the proxy touches the curve as rendered: centre = point(segment, parameter) + offset *
/// normal.
struct Contact {
    SegmentRef segment;
    double parameter = 0.0;  // on the segment, 0 ... 1
    Side side = Side::left;  // of the outline, looking along it
    Direction normal;        // from the curve to the proxy
    double offset_m = 0.0;   // distance kept: the proxy radius, at least the contact skin
    bool is_round = false;   // at an end of the segment, the normal between those of its two edges
};

/// State 0: no contact counts. State 1: contacts[0], on the side of an edge. State 2: contacts[0]
/// and, at a concave vertex or between two outlines, contacts[1]; or contacts[0] alone, round a
/// convex vertex or a line's end.
struct ProxyState {
    ContactState state = ContactState::free;
    Position centre;
    std::array<Contact, 2> contacts{};
    int contact_count = 0;
    // While free: how far the proxy may still go before it can meet anything, by the last query.
    double spare_m = 0.0;
};

}  // namespace touchline
