// What checkers see of a simulated house, each millisecond and each frame, and where they say what
// is wrong. Threads: plain values.
#pragma once

#include "app/kiosk/kiosk.h"
#include "haptics/device/hand.h"
#include "haptics/device/tip_dynamics.h"
#include "haptics/safety/force_chain.h"
#include "haptics/servo/recorder.h"
#include "tests/sim/kiosk/figures.h"

#include <optional>
#include <string>
#include <utility>

namespace touchline {

/// A millisecond of the board's time.
struct TickSight {
    double now_s = 0.0;                // of the board
    const TickRecord* tick = nullptr;  // that the servo made in it; null: none
    bool is_first_tick = false;        // of a servo
    JointTorques held;                 // that the motors make now
    double held_since_s = 0.0;
    Force force_W;  // of that, on the hand
    MassState tip;  // where the handle really is
    bool is_hand_on = false;
    bool is_led = false;           // guidance or a pattern acts: it is meant to give energy
    bool is_send_hanging = false;  // the link was broken a moment ago: what is told may come late
};

/// A frame of the kiosk, after its step.
struct FrameSight {
    double now_s = 0.0;  // of the house
    const Kiosk& kiosk;
    std::size_t heard = 0;        // things said and given, ever
    bool is_servo_ready = false;  // it ticks, without a fault
    bool is_blocked = false;      // ready waits for a person, the guard's pause or a fault's end
    ServoCommands commands{};     // as the kiosk told them last
    std::size_t jobs = 0;         // of loading
    std::uint64_t dropped_events = 0;
};

/// The first thing that is not as it must be.
class Findings {
  public:
    /// `words` is only called for the first.
    template <class Words>
    void demand(bool holds, const char* checker, double at_s, Words words) {
        if (holds || first_) return;
        first_ = SimFailure{at_s, checker, words()};
    }

    [[nodiscard]] const std::optional<SimFailure>& first() const { return first_; }

  private:
    std::optional<SimFailure> first_;
};

}  // namespace touchline
