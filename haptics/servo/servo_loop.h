// The tick with its device and its exchange, and the loop that runs it. The same code on a virtual
// clock in any thread and on the real one in the servo's.
#pragma once

#include "haptics/device/force_device.h"
#include "haptics/pantograph/profile.h"
#include "haptics/servo/exchange.h"
#include "haptics/servo/recorder.h"
#include "haptics/servo/servo_step.h"
#include "haptics/servo/tick_clock.h"

#include <atomic>
#include <cstdint>

namespace touchline {

/// Threads: one at a time; the exchange's other side may be another one.
class ServoLoop {
  public:
    /// All references must outlive the loop.
    ServoLoop(ForceDevice& device, const DeviceProfile& profile, double period_s,
              ServoExchange& exchange, Recorder& recorder)
        : device_(device), exchange_(exchange), recorder_(recorder), step_(profile, period_s) {}

    /// read -> step -> write -> publish. now_s: since the loop started, never going back.
    void tick(double now_s, std::uint64_t missed_ticks);

    /// Ticks until `is_stop_wanted`, then until force has faded out, then writes zero torque.
    void run(Clock& clock, std::int64_t period_ns, const std::atomic<bool>& is_stop_wanted);

  private:
    ForceDevice& device_;
    ServoExchange& exchange_;
    Recorder& recorder_;
    ServoStep step_;
    double delay_s_ = 0.0;  // of the last tick, from when it was due to its torques written
};

}  // namespace touchline
