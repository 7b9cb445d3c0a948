// What can go wrong at a simulated site, and how soon the motors must then be without torque.
// Threads: constant data.
#pragma once

#include "tests/machines/sim/board/emulated_link.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace touchline {

/// The order is that of sim_fault_kinds().
enum class SimFault : std::uint8_t {
    short_send,
    late_send,
    lost_send,
    stalled_send,
    late_reply,
    lost_reply,
    garbled_reply,
    cut_reply,
    duplicate_reply,
    empty_packet,
    stalled_reply,
    failed_reply,
    reset_board,
    unplugged_before,
    unplugged_after,
    lost_counts,
    angle_not_a_number,
    servo_late,
    machine_stands_still,
    kiosk_frozen,
    kiosk_hangs,
    screen_starved,
    kiosk_killed,
    servo_killed,
    servo_frozen,
    emergency_stop,
    hand_off,
    handle_thrown,
    decoder_hangs,
    decoder_crashes,
    decoder_lies,
    decoder_slow,
    stick_yanked,
    camera_lost,
    disk_full,
    clock_step,
    settings_corrupt,
    sound_lost,
    headphones_out,
};

inline constexpr std::size_t sim_fault_count = 39;

struct SimFaultKind {
    std::string_view name;
    LinkFault link = LinkFault::none;  // fault of the board's link
    double shortest_s = 0.0;           // of its duration, or of its delay
    double longest_s = 0.0;
    /// The most time from when it can be seen to zero torque; none: the force may go on. The bars
    /// are those of tests/machines/sim/loop: 1 ms for what a tick sees, 5 ms for what is stale, 20
    /// ms for a lost peer, and 10 ms for a send that hangs, which blocks the zero too. `wire_s` is
    /// added.
    std::optional<double> zero_s;
};

/// The time from the host's send to the board's motors.
inline constexpr double wire_s = 3e-4;

[[nodiscard]] std::span<const SimFaultKind> sim_fault_kinds();

[[nodiscard]] const SimFaultKind& kind_of(SimFault fault);

/// Returns nothing if no fault has this name.
[[nodiscard]] std::optional<SimFault> fault_named(std::string_view name);

/// All kinds, one bit each.
inline constexpr std::uint64_t all_faults = (std::uint64_t{1} << sim_fault_count) - 1;

[[nodiscard]] constexpr std::uint64_t bit_of(SimFault fault) {
    return std::uint64_t{1} << static_cast<unsigned>(fault);
}

}  // namespace touchline
