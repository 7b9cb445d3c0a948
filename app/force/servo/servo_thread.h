// The servo as a thread of the kiosk, for a simulated device.
// Threads: as ServoClient. start() first.
#pragma once

#include "app/force/servo/black_box.h"
#include "app/force/servo/servo_client.h"
#include "haptics/servo/servo.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace touchline {

class ServoThread final : public ServoClient {
  public:
    /// As Servo::start().
    [[nodiscard]] Result<void> start(std::unique_ptr<ForceDevice> device,
                                     const DeviceProfile& profile) {
        ServoOptions options;
        options.recorded_ticks = recorded_ticks(options.period_s);
        box_.emplace(
            recordings_folder(), std::string(profile.name),
            [this](const std::string& line) { notice_ += (notice_.empty() ? "" : "; ") + line; });
        return servo_.start(std::move(device), profile, options);
    }

    void set(const ServoCommands& commands) override { servo_.set(commands); }

    void feel(const FeltPicture& picture) override {
        box_->remember(picture.recorded);
        servo_.feel(picture.scene);
    }

    [[nodiscard]] const HandState& latest() override {
        const HandState& hand = servo_.latest();
        box_->update(servo_.recording(), servo_.force_status().fault);
        return hand;
    }

    [[nodiscard]] ForceStatus force_status() override { return servo_.force_status(); }

    [[nodiscard]] std::optional<ContactEvent> next_event() override { return servo_.next_event(); }

    [[nodiscard]] std::optional<RealTimeTier> tier() const override { return servo_.tier(); }

    [[nodiscard]] LatenessBars lateness() const override { return bars_of(servo_.lateness()); }

    [[nodiscard]] std::uint64_t beats() override { return servo_.latest().ticks; }

    [[nodiscard]] std::string take_notice() override { return std::exchange(notice_, {}); }

    void hold_recording() override { box_->hold(); }

    void keep_recording() override { box_->keep(); }

    void forget_recording() override { box_->forget(); }

    [[nodiscard]] std::string device_words() override { return {}; }

    void home_again() override {}

    void stop() override { (void)servo_.stop(); }

  private:
    Servo servo_;
    std::string notice_;
    std::optional<BlackBox> box_;  // destroyed first, because it reads the servo's recording
};

}  // namespace touchline
