// What checkers see of a simulated site, each millisecond and each frame, and where they report
// what is wrong. Threads: plain values.
#pragma once

#include "app/kiosk/kiosk.h"
#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/safety/force_chain.h"
#include "haptics/servo/recorder.h"
#include "tests/machines/sim/kiosk/figures.h"

#include <optional>
#include <string>
#include <utility>

namespace touchline {

/// One millisecond of the board's time.
struct TickSight {
    double now_s = 0.0;                // board time
    const TickRecord* tick = nullptr;  // the servo's tick in it; null: none
    bool is_first_tick = false;        // of this servo
    JointTorques held;                 // what the motors make now
    double held_since_s = 0.0;
    Force force_W;  // the force of `held` on the hand
    MassState tip;  // true motion of the handle
    bool is_hand_on = false;
    bool is_led = false;           // guidance or a pattern acts: it is meant to give energy
    bool is_send_hanging = false;  // the link broke a moment ago: what is told may come late
};

/// One frame of the kiosk, after its step.
struct FrameSight {
    double now_s = 0.0;  // site time
    const Kiosk& kiosk;
    std::size_t heard = 0;        // things said and given so far
    bool is_servo_ready = false;  // it ticks without a fault
    bool has_read = false;        // somebody turned a page of the braille display
    bool is_blocked = false;      // waits for a person, the guard's pause or a fault's end
    ServoCommands commands{};     // as the kiosk told them last
    std::size_t jobs = 0;         // load jobs
    std::uint64_t dropped_events = 0;
};

/// Keeps the first finding that is wrong.
class Findings {
  public:
    /// Calls `words` only for the first.
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
