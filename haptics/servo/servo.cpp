#include "haptics/servo/servo.h"

#include "haptics/servo/servo_loop.h"
#include "haptics/servo/tick_clock.h"

#include <atomic>
#include <cmath>
#include <exception>
#include <future>
#include <string>
#include <thread>
#include <utility>

namespace touchline {

struct Servo::Running {
    std::unique_ptr<ForceDevice> device;
    ServoLoop loop;
    std::int64_t period_ns;
    MonotonicClock clock;
    std::atomic<bool> is_stop_wanted{false};
    RealTimeTier tier = RealTimeTier::best_effort;
    std::thread thread;

    Running(std::unique_ptr<ForceDevice> owned, const DeviceProfile& profile, double period_s,
            ServoExchange& exchange, Recorder& recorder)
        : device(std::move(owned)),
          loop(*device, profile, period_s, exchange, recorder),
          period_ns(std::llround(period_s * 1e9)) {}

    /// Returns once the thread has its priority.
    void start(bool is_real_time) {
        std::promise<RealTimeTier> promise;
        auto granted = promise.get_future();
        thread = std::thread([this, is_real_time, started = std::move(promise)]() mutable {
            started.set_value(is_real_time ? become_real_time() : RealTimeTier::best_effort);
            loop.run(clock, period_ns, is_stop_wanted);
        });
        tier = granted.get();
    }
};

Servo::Servo() = default;

Servo::~Servo() {
    stop();
}

Result<void> Servo::start(std::unique_ptr<ForceDevice> device, const DeviceProfile& profile,
                          const ServoOptions& options) {
    if (running_) return failure("the servo runs already; stop it before giving it a device");
    if (!(options.period_s >= 1e-5 && options.period_s <= 1.0)) {
        return failure("the servo's period must be 10 microseconds to 1 second");
    }
    try {
        recorder_ = Recorder(options.recorded_ticks);
        auto running = std::make_unique<Running>(std::move(device), profile, options.period_s,
                                                 exchange_, recorder_);
        running->start(options.is_real_time);
        running_ = std::move(running);
    } catch (const std::exception& e) {
        return failure(std::string("the servo thread cannot be started: ") + e.what());
    }
    return {};
}

void Servo::set(const ServoCommands& commands) {
    exchange_.set(commands);
}

void Servo::feel(std::shared_ptr<const Scene> scene) {
    exchange_.feel(std::move(scene));
}

const HandState& Servo::latest() {
    return exchange_.report().hand;
}

ForceStatus Servo::force_status() {
    return exchange_.report().force;
}

std::optional<ContactEvent> Servo::next_event() {
    return exchange_.next_event();
}

std::uint64_t Servo::dropped_events() const {
    return exchange_.dropped_events();
}

RealTimeTier Servo::tier() const {
    return running_ ? running_->tier : RealTimeTier::best_effort;
}

void Servo::stop() {
    if (!running_) return;
    running_->is_stop_wanted.store(true, std::memory_order_relaxed);
    running_->thread.join();
    running_.reset();
}

Recorder& Servo::recording() {
    return recorder_;
}

}  // namespace touchline
