// What the motors are told of the force that should push the hand: the force chain, with the watch
// over ringing that softens the springs from the next tick on.
// Threads: one, the servo's. A plain value; no allocation, lock, clock or log.
#pragma once

#include "haptics/safety/force_chain.h"
#include "haptics/safety/stability_monitor.h"
#include "haptics/servo/hand_force.h"

#include <cstdint>

namespace touchline {

class MotorForce {
  public:
    explicit MotorForce(const DeviceProfile& profile) : chain_(limits_of(profile)) {}

    /// Advances one tick; `period_s` > 0 is the planned one. `is_fading`: force to zero within 50
    /// ms. A device that has been silent for 20 ms, or that took no torques, is a fault.
    [[nodiscard]] SafeForce step(const DeviceProfile& profile, const StepInput& input,
                                 const HandleReading& handle, const WantedForce& wanted,
                                 bool is_fading, double period_s);

    /// Tells it that the device took no torques.
    void lose_device() { is_refused_ = true; }

    [[nodiscard]] bool is_silent() const { return chain_.is_faded(); }

    [[nodiscard]] bool is_live() const { return chain_.state() == ForceState::live; }

    /// Of the springs, below 1 where they rang.
    [[nodiscard]] double spring_gain() const { return monitor_.gain(); }

    [[nodiscard]] const ForceStatus& status() const { return chain_.status(); }

  private:
    void watch(Force told, const HandleReading& handle, const WantedForce& wanted);

    ForceChain chain_;
    StabilityMonitor monitor_;
    double ceiling_N_ = most_force_N;
    bool is_refused_ = false;  // the last torques were
    std::uint32_t faults_cleared_ = 0;
};

}  // namespace touchline
