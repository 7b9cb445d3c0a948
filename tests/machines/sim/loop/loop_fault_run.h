// One run of the servo's whole loop - safety, driver, link, emulated board - with a hand that
// presses against a wall, and one fault at a moment that the seed chooses. On a virtual clock.
// Threads: pure.
#pragma once

#include "config/types/hand_state.h"
#include "tests/machines/sim/board/emulated_link.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace touchline {

/// What happens to the loop apart from its link.
enum class LoopEvent : std::uint8_t {
    none,
    angles_not_finite,  // the device gives NaN
    stall,              // the machine stands still
    kiosk_freezes,      // no more beats
    kiosk_hangs,        // no beat for half a second
    kiosk_dies,         // the socket closes, the kernel sends SIGHUP: the loop is cut
};

struct LoopFaultKind {
    std::string_view name;
    LinkFault link = LinkFault::none;
    double longest_s = 0.0;  // the seed says how late
    LoopEvent event = LoopEvent::none;
};

[[nodiscard]] std::span<const LoopFaultKind> loop_fault_kinds();

struct LoopFaultRun {
    bool was_pressed = false;        // there was torque just before
    std::optional<double> zero_s;    // from when it could be seen to zero torque told; none: never
    Fault fault = Fault::none;       // the gravest that was told
    std::optional<double> back_s;    // from the fault until torque acts again
    bool is_back_by_itself = false;  // if not: the operator cleared it, or another servo started
    bool was_pushed_before_arm = false;  // torque came back while the hand was still pressing
    bool is_left_zero = false;           // at the end
};

/// Arms, presses, causes the fault; lifts the hand, presses again, ends.
[[nodiscard]] LoopFaultRun run_loop_fault(const LoopFaultKind& kind, std::uint64_t seed);

}  // namespace touchline
