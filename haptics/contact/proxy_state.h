// What the contact machine keeps from step to step: its settings, the proxy, the states that a step
// passed through, and the energy that a moving wall may spend. Threads: plain values.
#pragma once

#include "config/types/fields.h"
#include "config/types/hand_state.h"
#include "config/types/vec2.h"
#include "haptics/curve/curve_set.h"

#include <algorithm>
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

/// The centre of a proxy in a contact with this segment.
[[nodiscard]] inline Position centre_of(const Segment& segment, const Contact& at) {
    return point_of(segment, at.parameter) + along<Position>(at.normal, at.offset_m);
}

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
    SegmentRef left;  // while free: the edge that it has let go of, until it moves
};

/// Up to 16 states in order, beginning with the one before the step; further ones are left out.
/// Packed in two bits each, because clearing an array of them took longer than the arithmetic of a
/// free step.
class StateTrail {
  public:
    StateTrail() = default;

    explicit StateTrail(ContactState first) : states_(static_cast<std::uint32_t>(first)) {}

    /// 1 means no change.
    [[nodiscard]] int size() const { return size_; }

    /// State i, 0 <= i < size().
    [[nodiscard]] ContactState operator[](int i) const {
        return static_cast<ContactState>((states_ >> (2 * (size_ - 1 - i))) & 3U);
    }

    /// A walk along the outline (an edge, a vertex, an edge again) counts as one edge.
    void add(ContactState state) {
        const auto bits = static_cast<std::uint32_t>(state);
        if ((states_ & 3U) == bits) return;
        if (size_ >= 2 && state == ContactState::edge && (states_ & 15U) == edge_then_vertex) {
            states_ >>= 2U;
            --size_;
        } else if (size_ < capacity) {
            states_ = states_ << 2U | bits;
            ++size_;
        }
    }

  private:
    static constexpr int capacity = 16;
    static constexpr std::uint32_t edge_then_vertex =
        static_cast<std::uint32_t>(ContactState::edge) << 2U |
        static_cast<std::uint32_t>(ContactState::vertex);

    std::uint32_t states_ = 0;  // the newest in the lowest bits
    int size_ = 1;
};

/// Limits the work that a moving wall does on the hand. A change of level under the hand does work,
/// so the hand must have given that energy before, or the change waits.
/// The balance is never negative and at most 2 mJ. It leaks at a rate of 1/s, so that work done
/// long ago does not pay for a wall that rings now.
class EnergyAccount {
  public:
    /// Adds what the proxy's sliding has dissipated in a tick, and a trickle of 0.1 mW, so that a
    /// change also completes under a hand at rest, within seconds.
    void earn(double dissipated_J, double dt_s) {
        const double kept_J = balance_J_ * std::max(0.0, 1.0 - leak_per_s * dt_s);
        const double earned_J = std::max(0.0, dissipated_J) + trickle_W * dt_s;
        balance_J_ = std::min(most_J, kept_J + earned_J);
    }

    /// Books the work of a motion. Returns false, and books nothing, if the balance does not cover
    /// it. A wall that gives way has negative work, which is added.
    [[nodiscard]] bool spend(double work_J) {
        if (!(work_J <= balance_J_)) return false;
        balance_J_ = std::min(most_J, balance_J_ - work_J);
        return true;
    }

    [[nodiscard]] double balance_J() const { return balance_J_; }

  private:
    static constexpr double most_J = 2e-3;
    static constexpr double leak_per_s = 1.0;
    static constexpr double trickle_W = 1e-4;

    double balance_J_ = 0.0;
};

}  // namespace touchline
