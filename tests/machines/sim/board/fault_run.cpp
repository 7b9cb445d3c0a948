#include "tests/machines/sim/board/fault_run.h"

#include "tests/machines/sim/board/board_rig.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace touchline {
namespace {

constexpr double longest_run_s = 5.0;
constexpr int ticks_before = 100;
constexpr int good_ticks_that_count = 5;

constexpr auto kinds = with_link_faults(std::array{
    FaultKind{"torque not a number", LinkFault::none, 0.0, true},
    FaultKind{"clock back 10 s", LinkFault::none, 0.0, false, -10.0},
    FaultKind{"clock on 10 s", LinkFault::none, 0.0, false, 10.0},
    FaultKind{"loop stands still 50 ms", LinkFault::none, 0.0, false, 0.0, 0.05},
});

// Moves in the middle of the area, as fast as a searching hand.
std::shared_ptr<const IntendedPath> moving_hand() {
    return std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{
        {0.0, {}}, {0.2, {}}, {0.5, {0.03, 0.02}}, {1.5, {-0.03, -0.02}}, {2.0, {}}});
}

// The handle is not at home when the board is set up, but the driver knows its place.
Calibration known_start(const DeviceProfile& profile) {
    Calibration calibration;
    calibration.offset = inverse(profile.geometry, profile.centre).value() - profile.home;
    return calibration;
}

/// A run in progress.
class Run {
  public:
    Run(const FaultKind& kind, std::uint64_t seed)
        : kind_(kind), random_(seed), truth_(truth_of(seed)) {
        const PlannedFault planned{2 + ticks_before + seed % 50, kind.link, kind.longest_s * unit(),
                                   random_()};
        rig_.emplace(truth_, std::vector{planned}, known_start(truth_.profile), moving_hand());
        fault_tick_ = static_cast<int>(planned.at_send) - 2;
        push_ = {0.01 + 0.05 * unit(), -0.01 - 0.05 * unit()};
    }

    FaultRun run() {
        if (!rig_->driver->open()) return result_;
        const int last_tick = fault_tick_ + static_cast<int>(longest_run_s / rig_tick_s);
        for (int k = 0; k < last_tick && !is_over(); ++k) {
            step(k);
            if (k > fault_tick_) judge(k);
        }
        finish();
        return result_;
    }

  private:
    static BoardTruth truth_of(std::uint64_t seed) {
        BoardTruth truth;
        truth.seed = seed;
        const std::array names{"2diy-gen3.1", "2diy-gen2", "haplet"};
        truth.profile = find_profile(names[seed % names.size()]).value();
        truth.type = truth.profile.name == "haplet" ? BoardType::due : BoardType::m0;
        return truth;
    }

    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

    void step(int k) {
        JointTorques wanted = push_;
        if (k == fault_tick_ && kind_.is_torque_not_finite)
            wanted.x = std::numeric_limits<double>::quiet_NaN();
        if (k == fault_tick_) rig_->clock_step_s += kind_.clock_step_s;
        if (k == fault_tick_ + 1) rig_->time.now_s += kind_.stall_s;
        const bool is_seen_first = k == fault_tick_ + (kind_.is_torque_not_finite ? 0 : 1);
        if (is_seen_first) seen_s_ = rig_->time.now_s + rig_tick_s;
        angles_ = rig_->tick(wanted);
        recent_.push_back(rig_->board.true_angles());
        if (recent_.size() > 6) recent_.erase(recent_.begin());
        if (!angles_) return;
        if (!rig_->driver->report().is_position_doubtful)
            result_.largest_error_counts = std::max(result_.largest_error_counts, error_counts());
    }

    /// The error against the joints of the last ticks, since angles may be that old.
    double error_counts() {
        const JointAngles quantum = encoder_quantum(truth_.profile);
        double least = never_s;
        for (const JointAngles& then : recent_) {
            const JointAngles error = *angles_ - then;
            least = std::min(
                least, std::max(std::abs(error.x / quantum.x), std::abs(error.y / quantum.y)));
        }
        return least;
    }

    void judge(int k) {
        const BoardReport& report = rig_->driver->report();
        result_.worst = std::max(result_.worst, report.state);
        result_.is_position_doubtful |= report.is_position_doubtful;
        const bool is_good = angles_ && rig_->is_written && report.state == BoardState::ready;
        if (!is_good) result_.was_noticed = true;
        good_ticks_ = is_good ? good_ticks_ + 1 : 0;
        if (good_ticks_ == 1)
            result_.recovery_s = static_cast<double>(k - fault_tick_ - 1) * rig_tick_s;
    }

    /// A late reply shows only later, so the run goes on past it.
    bool is_over() const {
        const int patience = good_ticks_that_count + static_cast<int>(kind_.longest_s / rig_tick_s);
        const BoardState state = rig_->driver->report().state;
        return good_ticks_ > patience || state == BoardState::lost ||
               (state == BoardState::jumped && rig_->time.now_s > seen_s_ + 0.05);
    }

    void finish() {
        result_.has_recovered = good_ticks_ > 0;
        rig_->time.now_s += rig_tick_s;
        result_.is_broken = rig_->board.firmware().is_broken();
        rig_->board.advance_to(rig_->time.now_s);
        result_.zero_s = time_to_zero(rig_->board.told_torques(), seen_s_).value_or(never_s);
        if (rig_->driver->report().state == BoardState::lost) reopen();
        rig_->driver->stop();
        result_.is_left_zero = rig_->held() == JointTorques{};
    }

    void reopen() {
        if (!rig_->board.is_plugged()) rig_->board.plug();
        rig_->connect({}, known_start(truth_.profile));
        if (!rig_->driver->open()) return;
        rig_->tick_for(0.02, push_);
        result_.has_reopened = rig_->tick(push_).has_value() && rig_->is_written;
        result_.reopened_s = rig_->time.now_s - seen_s_;
    }

    FaultKind kind_;
    std::mt19937_64 random_;
    BoardTruth truth_;
    std::optional<BoardRig> rig_;
    JointTorques push_;
    int fault_tick_ = 0;
    double seen_s_ = 0.0;
    int good_ticks_ = 0;
    std::optional<JointAngles> angles_;
    std::vector<JointAngles> recent_;  // true angles
    FaultRun result_;
};

}  // namespace

std::span<const FaultKind> fault_kinds() {
    return kinds;
}

std::optional<double> time_to_zero(const std::vector<TorqueChange>& changes, double from_s,
                                   double within_s) {
    JointTorques held;
    for (const TorqueChange& change : changes) {
        const double after_s = change.at_s - from_s;
        if (after_s > within_s || (after_s > 0.0 && held == JointTorques{})) break;
        held = change.torques;
        if (after_s > 0.0 && held == JointTorques{}) return after_s;
    }
    return held == JointTorques{} ? std::optional(0.0) : std::nullopt;
}

std::string words_of(BoardState state, bool is_position_doubtful) {
    constexpr std::array names{"closed", "ready", "resyncing", "jumped", "lost"};
    const std::string name = names[static_cast<std::size_t>(state)];
    return is_position_doubtful && state != BoardState::jumped ? name + ", place doubtful" : name;
}

std::string words_of(const FaultRun& run) {
    return words_of(run.worst, run.is_position_doubtful);
}

FaultRun run_fault(const FaultKind& kind, std::uint64_t seed) {
    return Run(kind, seed).run();
}

}  // namespace touchline
