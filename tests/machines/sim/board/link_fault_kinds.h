// What can go wrong between the host and the board: the first rows of every table of faults.
#pragma once

#include "tests/machines/sim/board/emulated_link.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace touchline {

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

}  // namespace touchline
