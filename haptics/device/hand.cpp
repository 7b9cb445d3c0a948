#include "haptics/device/hand.h"

#include <algorithm>
#include <bit>
#include <iterator>

namespace touchline {

static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

namespace {

Intention at_rest(const WaypointPath::Waypoint& waypoint) {
    return {waypoint.position, {}, waypoint.angle_rad, 0.0};
}

}  // namespace

Intention WaypointPath::at(double t_s) const {
    const auto after = std::ranges::upper_bound(waypoints_, t_s, {}, &Waypoint::t_s);
    if (after == waypoints_.begin()) return at_rest(waypoints_.front());
    if (after == waypoints_.end()) return at_rest(waypoints_.back());
    const Waypoint& from = *std::prev(after);
    const double span_s = after->t_s - from.t_s;
    const auto velocity = along<Velocity>(after->position - from.position, 1.0 / span_s);
    const double turn_rad_per_s = (after->angle_rad - from.angle_rad) / span_s;
    const double since_s = t_s - from.t_s;
    return {from.position + along<Position>(velocity, since_s), velocity,
            from.angle_rad + since_s * turn_rad_per_s, turn_rad_per_s};
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
    Intention intention;
    intention.position = {metres(packed >> 32), metres(packed & 0xffffffffU)};
    return intention;
}

}  // namespace touchline
