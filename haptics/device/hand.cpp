#include "haptics/device/hand.h"

#include <algorithm>
#include <bit>
#include <iterator>

namespace touchline {

static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

Intention WaypointPath::at(double t_s) const {
    const auto after =
        std::upper_bound(waypoints_.begin(), waypoints_.end(), t_s,
                         [](double t, const Waypoint& waypoint) { return t < waypoint.t_s; });
    if (after == waypoints_.begin()) return {waypoints_.front().position, {}};
    if (after == waypoints_.end()) return {waypoints_.back().position, {}};
    const Waypoint& from = *std::prev(after);
    const auto velocity =
        along<Velocity>(after->position - from.position, 1.0 / (after->t_s - from.t_s));
    return {from.position + along<Position>(velocity, t_s - from.t_s), velocity};
}

void MouseHand::move_to(Position position) {
    if (!is_finite(position)) return;
    const auto word = [](double metres) {
        return std::uint64_t{std::bit_cast<std::uint32_t>(static_cast<float>(metres))};
    };
    packed_.store(word(position.x) << 32 | word(position.y), std::memory_order_relaxed);
}

Intention MouseHand::at(double /*t_s*/) const {
    const std::uint64_t packed = packed_.load(std::memory_order_relaxed);
    const auto metres = [](std::uint64_t word) {
        return double{std::bit_cast<float>(static_cast<std::uint32_t>(word))};
    };
    return {{metres(packed >> 32), metres(packed & 0xffffffffU)}, {}};
}

}  // namespace touchline
