#include "haptics/servo/servo_loop.h"

namespace touchline {

void ServoLoop::tick(double now_s, std::uint64_t missed_ticks) {
    const StepInput input{now_s,
                          missed_ticks,
                          device_.read_angles(now_s),
                          exchange_.commands(),
                          exchange_.wanted_scene(),
                          delay_s_};
    recorder_.begin(step_);
    const JointTorques torques = step_.step(input);
    const bool is_refused = !device_.write_torques(torques);
    recorder_.push(record_of(input, step_, torques, is_refused));
    if (is_refused) step_.lose_device();
    if (step_.scene() == input.scene) exchange_.release_older_scenes();
    exchange_.publish(step_.report());
    for (const ContactEvent& event : step_.events()) exchange_.tell(event);
}

void ServoLoop::run(Clock& clock, std::int64_t period_ns, const std::atomic<bool>& is_stop_wanted) {
    TickSchedule schedule(clock.now_ns(), period_ns);
    bool is_stopping = false;
    while (!is_stopping || !step_.is_silent()) {
        clock.sleep_until(schedule.due_ns());
        is_stopping = is_stop_wanted.load(std::memory_order_relaxed);
        if (is_stopping) step_.fade_out();
        tick(schedule.due_s(), schedule.missed());
        const std::int64_t now_ns = clock.now_ns();
        delay_s_ = 1e-9 * static_cast<double>(now_ns - schedule.due_ns());
        schedule.finish(now_ns);
    }
    (void)device_.write_torques({});
}

}  // namespace touchline
