#include "tests/lab/bench/tracing/trace.h"

#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/servo/servo_step.h"
#include "tests/lab/bench/tracing/follower.h"
#include "tests/lab/bench/tracing/wall_follower.h"

#include <algorithm>
#include <memory>

namespace touchline::bench {
namespace {

constexpr double period_s = 1e-3;
constexpr double getting_ready_s = 1.0;  // for the force to come on
constexpr int ticks_per_place = 2;
constexpr int ticks_per_way = 10;

/// Goes where it was last told. Threads: one.
class LedHand final : public IntendedPath {
  public:
    explicit LedHand(Position start) : now_{start, {}} {}

    void mean(const Intention& intention) { now_ = intention; }

    [[nodiscard]] Intention at(double) const override { return now_; }

  private:
    Intention now_;
};

/// A relaxed hand: it means to be where it is.
class RelaxedHand {
  public:
    Intention step(Position handle, double dt_s) {
        constexpr double gives_way_s = 0.02;
        if (is_first_) meant_ = handle;
        is_first_ = false;
        meant_ += dt_s / gives_way_s * (handle - meant_);
        return {meant_, {}};
    }

  private:
    Position meant_;
    bool is_first_ = true;
};

ServoCommands commands_of(Tracing tracing) {
    ServoCommands commands;
    commands.contact.mode = tracing == Tracing::wall ? Mode::wall : Mode::groove;
    commands.contact.radius_m = tracing == Tracing::wall ? 0.0014 : 0.0;
    commands.is_force_wanted = tracing != Tracing::forces_off;
    return commands;
}

/// Servo, device and hand on one clock.
class Rig {
  public:
    Rig(const Scene& scene, Tracing tracing, Position start)
        : hand_(std::make_shared<LedHand>(start)),
          device_(default_profile(), {}, hand_),
          servo_(default_profile(), period_s),
          scene_(scene),
          commands(commands_of(tracing)) {}

    const HandState& tick() {
        const double now_s = period_s * static_cast<double>(ticks_++);
        const StepInput input{now_s, 0, device_.read(now_s), commands, &scene_};
        (void)device_.write(servo_.step(input));
        return servo_.report().hand;
    }

    void mean(const Intention& intention) { hand_->mean(intention); }

  private:
    std::shared_ptr<LedHand> hand_;
    SimulatedPantograph device_;
    ServoStep servo_;
    const Scene& scene_;
    std::uint64_t ticks_ = 0;

  public:
    ServoCommands commands;
};

template <class Step>
Traced run(Rig& rig, double limit_s, Step&& step) {
    Traced traced;
    const int ticks = static_cast<int>(limit_s / period_s);
    for (int i = 0; i < ticks; ++i) {
        const HandState& hand = rig.tick();
        traced.most_N = std::max(traced.most_N, norm(hand.force));
        traced.time_s = period_s * (i + 1);
        const auto [is_on_line, is_done] = step(hand);
        if (is_on_line && i % ticks_per_place == 0) traced.path.push_back(hand.p_WH);
        if (i % ticks_per_way == 0) traced.way.push_back(hand.p_WH);
        if (is_done) break;
    }
    return traced;
}

struct Doing {
    bool is_on_line = false;
    bool is_done = false;
};

template <class Follower>
Traced follow(Rig& rig, double limit_s, Follower follower) {
    return run(rig, limit_s, [&](const HandState& hand) {
        rig.mean(follower.step({hand.p_WH, hand.force}, period_s));
        return Doing{follower.is_on_line(), follower.is_done()};
    });
}

Traced be_led(Rig& rig, double limit_s) {
    rig.commands.guidance = {GuidanceKind::tour, false, 1, -1, {}, 0.04};
    RelaxedHand relaxed;
    return run(rig, limit_s, [&](const HandState& hand) {
        rig.mean(relaxed.step(hand.p_WH, period_s));
        return Doing{hand.guidance.is_on_line, hand.guidance.phase == GuidancePhase::arrived};
    });
}

}  // namespace

Traced trace(const Scene& scene, Tracing tracing, Position start, double limit_s) {
    Rig rig(scene, tracing, start);
    HandState ready;
    RelaxedHand relaxed;  // so that no line pushes, or force would not come on
    for (int i = 0; i < static_cast<int>(getting_ready_s / period_s); ++i) {
        ready = rig.tick();
        rig.mean(relaxed.step(ready.p_WH, period_s));
    }
    if (tracing == Tracing::tour) return be_led(rig, limit_s);
    if (tracing == Tracing::wall) return follow(rig, limit_s, WallFollower(scene.area, ready.p_WH));
    return follow(rig, limit_s, GrooveFollower(scene.area, ready.p_WH));
}

}  // namespace touchline::bench
