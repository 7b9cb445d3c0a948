// A driver, its link and the emulated service on one virtual clock.
#pragma once

#include "haptics/device/inverse3/inverse3_device.h"
#include "tests/machines/sim/inverse3/emulated_service.h"

#include <memory>
#include <optional>
#include <string_view>
#include <utility>

namespace touchline {

[[nodiscard]] inline DeviceProfile inverse3_profile() {
    return find_device_profile("inverse3").value();
}

class ArmRig {
  public:
    explicit ArmRig(ServiceTruth truth = {}) : service(truth_at(std::move(truth)), hand) {
        connect();
    }

    /// Makes a new link and a new driver, as another program would; the previous ones end.
    void connect(std::string_view name = {}) {
        device.reset();
        auto made = std::make_unique<EmulatedService>(service, now_s, name);
        link = made.get();
        device = std::make_unique<Inverse3Device>(std::move(made), profile);
    }

    /// As the product opens it: until a device is chosen and fit. False after 2 s.
    bool open() {
        for (int i = 0; i < 2000; ++i) {
            link->rest(0.001);
            if (link->session().has_arm()) return link->session().readiness().has_value();
        }
        return false;
    }

    /// Does one servo tick: passes time, reads, writes. Writes zero instead of `command` if there
    /// is no place.
    std::optional<DeviceReading> tick(const DeviceCommand& command = {}) {
        now_s += 0.001;
        const auto told = device->read(now_s);
        is_taken = device->write(told ? command : DeviceCommand{});
        return told;
    }

    std::optional<DeviceReading> tick_for(double span_s, const DeviceCommand& command = {}) {
        std::optional<DeviceReading> last;
        for (double left_s = span_s; left_s > 5e-4; left_s -= 0.001) last = tick(command);
        return last;
    }

    /// What the arm does in the plane, in D.
    [[nodiscard]] Force made_D() {
        service.advance_to(now_s);
        return {-service.applied_N().x, -service.applied_N().y};
    }

    DeviceProfile profile = inverse3_profile();
    double now_s = 0.0;
    std::shared_ptr<MouseHand> hand = std::make_shared<MouseHand>(Position{});
    ServiceEmulator service;
    EmulatedService* link = nullptr;
    std::unique_ptr<Inverse3Device> device;
    bool is_taken = false;

  private:
    /// The hand's path begins at the middle of the drawing area.
    [[nodiscard]] ServiceTruth truth_at(ServiceTruth truth) const {
        truth.centre_m = {-profile.centre.x, -profile.centre.y, inverse3_plane_m};
        return truth;
    }
};

}  // namespace touchline
