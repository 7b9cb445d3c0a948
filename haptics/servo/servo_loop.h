// The tick with its device and its exchange, and the loop that runs it. The same code runs on a
// virtual clock in any thread and on the real clock in the servo's thread.
#pragma once

#include "haptics/device/force_device.h"
#include "haptics/pantograph/profile.h"
#include "haptics/servo/exchange.h"
#include "haptics/servo/real_time.h"
#include "haptics/servo/recorder.h"
#include "haptics/servo/rendering.h"
#include "haptics/servo/servo_step.h"

#include <atomic>
#include <cstdint>

namespace touchline {

/// What limits the loop's force, besides the hand.
struct LoopRules {
    RealTimeTier granted = RealTimeTier::best_effort;
    bool has_motors = false;     // force follows the tier; a simulation has no motors to protect
    bool watches_kiosk = false;  // without the kiosk's heartbeat there is no force
    double motor_heat = 0.0;     // at the start, >= 0 (MotorHeat)
};

/// Force is zero <= 20 ms after the last heartbeat: 10 ms of silence, then a fade of 8 ms.
inline constexpr double longest_kiosk_silence_s = 0.010;

/// Asks a loop to end, from any thread or a signal handler.
struct LoopEnd {
    std::atomic<bool> is_wanted{false};  // fade out, then end
    std::atomic<bool> is_cut{false};     // zero torque at once, then end
};

/// Threads: one at a time; the exchange's other side may be another thread.
class ServoLoop {
  public:
    /// All references must outlive the loop.
    ServoLoop(ForceDevice& device, const DeviceProfile& profile, double period_s,
              ServoExchange& exchange, Recorder& recorder, const LoopRules& rules = {});

    /// read -> step -> write -> publish. now_s: since the loop started, never going back.
    void tick(double now_s, std::uint64_t missed_ticks);

    /// Ticks until an end is wanted, here or in the channel, and force has faded out, or until it
    /// is cut. Then writes zero until the device holds it, for at most 20 periods. While
    /// ServoStep::is_resting(), ticks are due every resting_period_s.
    void run(Clock& clock, std::int64_t period_ns, const LoopEnd& end);

  private:
    /// When a tick was due and when it began, ns.
    struct Moment {
        std::int64_t due_ns = 0;
        std::int64_t begun_ns = 0;
    };

    [[nodiscard]] bool write(const DeviceCommand& command);
    void tell_guard(const StepInput& input);
    void write_last_zero(Clock& clock, TickSchedule& schedule);
    void judge_timing(double now_s, const Moment& moment, std::uint64_t missed_ticks);
    void watch(const Moment& moment);

    ForceDevice& device_;
    ServoExchange& exchange_;
    Recorder& recorder_;
    LoopRules rules_;
    TierLimits limits_;
    double period_s_;
    ShapeInHand hand_;
    ServoStep step_;
    MinuteOfTicks minute_;
    PeerWatch kiosk_;
    ForceShare share_;
    double force_share_ = 1.0;
    RealTimeTier tier_;
    std::int64_t last_begun_ns_ = 0;
    std::int64_t rest_ns_ = 0;  // more than a period, by plan, from the last tick to the next
    std::uint64_t last_missed_ = 0;
    double delay_s_ = 0.0;  // in the last tick, from its due time to its command's write
};

}  // namespace touchline
