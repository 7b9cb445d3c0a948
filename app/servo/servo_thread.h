// The servo as a thread of the kiosk, for a device that is simulated.
// Threads: as ServoClient.
#pragma once

#include "app/servo/servo_client.h"
#include "haptics/servo/servo.h"

namespace touchline {

class ServoThread final : public ServoClient {
  public:
    /// As Servo::start().
    [[nodiscard]] Result<void> start(std::unique_ptr<ForceDevice> device,
                                     const DeviceProfile& profile) {
        return servo_.start(std::move(device), profile, ServoOptions{});
    }

    void set(const ServoCommands& commands) override { servo_.set(commands); }

    void feel(const FeltPicture& picture) override { servo_.feel(picture.scene); }

    [[nodiscard]] const HandState& latest() override { return servo_.latest(); }

    [[nodiscard]] ForceStatus force_status() override { return servo_.force_status(); }

    [[nodiscard]] std::optional<ContactEvent> next_event() override { return servo_.next_event(); }

    [[nodiscard]] RealTimeTier tier() const override { return servo_.tier(); }

    [[nodiscard]] std::string take_notice() override { return {}; }

    void stop() override { servo_.stop(); }

  private:
    Servo servo_;
};

}  // namespace touchline
