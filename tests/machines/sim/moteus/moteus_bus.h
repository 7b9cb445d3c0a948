// Two moteus controllers on a CAN bus with a pantograph behind them, and the fdcanusb adapter that
// a host reaches them by. Time is what the caller passes in. Threads: one at a time.
#pragma once

#include "haptics/device/moteus/moteus_frames.h"
#include "tests/machines/sim/drives/drive_plant.h"
#include "tests/machines/sim/drives/serial_peer.h"
#include "tests/machines/sim/moteus/moteus_controller.h"

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <string>

namespace touchline {

/// A frame and when it was on the bus.
struct SentFrame {
    double at_s = 0.0;
    CanFrame frame;
};

class MoteusBus {
  public:
    MoteusBus(const DriveTruth& truth, const std::array<MoteusTruth, 2>& units,
              std::shared_ptr<const IntendedPath> path);

    void advance_to(double t_s);
    void take(const CanFrame& frame);
    [[nodiscard]] std::optional<SentFrame> leave();

    /// Switches the controllers' own power; what they hold goes with it.
    void switch_power(bool has_power);

    [[nodiscard]] DrivePlant& plant() { return plant_; }

    [[nodiscard]] const DrivePlant& plant() const { return plant_; }

    [[nodiscard]] MoteusController& unit(std::size_t motor) { return units_[motor]; }

  private:
    void drive();

    DrivePlant plant_;
    std::array<MoteusController, 2> units_;
    std::deque<SentFrame> leaving_;
    bool has_power_ = true;
};

class FdcanusbEmulator final : public SerialPeer {
  public:
    explicit FdcanusbEmulator(MoteusBus& bus) : bus_(bus) {}

    void advance_to(double t_s) override { bus_.advance_to(t_s); }

    void take(std::span<const std::uint8_t> bytes) override;
    [[nodiscard]] std::optional<SentBytes> leave() override;

  private:
    [[nodiscard]] std::string obey(const std::string& line);

    MoteusBus& bus_;
    std::string line_;
    std::deque<SentBytes> said_;
    bool is_bus_on_ = false;
};

}  // namespace touchline
