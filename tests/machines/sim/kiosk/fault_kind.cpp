#include "tests/machines/sim/kiosk/fault_kind.h"

#include "tests/haptics/tick.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

constexpr double stale_s = 5e-3;
constexpr double lost_peer_s = 20e-3;
// Clearing a halt takes a millisecond: a tick that comes early after a late one finds it
// unfinished.
constexpr double halted_s = 2.0 * tick_s;
constexpr std::optional<double> goes_on{};

constexpr std::array kinds{
    SimFaultKind{"short send", LinkFault::short_send, 0.0, 0.0, tick_s},
    SimFaultKind{"late send", LinkFault::late_send, 1e-3, 1e-2, goes_on},
    SimFaultKind{"lost send", LinkFault::lost_send, 0.0, 0.0, goes_on},
    SimFaultKind{"stall, out", LinkFault::stalled_send, 0.0, 0.0, halted_s},
    SimFaultKind{"late reply", LinkFault::late_reply, 1e-3, 3e-2, stale_s},
    SimFaultKind{"lost reply", LinkFault::lost_reply, 0.0, 0.0, goes_on},
    SimFaultKind{"garbled reply", LinkFault::garbled_reply, 0.0, 0.0, goes_on},
    SimFaultKind{"wrong length", LinkFault::cut_reply, 0.0, 0.0, tick_s},
    SimFaultKind{"duplicate", LinkFault::duplicate_reply, 0.0, 0.0, tick_s},
    SimFaultKind{"zero-length packet", LinkFault::empty_packet, 0.0, 0.0, goes_on},
    SimFaultKind{"stall, in", LinkFault::stalled_reply, 0.0, 0.0, halted_s},
    SimFaultKind{"failed transfer", LinkFault::failed_reply, 0.0, 0.0, tick_s},
    SimFaultKind{"unconfigured", LinkFault::reset_board, 0.0, 0.0, stale_s + tick_s},
    SimFaultKind{"unplugged", LinkFault::unplugged_before, 0.3, 6.0, tick_s},
    SimFaultKind{"unplugged in mid-transfer", LinkFault::unplugged_after, 0.3, 6.0, tick_s},
    SimFaultKind{"encoder jump", LinkFault::lost_counts, 0.0, 0.0, tick_s},
    SimFaultKind{"angle not a number", LinkFault::none, 0.0, 0.0, tick_s},
    SimFaultKind{"servo late", LinkFault::none, 1e-4, 8e-3, goes_on},
    SimFaultKind{"machine stands still", LinkFault::none, 1e-2, 5e-2, goes_on},
    SimFaultKind{"kiosk frozen", LinkFault::none, 0.03, 1.5, lost_peer_s},
    SimFaultKind{"kiosk's main thread hangs", LinkFault::none, 0.6, 2.0, lost_peer_s},
    SimFaultKind{"screen starved", LinkFault::none, 0.05, 0.4, goes_on},
    SimFaultKind{"kiosk killed", LinkFault::none, 0.5, 2.0, lost_peer_s},
    SimFaultKind{"servo killed", LinkFault::none, 0.0, 0.0, lost_peer_s},
    SimFaultKind{"servo frozen", LinkFault::none, 0.0, 0.0, lost_peer_s + 10e-3},
    SimFaultKind{"emergency stop", LinkFault::none, 0.5, 4.0, tick_s},
    SimFaultKind{"hand off", LinkFault::none, 0.5, 25.0, goes_on},
    SimFaultKind{"handle thrown", LinkFault::none, 0.2, 0.5, goes_on},
    SimFaultKind{"decoder hangs", LinkFault::none, 6.0, 6.0, goes_on},
    SimFaultKind{"decoder crashes", LinkFault::none, 0.01, 0.5, goes_on},
    SimFaultKind{"decoder lies", LinkFault::none, 0.01, 1.0, goes_on},
    SimFaultKind{"decoder slow", LinkFault::none, 1.0, 5.5, goes_on},
    SimFaultKind{"stick yanked", LinkFault::none, 0.01, 12.0, goes_on},
    SimFaultKind{"camera lost", LinkFault::none, 0.5, 15.0, goes_on},
    SimFaultKind{"disk full", LinkFault::none, 5.0, 60.0, goes_on},
    SimFaultKind{"clock step", LinkFault::none, 5.0, 60.0, goes_on},
    SimFaultKind{"settings corrupt", LinkFault::none, 1.0, 20.0, goes_on},
    SimFaultKind{"sound lost", LinkFault::none, 1.0, 15.0, goes_on},
    SimFaultKind{"headphones out", LinkFault::none, 0.5, 20.0, goes_on},
};
static_assert(kinds.size() == sim_fault_count);

}  // namespace

std::span<const SimFaultKind> sim_fault_kinds() {
    return kinds;
}

const SimFaultKind& kind_of(SimFault fault) {
    return kinds.at(static_cast<std::size_t>(fault));
}

std::optional<SimFault> fault_named(std::string_view name) {
    const auto at = std::ranges::find(kinds, name, &SimFaultKind::name);
    if (at == kinds.end()) return std::nullopt;
    return static_cast<SimFault>(at - kinds.begin());
}

}  // namespace touchline
