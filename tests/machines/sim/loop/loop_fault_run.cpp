#include "tests/machines/sim/loop/loop_fault_run.h"

#include "haptics/servo/servo_loop.h"
#include "tests/haptics/servo/rigs.h"
#include "tests/machines/sim/board/board_rig.h"
#include "tests/machines/sim/board/fault_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <utility>

namespace touchline {
namespace {

constexpr auto kinds = with_link_faults(std::array{
    LoopFaultKind{"angle not a number", LinkFault::none, 0.0, LoopEvent::angles_not_finite},
    LoopFaultKind{"machine stands still", LinkFault::none, 0.05, LoopEvent::stall},
    LoopFaultKind{"kiosk frozen", LinkFault::none, 0.0, LoopEvent::kiosk_freezes},
    LoopFaultKind{"kiosk hangs 0.5 s", LinkFault::none, 0.0, LoopEvent::kiosk_hangs},
    LoopFaultKind{"kiosk killed", LinkFault::none, 0.0, LoopEvent::kiosk_dies},
});

constexpr std::int64_t tick_ns = 1'000'000;
constexpr int first_fault_tick = 1050;
constexpr double hang_s = 0.5;
constexpr double lifted_s = 1.6, pressed_again_s = 2.7, end_s = 3.1;
constexpr double operator_s = 1.7;
constexpr double return_s = 0.3;  // the hand goes to the start
constexpr Position start{0.0, -0.015};

/// Goes from where the hand is to the start, waits there until armed, presses into the line and
/// along it, lifts, and presses again.
WaypointPath pressing(double now_s, Position here) {
    const double from_s = now_s + return_s;
    return WaypointPath({{now_s, here},
                         {from_s, start},
                         {from_s + 0.75, start},
                         {from_s + 0.95, {0.0, 0.008}},
                         {from_s + lifted_s, {0.01, 0.008}},
                         {from_s + lifted_s + 0.2, {0.01, -0.015}},
                         {from_s + pressed_again_s - 0.2, start},
                         {from_s + pressed_again_s, {0.0, 0.008}},
                         {from_s + end_s, {0.01, 0.008}}});
}

/// A hand that can be given another path.
class LedHand final : public IntendedPath {
  public:
    [[nodiscard]] Intention at(double t_s) const override { return way.at(t_s); }

    WaypointPath way = pressing(0.0, start);
};

/// A clock on the rig's time; it calls back before each tick.
class RigClock final : public Clock {
  public:
    RigClock(VirtualTime& time, std::function<void()> before_tick)
        : time_(time), before_tick_(std::move(before_tick)) {}

    [[nodiscard]] std::int64_t now_ns() override { return std::llround(1e9 * time_.now_s); }

    void sleep_until(std::int64_t t_ns) override {
        time_.now_s = std::max(time_.now_s, 1e-9 * static_cast<double>(t_ns));
        time_.now_s += std::exchange(late_s, 0.0);
        before_tick_();
    }

    double late_s = 0.0;

  private:
    VirtualTime& time_;
    std::function<void()> before_tick_;
};

/// The driver, except for one reading that is NaN.
class MaybeBroken final : public JointDevice {
  public:
    explicit MaybeBroken(JointDevice& device)
        : JointDevice(default_profile().geometry), device_(device) {}

    [[nodiscard]] std::optional<JointAngles> read_angles(double now_s) override {
        auto angles = device_.read_angles(now_s);
        if (std::exchange(is_next_broken, false) && angles)
            angles->y = std::numeric_limits<double>::quiet_NaN();
        return angles;
    }

    [[nodiscard]] Freshness freshness() const override { return device_.freshness(); }

    [[nodiscard]] bool write_torques(JointTorques torques) override {
        return device_.write_torques(torques);
    }

    bool is_next_broken = false;

  private:
    JointDevice& device_;
};

class Run {
  public:
    Run(const LoopFaultKind& kind, std::uint64_t seed)
        : kind_(kind), random_(seed), fault_tick_(first_fault_tick + static_cast<int>(seed % 50)) {
        BoardTruth truth;
        truth.seed = seed;
        // Opening takes two sends, and each tick takes one.
        const auto at_send = static_cast<std::size_t>(fault_tick_) + 2;
        late_s_ = kind.longest_s * std::uniform_real_distribution<double>(0.1, 1.0)(random_);
        rig_.emplace(truth, std::vector{PlannedFault{at_send, kind.link, late_s_, random_()}},
                     calibration_at(truth.profile, start), hand_);
    }

    LoopFaultRun run() {
        press(true);
        if (!result_.back_s && kind_.event != LoopEvent::kiosk_freezes) press_another_servo();
        rig_->driver->stop();
        result_.is_left_zero = rig_->held() == JointTorques{};
        return result_;
    }

  private:
    /// The handle's place is known, as after homing.
    static Calibration calibration_at(const DeviceProfile& profile, Position p_W) {
        Calibration calibration;
        calibration.offset = angles_at(profile, p_W) - profile.home;
        return calibration;
    }

