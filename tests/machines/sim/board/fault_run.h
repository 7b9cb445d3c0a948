// One run of driver, link and emulated board with one fault at a moment that the seed chooses, and
// its outcome. Threads: pure.
#pragma once

#include "haptics/device/board/pantograph_board.h"
#include "tests/machines/sim/board/emulated_link.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// What can go wrong between the host and the board: the first rows of every table of faults.
struct LinkFaultKind {
    std::string_view name;
    LinkFault link = LinkFault::none;
    double longest_s = 0.0;  // the seed says how late
};

inline constexpr std::array link_fault_kinds{
    LinkFaultKind{"short", LinkFault::short_send},
    LinkFaultKind{"late send", LinkFault::late_send, 0.01},
    LinkFaultKind{"lost send", LinkFault::lost_send},
    LinkFaultKind{"unconfirmed send", LinkFault::unconfirmed_send},
    LinkFaultKind{"stall, out", LinkFault::stalled_send},
    LinkFaultKind{"late reply", LinkFault::late_reply, 0.03},
    LinkFaultKind{"lost reply", LinkFault::lost_reply},
    LinkFaultKind{"garbled", LinkFault::garbled_reply},
    LinkFaultKind{"wrong length", LinkFault::cut_reply},
    LinkFaultKind{"duplicate", LinkFault::duplicate_reply},
    LinkFaultKind{"zero-length packet", LinkFault::empty_packet},
    LinkFaultKind{"stall, in", LinkFault::stalled_reply},
    LinkFaultKind{"failed transfer", LinkFault::failed_reply},
    LinkFaultKind{"unconfigured", LinkFault::reset_board},
    LinkFaultKind{"unplugged before", LinkFault::unplugged_before},
    LinkFaultKind{"unplugged in mid-transfer", LinkFault::unplugged_after},
    LinkFaultKind{"encoder jump", LinkFault::lost_counts},
};

/// Returns these, then `more`. A Kind begins with the members of LinkFaultKind.
template <class Kind, std::size_t count>
[[nodiscard]] constexpr auto with_link_faults(const std::array<Kind, count>& more) {
    std::array<Kind, link_fault_kinds.size() + count> all{};
    std::size_t i = 0;
    for (const LinkFaultKind& kind : link_fault_kinds)
        all[i++] = Kind{kind.name, kind.link, kind.longest_s};
    for (const Kind& kind : more) all[i++] = kind;
    return all;
}

/// What can go wrong in a run: the link, or the driver's arguments.
struct FaultKind {
    std::string_view name;
    LinkFault link = LinkFault::none;
    double longest_s = 0.0;  // the seed says how late
    bool is_torque_not_finite = false;
    double clock_step_s = 0.0;
    double stall_s = 0.0;  // the loop stands still
};

[[nodiscard]] std::span<const FaultKind> fault_kinds();

struct FaultRun {
    bool was_noticed = false;    // the driver did not go on as if nothing had happened
    double zero_s = 0.0;         // from when the fault could be seen to zero torque told
    double recovery_s = 0.0;     // from the fault until angles came and torque went again
    bool has_recovered = false;  // by itself; if not, another driver reopened it, plugged in again
    bool has_reopened = false;   // after `lost`
    double reopened_s = 0.0;     // from the fault, if the plug is put back at once
    BoardState worst = BoardState::ready;
    bool is_position_doubtful = false;
    double largest_error_counts =
        0.0;                    // of angles given out, unless doubtful; beyond a tick's motion
    bool is_broken = false;     // the board was told what it must never be told
    bool is_left_zero = false;  // after stop
};

/// Returns the time from a moment to the first zero after it: 0 if torque was zero already, nothing
/// if torque went on, or went on longer than within_s.
[[nodiscard]] std::optional<double> time_to_zero(const std::vector<TorqueChange>& changes,
                                                 double from_s, double within_s = never_s);

/// Names the worst state, for a table.
[[nodiscard]] std::string words_of(BoardState state, bool is_position_doubtful);
[[nodiscard]] std::string words_of(const FaultRun& run);

/// Opens, moves a hand and pushes for 0.1 s, causes the fault, goes on for up to 5 s, stops.
[[nodiscard]] FaultRun run_fault(const FaultKind& kind, std::uint64_t seed);

}  // namespace touchline
