#include "app/force/servo/watched_board.h"

#include "app/force/device/procedures.h"

#include <algorithm>

namespace touchline {
namespace {

constexpr double longest_homing_s = 86400.0;  // a kiosk waits for anybody to come
constexpr std::int64_t shortest_sleep_ns = 100'000'000;
constexpr double longest_absence_s = 2.0;  // of a servo

}  // namespace

Result<void> WatchedBoard::open(bool is_homed_first, const Opening& opening, Clock& clock) {
    if (auto opened = board_.open(); !opened || !is_homed_first) return opened;
    const Calibration stored = board_.frame().calibration();
    const auto found = make_ready(
        {board_, clock, opening.goes_on, opening.say, longest_homing_s, opening.mark_force},
        stored);
    if (!found) return tl::unexpected(found.error());
    drift_ = DriftWatch(homing_plan(profile(), found->stop_off));
    opening.keep(*found);
    return {};
}

bool WatchedBoard::take_over(const Handover& from) {
    const double age_s = 1e-9 * static_cast<double>(steady_now_ns() - from.seen_ns);
    const bool has_slept = slept_() - from.place.slept_ns > shortest_sleep_ns;
    if (has_slept || !(age_s <= longest_absence_s)) return false;
    const Calibration bare = board_.frame().calibration();
    Calibration placed = bare;
    placed.offset = from.place.offset;
    board_.set_calibration(placed);
    if (!board_.take_over(from.last, age_s)) {
        board_.set_calibration(bare);
        return false;
    }
    awake_since_ns_ = from.place.slept_ns;
    return true;
}

std::optional<JointAngles> WatchedBoard::read_angles(double now_s) {
    // The loop starts after homing: what the hand did meanwhile counts as no jump.
    if (!(now_s >= last_s_)) board_.accept_position();
    const auto angles = board_.read_angles(now_s);
    const BoardReport& report = board_.report();
    const bool has_drifted = angles && drift_.step(*angles, std::max(0.0, now_s - last_s_));
    last_s_ = now_s;
    const bool has_slept = slept_() - awake_since_ns_ > shortest_sleep_ns;
    if (has_slept || has_drifted || report.is_position_doubtful ||
        report.state == BoardState::jumped)
        has_lost_place_ = true;
    return has_lost_place_ ? std::nullopt : angles;
}

}  // namespace touchline
