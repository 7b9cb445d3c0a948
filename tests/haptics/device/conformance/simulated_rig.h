// What the devices in software have in common as rigs: time is what read() is told, and the line is
// a switch in front of them. Threads: one.
#pragma once

#include "haptics/device/simulated/simulated_pantograph.h"
#include "tests/haptics/device/conformance/device_rig.h"

#include <memory>
#include <optional>

namespace touchline {

/// A line in front of a device that can be cut: then nothing is told and nothing taken, and the
/// device holds zero.
class CutLine final : public ForceDevice {
  public:
    explicit CutLine(ForceDevice& behind) : behind_(behind) {}

    [[nodiscard]] std::optional<DeviceReading> read(double now_s) override {
        auto told = behind_.read(now_s);
        if (is_cut) return std::nullopt;
        return told;
    }

    [[nodiscard]] bool write(const DeviceCommand& command) override {
        const bool is_taken = behind_.write(is_cut ? DeviceCommand{} : command);
        return is_taken && !is_cut;
    }

    bool is_cut = false;

  private:
    ForceDevice& behind_;
};

}  // namespace touchline
