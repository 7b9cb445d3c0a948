#include "haptics/servo/servo.h"

#include "haptics/servo/servo_loop.h"

#include <atomic>
#include <cmath>
#include <exception>
#include <future>
#include <string>
#include <thread>

namespace touchline {

struct Servo::Running {
    std::unique_ptr<ForceDevice> device;
    MonotonicClock clock;
    LoopEnd end;
    std::thread thread;

    /// Returns once the thread has its priority and the loop knows its tier.
    void start(const DeviceProfile& profile, const ServoOptions& options, ServoExchange& exchange,
               Recorder& recorder) {
        std::promise<void> promise;
        auto ready = promise.get_future();
        thread = std::thread([&, this, started = std::move(promise)]() mutable {
            const auto period_ns = static_cast<std::int64_t>(std::llround(options.period_s * 1e9));
            LoopRules rules;
            rules.has_motors = options.has_motors;
            rules.watches_kiosk = options.watches_kiosk;
            rules.motor_heat = options.motor_heat;
            if (options.is_real_time) rules.granted = become_real_time(options.lock);
            ServoLoop loop(*device, profile, options.period_s, exchange, recorder, rules);
            started.set_value();
            exchange.channel().begin_loop();
            loop.run(clock, period_ns, end);
            exchange.channel().end_loop();
        });
        ready.wait();
    }
};

Servo::Servo() = default;

Servo::Servo(ServoChannel& channel) : exchange_(channel) {}

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
        auto running = std::make_unique<Running>();
        running->device = std::move(device);
        running->start(profile, options, exchange_, recorder_);
        running_ = std::move(running);
    } catch (const std::exception& e) {
        return failure(std::string("the servo thread cannot be started: ") + e.what());
    }
    return {};
}

std::optional<RealTimeTier> Servo::tier() const {
    return running_ ? tier_of(exchange_.channel()) : std::nullopt;
}

std::unique_ptr<ForceDevice> Servo::stop() {
    if (!running_) return nullptr;
    running_->end.is_wanted.store(true, std::memory_order_relaxed);
    running_->thread.join();
    auto device = std::move(running_->device);
    running_.reset();
    return device;
}

void Servo::cut() noexcept {
    if (running_) running_->end.is_cut.store(true, std::memory_order_relaxed);
}

}  // namespace touchline
