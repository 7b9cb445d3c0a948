// A board in a file that several processes map: it holds its last torque whatever dies, as a real
// one does, and knows who holds it.
#pragma once

#include "config/types/steady_clock.h"
#include "config/types/vec2.h"

#include <atomic>
#include <cstdint>

#include <signal.h>
#include <unistd.h>

namespace touchline {

/// What the servo's device does at its next tick.
enum class Mischief : int { none, write_nowhere, throw_something, spin };

struct FakeBoard {
    std::atomic<int> is_pressed{0};  // the hand presses it against the line
    std::atomic<Mischief> mischief{Mischief::none};
    std::atomic<int> owner{0};            // the process that holds it
    std::atomic<int> opened{0};           // how often
    std::atomic<std::uint64_t> reads{0};  // since it was opened
    std::atomic<int> is_torque_on{0};
    std::atomic<std::int64_t> zeroed_ns{0};  // when torque last went to zero
    std::atomic<int> zeroed_by_guard{0};
    std::atomic<int> zeroed_by_handler{0};
    std::atomic<int> is_zero_unconfirmed{0};  // does not answer at the end
    std::atomic<int> is_tried{0};             // motors are tried before it counts as opened
    std::atomic<int> is_silent{0};            // gives no angles
    std::atomic<int> is_place_known{0};       // the servo tells where the handle is
    std::atomic<int> is_set_up_anew{0};       // to be zeroed it must be set up
    std::atomic<int> handed_over{0};          // how often, from a servo that died to the next

    void put(JointTorques torques) {
        const int is_on = torques == JointTorques{} ? 0 : 1;
        if (is_torque_on.exchange(is_on) == 1 && is_on == 0) zeroed_ns = steady_now_ns();
    }

    /// Returns true if the process that held it last is gone.
    [[nodiscard]] bool is_free() const { return owner == 0 || kill(owner, 0) != 0; }
};

}  // namespace touchline
