#include "haptics/servo/servo_loop.h"

#include <algorithm>

namespace touchline {
namespace {

constexpr int last_writes = 20;  // ticks; a send that hangs is cancelled within two

// A step of silence counts for at most this many periods: what stops this loop stops the kiosk too.
constexpr double most_periods_of_silence = 2.0;

DeviceProfile limited(DeviceProfile profile, const TierLimits& limits) {
    profile.force_limit_N = limits.force_share * std::min(profile.force_limit_N, most_force_N);
    return profile;
}

}  // namespace

ServoLoop::ServoLoop(ForceDevice& device, const DeviceProfile& profile, double period_s,
                     ServoExchange& exchange, Recorder& recorder, const LoopRules& rules)
    : device_(device),
      exchange_(exchange),
      recorder_(recorder),
      rules_(rules),
      limits_(rules.has_motors ? limits_of(rules.granted) : TierLimits{}),
      period_s_(period_s),
      step_(limited(profile, limits_), period_s, limits_),
      kiosk_(longest_kiosk_silence_s, most_periods_of_silence * period_s),
      tier_(rules.granted) {
    step_.lend(&hand_);
    step_.warm(rules.motor_heat);
    exchange_.channel().tier.store(static_cast<std::uint8_t>(tier_), std::memory_order_relaxed);
}

/// Returns false if the device refused. Until the device holds zero, anyone who finds this loop
/// dead must assume that there is torque.
bool ServoLoop::write(const DeviceCommand& command) {
    const bool is_zero = command == DeviceCommand{};
    std::atomic<std::uint8_t>& is_force_on = exchange_.channel().is_force_on;
    if (!is_zero) is_force_on.store(1, std::memory_order_release);
    const bool is_taken = device_.write(command);
    if (is_zero && is_taken) is_force_on.store(0, std::memory_order_release);
    return is_taken || is_zero;
}

void ServoLoop::tick(double now_s, std::uint64_t missed_ticks) {
    StepInput input;
    input.now_s = now_s;
    input.missed_ticks = missed_ticks;
    input.reading = device_.read(now_s);
    input.commands = exchange_.commands();
    input.scene = exchange_.wanted_scene();
    input.delay_s = delay_s_;
    input.force_share = force_share_;
    recorder_.begin(step_);
    const DeviceCommand command = step_.step(input);
    const bool is_refused = !write(command);
    recorder_.push(record_of(input, step_, command, is_refused));
    if (is_refused) step_.lose_device();
    if (step_.scene() == input.scene) exchange_.release_older_scenes();
    exchange_.publish(step_.report());
    tell_guard(input);
    for (const ContactEvent& event : step_.events()) exchange_.tell(event);
}

void ServoLoop::tell_guard(const StepInput& input) {
    ServoChannel& channel = exchange_.channel();
    channel.is_device_silent.store(input.reading ? 0 : 1, std::memory_order_relaxed);
    channel.fault.store(static_cast<std::uint8_t>(step_.report().force.fault),
                        std::memory_order_relaxed);
    channel.motor_heat.store(step_.motor_heat(), std::memory_order_relaxed);
    if (!input.reading) return;
    channel.joint_1.store(input.reading->joints.x, std::memory_order_relaxed);
    channel.joint_2.store(input.reading->joints.y, std::memory_order_relaxed);
}

void ServoLoop::judge_timing(double now_s, const Moment& moment, std::uint64_t missed_ticks) {
    const std::int64_t late_ns = moment.begun_ns - moment.due_ns;
    exchange_.channel().lateness.add(late_ns);
    minute_.add(now_s, 1e-9 * static_cast<double>(late_ns),
                1e-9 * static_cast<double>(moment.begun_ns - last_begun_ns_ - rest_ns_),
                missed_ticks - last_missed_);
    last_missed_ = missed_ticks;
    tier_ = judge(rules_.granted, minute_.last_minute(), period_s_);
    exchange_.channel().tier.store(static_cast<std::uint8_t>(tier_), std::memory_order_relaxed);
}

/// Works out the share of the force that the kiosk's life and the tier allow.
void ServoLoop::watch(const Moment& moment) {
    ServoChannel& channel = exchange_.channel();
    const double dt_s = 1e-9 * static_cast<double>(moment.begun_ns - last_begun_ns_);
    const bool is_kiosk_lost =
        kiosk_.step(channel.kiosk_beats.load(std::memory_order_relaxed), dt_s) &&
        rules_.watches_kiosk;
    const bool is_too_late = rules_.has_motors && tier_ == RealTimeTier::too_late;
    force_share_ = share_.step(is_kiosk_lost || is_too_late, std::max(dt_s, period_s_));
    channel.servo_beats.fetch_add(1, std::memory_order_relaxed);
}

void ServoLoop::run(Clock& clock, std::int64_t period_ns, const LoopEnd& end) {
    TickSchedule schedule(clock.now_ns(), period_ns);
    last_begun_ns_ = schedule.due_ns();
    bool is_stopping = false;
    while (!end.is_cut.load(std::memory_order_relaxed) && (!is_stopping || !step_.is_silent())) {
        clock.sleep_until(schedule.due_ns());
        const Moment moment{schedule.due_ns(), clock.now_ns()};
        is_stopping = end.is_wanted.load(std::memory_order_relaxed) ||
                      exchange_.channel().is_stop_wanted.load(std::memory_order_relaxed) != 0;
        if (is_stopping) step_.fade_out();
        judge_timing(schedule.due_s(), moment, schedule.missed());
        watch(moment);
        last_begun_ns_ = moment.begun_ns;
        tick(schedule.due_s(), schedule.missed());
        const std::int64_t now_ns = clock.now_ns();
        delay_s_ = 1e-9 * static_cast<double>(now_ns - schedule.due_ns());
        const std::int64_t periods = step_.is_resting() ? resting_periods(period_s_) : 1;
        rest_ns_ = (periods - 1) * period_ns;
        schedule.finish(now_ns, periods);
    }
    write_last_zero(clock, schedule);
}

void ServoLoop::write_last_zero(Clock& clock, TickSchedule& schedule) {
    const std::atomic<std::uint8_t>& is_force_on = exchange_.channel().is_force_on;
    (void)write({});
    for (int i = 0; i < last_writes && is_force_on.load(std::memory_order_relaxed) != 0; ++i) {
        clock.sleep_until(schedule.due_ns());
        (void)device_.read(schedule.due_s());
        (void)write({});
        schedule.finish(clock.now_ns());
    }
}

}  // namespace touchline