    /// Runs a whole session of one servo.
    void press(bool has_fault) {
        rig_->time.now_s += return_s;
        rig_->board.advance_to(rig_->time.now_s);
        if (!rig_->driver->open()) return;
        MaybeBroken device(*rig_->driver);
        ServoExchange exchange;
        Recorder recorder;
        LoopRules rules;
        rules.granted = RealTimeTier::fifo;
        rules.watches_kiosk = true;
        ServoLoop loop(device, rig_->board.truth().profile, 1e-3, exchange, recorder, rules);
        exchange.feel(line_scene(0.0));
        LoopEnd end;
        start_s_ = rig_->time.now_s;
        int tick = 0;
        RigClock clock(rig_->time, [&] {
            if (has_fault && tick == fault_tick_) cause(clock, device, end);
            if (is_kiosk_alive()) ++exchange.channel().kiosk_beats;
            if (since_start_s() > operator_s && kind_.event == LoopEvent::angles_not_finite)
                clear_fault(exchange);
            if (since_start_s() > end_s) end.is_wanted = true;
            look(exchange.report().force, has_fault, tick++);
        });
        loop.run(clock, tick_ns, end);
        // A servo that is cut gives its device back.
        if (kind_.event == LoopEvent::kiosk_dies) rig_->driver->stop();
        if (!has_fault) return;
        rig_->time.now_s += 1e-3;  // by then the last command has arrived
        rig_->board.advance_to(rig_->time.now_s);
        result_.zero_s = time_to_zero(rig_->board.told_torques(), seen_s_, within_s);
    }

    void press_another_servo() {
        if (!rig_->board.is_plugged()) rig_->board.plug();
        const double fault_s = seen_s_;
        rig_->board.advance_to(rig_->time.now_s);
        hand_->way = pressing(rig_->time.now_s, rig_->board.plant().tip().position);
        rig_->connect({}, calibration_at(rig_->board.truth().profile, start));
        press(false);
        if (first_torque_s_) result_.back_s = *first_torque_s_ - fault_s;
    }

    [[nodiscard]] double since_start_s() const { return rig_->time.now_s - start_s_; }

    /// Causes the fault; link faults come by themselves with this tick's send.
    void cause(RigClock& clock, MaybeBroken& device, LoopEnd& end) {
        seen_s_ = rig_->time.now_s + (kind_.link == LinkFault::none ? 0.0 : 1e-3);
        if (kind_.event == LoopEvent::angles_not_finite) device.is_next_broken = true;
        if (kind_.event == LoopEvent::stall) seen_s_ += clock.late_s = late_s_;
        if (kind_.event == LoopEvent::kiosk_dies) end.is_cut = true;
        if (kind_.event == LoopEvent::kiosk_hangs) silent_until_s_ = rig_->time.now_s + hang_s;
        if (kind_.event == LoopEvent::kiosk_freezes)
            silent_until_s_ = std::numeric_limits<double>::infinity();
    }

    [[nodiscard]] bool is_kiosk_alive() const { return rig_->time.now_s >= silent_until_s_; }

    static void clear_fault(ServoExchange& exchange) {
        ServoCommands commands;
        commands.faults_cleared = 1;
        exchange.set(commands);
    }

    void look(const ForceStatus& force, bool has_fault, int tick) {
        const bool is_on = rig_->held() != JointTorques{};
        if (!has_fault) {
            if (is_on && !first_torque_s_ && since_start_s() > 0.9)
                first_torque_s_ = rig_->time.now_s;
            return;
        }
        if (tick == fault_tick_) result_.was_pressed = is_on;
        if (tick <= fault_tick_ + 1) return;
        result_.fault = std::max(result_.fault, force.fault);
        was_off_ = was_off_ || !is_on;
        if (was_off_ && is_on && !result_.back_s) {
            result_.back_s = rig_->time.now_s - seen_s_;
            result_.is_back_by_itself = kind_.event != LoopEvent::angles_not_finite;
        }
        const bool was_in_fault = result_.fault != Fault::none;
        if (is_on && was_off_ && was_in_fault && since_start_s() < lifted_s)
            result_.was_pushed_before_arm = true;
    }

    static constexpr double within_s = 0.2;  // later zeros come from lifting the hand

    LoopFaultKind kind_;
    std::mt19937_64 random_;
    int fault_tick_;
    double late_s_ = 0.0;
    std::shared_ptr<LedHand> hand_ = std::make_shared<LedHand>();
    std::optional<BoardRig> rig_;
    double start_s_ = 0.0;
    double seen_s_ = 0.0;
    double silent_until_s_ = 0.0;
    bool was_off_ = false;
    std::optional<double> first_torque_s_;  // of the servo after the fault
    LoopFaultRun result_;
};

}  // namespace

std::span<const LoopFaultKind> loop_fault_kinds() {
    return kinds;
}

LoopFaultRun run_loop_fault(const LoopFaultKind& kind, std::uint64_t seed) {
    return Run(kind, seed).run();
}

}  // namespace touchline
