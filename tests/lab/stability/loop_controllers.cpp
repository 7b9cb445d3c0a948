#include "tests/lab/stability/loop_controllers.h"

#include "haptics/safety/force_chain.h"
#include "haptics/servo/loop_settings.h"
#include "haptics/servo/servo_step.h"
#include "tests/lab/bench/contact/renderers.h"

#include <array>

namespace touchline::stability {
namespace {

constexpr int local_rate = 4;
constexpr double penalty_band_m = 3e-3;  // the motors' 2 to 3 N at the default stiffness

class ShippedStep final : public LoopController {
  public:
    ShippedStep(const DeviceProfile& profile, const LoopParameters& parameters, const Scene& scene)
        : servo_(profile, parameters.period_s) {
        input_.commands.contact.stiffness_N_per_m = parameters.stiffness_N_per_m;
        input_.commands.contact.radius_m = parameters.radius_m;
        input_.commands.is_level_auto = false;
        input_.scene = &scene;
    }

    ControlOutput step(const ControlInput& input) override {
        input_.now_s = input.time_s;
        input_.missed_ticks = input.missed_ticks;
        input_.reading = input.reading;
        input_.commands.level = input.level;
        if (input.scene != nullptr) input_.scene = input.scene;
        const DeviceCommand command = servo_.step(input_);
        const HandState& hand = servo_.report().hand;
        return {command, hand.force, hand.p_WP, hand.spring_gain, hand.stiffness_N_per_m};
    }

  private:
    ServoStep servo_;
    StepInput input_;
};

/// Takes the handle and returns the force, with the least that a device needs around it.
class PlainLoop : public LoopController {
  public:
    PlainLoop(const DeviceProfile& profile, const LoopParameters& parameters)
        : profile_(profile),
          stiffness_N_per_m_(parameters.stiffness_N_per_m),
          most_N_(limits_of(profile).force_N) {}

    ControlOutput step(const ControlInput& input) override {
        const auto& told = input.reading;
        if (!told || !told->p_D || !told->jacobian)
            return {{}, {}, last_.place, 1.0, stiffness_N_per_m_};
        last_ = feel(picture_from_device(profile_, *told->p_D));
        const Force force = scenarios::limited(last_.force, most_N_);
        DeviceCommand command;
        command.torques = joint_torques(*told->jacobian, turned(force));
        return {command, force, last_.place, 1.0, stiffness_N_per_m_};
    }

  protected:
    [[nodiscard]] virtual bench::Felt feel(Position handle) = 0;

    [[nodiscard]] double stiffness_N_per_m() const { return stiffness_N_per_m_; }

  private:
    DeviceProfile profile_;
    double stiffness_N_per_m_;
    double most_N_;
    bench::Felt last_;
};

/// A renderer of the bench, whose forces are all proportional to the stiffness.
template <class Renderer>
class Rendered final : public PlainLoop {
  public:
    /// `made_of`: the renderer's parts, to make it in place, because it may refer to itself.
    template <class... Parts>
    Rendered(const DeviceProfile& profile, const LoopParameters& parameters,
             double damping_Ns_per_m, Parts&&... made_of)
        : PlainLoop(profile, parameters),
          renderer_(std::forward<Parts>(made_of)...),
          period_s_(parameters.period_s),
          damping_Ns_per_m_(damping_Ns_per_m),
          velocity_(encoder_step_m(profile)) {}

  private:
    bench::Felt feel(Position handle) override {
        if (!is_started_) renderer_.start(handle);
        is_started_ = true;
        const bench::Felt felt = renderer_.step(handle);
        const Force spring = stiffness_N_per_m() / bench::wall_N_per_m * felt.force;
        return {damped(spring, velocity_.step(handle, period_s_), damping_Ns_per_m_), felt.place};
    }

    Renderer renderer_;
    double period_s_;
    double damping_Ns_per_m_;
    VelocityEstimate velocity_;
    bool is_started_ = false;
};

/// Between two steps of the machine the wall is the tangent at its contact.
class LocalModel final : public PlainLoop {
  public:
    LocalModel(const DeviceProfile& profile, const LoopParameters& parameters, const Scene& scene)
        : PlainLoop(profile, parameters), machine_(scene, 0.0) {}

  private:
    bench::Felt feel(Position handle) override {
        if (tick_ == 0) machine_.start(handle);
        if (tick_++ % local_rate == 0) contact_ = machine_.step(handle);
        const double push_N = norm(contact_.force);
        if (!(push_N > 0.0)) return contact_;
        const Direction out = along<Direction>(contact_.force, 1.0 / push_N);
        const double depth_m = dot(out, contact_.place - handle);
        return {along<Force>(out, stiffness_N_per_m() * std::max(0.0, depth_m)), contact_.place};
    }

    bench::Machine machine_;
    bench::Felt contact_;
    std::uint64_t tick_ = 0;
};

double shipped_damping(const DeviceProfile& profile, const LoopParameters& parameters) {
    return loop_settings(profile, parameters.period_s, 0.0).damping_Ns_per_m;
}

using Made = std::unique_ptr<LoopController>;

Made shipped(const DeviceProfile& profile, const LoopParameters& parameters,
             const LoopScenario& scenario) {
    return shipped_step(profile, parameters, scenario.scene);
}

template <bool is_damped>
Made penalty(const DeviceProfile& profile, const LoopParameters& parameters,
             const LoopScenario& scenario) {
    return std::make_unique<Rendered<bench::Penalty>>(
        profile, parameters, is_damped ? shipped_damping(profile, parameters) : 0.0,
        bench::edges_of(scenario.scene.curves), penalty_band_m);
}

template <bool is_damped>
Made plain_proxy(const DeviceProfile& profile, const LoopParameters& parameters,
                 const LoopScenario& scenario) {
    return std::make_unique<Rendered<bench::PlainProxy>>(
        profile, parameters, is_damped ? shipped_damping(profile, parameters) : 0.0,
        scenario.torture.ring);
}

Made local_model(const DeviceProfile& profile, const LoopParameters& parameters,
                 const LoopScenario& scenario) {
    return std::make_unique<LocalModel>(profile, parameters, scenario.scene);
}

}  // namespace

std::unique_ptr<LoopController> shipped_step(const DeviceProfile& profile,
                                             const LoopParameters& parameters, const Scene& scene) {
    return std::make_unique<ShippedStep>(profile, parameters, scene);
}

std::span<const LoopMethod> loop_methods() {
    static constexpr std::array all = {
        LoopMethod{"shipped", 1, shipped},
        LoopMethod{"penalty", 1, penalty<false>},
        LoopMethod{"penalty + damping", 1, penalty<true>},
        LoopMethod{"plain proxy", 1, plain_proxy<false>},
        LoopMethod{"plain proxy + damping", 1, plain_proxy<true>},
        LoopMethod{"local model", local_rate, local_model},
    };
    return all;
}

}  // namespace touchline::stability
