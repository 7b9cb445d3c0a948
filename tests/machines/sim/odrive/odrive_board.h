// An ODrive with two axes by its published ASCII protocol: lines with checksums, properties, axis
// states, errors, watchdogs. Written from the maker's pages and firmware and not from the driver.
// Time is what the caller passes in. Threads: one at a time.
#pragma once

#include "tests/machines/sim/drives/drive_plant.h"
#include "tests/machines/sim/drives/serial_peer.h"

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>

namespace touchline {

/// What differs from axis to axis.
struct OdriveTruth {
    bool is_calibrated = true;
    bool is_encoder_ready = true;
    int encoder_mode = 257;        // an absolute one; 0: counts only
    double watchdog_factor = 1.0;  // of what it is told; 1 in every real one
    bool has_watchdog = true;      // false: cannot be switched on
    bool knows_torque_limit = true;
    int stored_input_mode = 1;    // 6: torques are approached by a ramp
    int deaf_to_input_modes = 0;  // so many lines that set it are lost
};

class OdriveBoard final : public SerialPeer {
  public:
    OdriveBoard(const DriveTruth& truth, const std::array<OdriveTruth, 2>& axes,
                std::shared_ptr<const IntendedPath> path);

    void advance_to(double t_s) override;
    void take(std::span<const std::uint8_t> bytes) override;
    [[nodiscard]] std::optional<SentBytes> leave() override;

    /// Switches its supply; what it was told goes with it.
    void switch_power(bool has_power);

    /// An axis fails with bits of its error, as its own checks would find.
    void fail(std::size_t axis, std::uint32_t error);

    /// The board starts anew at once.
    void reset();

    [[nodiscard]] DrivePlant& plant() { return plant_; }

    [[nodiscard]] const DrivePlant& plant() const { return plant_; }

    [[nodiscard]] int state(std::size_t axis) const { return axes_[axis].state; }

  private:
    struct Axis {
        OdriveTruth truth;
        int state = 1;
        std::uint32_t error = 0;
        double torque_Nm = 0.0;    // the wish
        double setpoint_Nm = 0.0;  // what the motor is to make
        int control_mode = 3, input_mode = 1;
        double watchdog_s = 0.0, left_s = 0.0;
        bool is_watchdog_on = false;
        double most_torque_Nm = 1e9;
        double turns = 0.0;
        std::optional<double> first_turns;  // whole ones since the power came
        double idle_until_s = 0.0;          // a new state is entered a moment later
        int wanted_state = 0;
    };

    void pass_on(Axis& axis, double span_s);
    void obey(const std::string& line);
    void say(const std::string& text, bool has_checksum);
    [[nodiscard]] std::string read(const std::string& property) const;
    [[nodiscard]] bool write(const std::string& property, const std::string& value);
    void run(Axis& axis, double span_s);
    void drive();

    DrivePlant plant_;
    std::array<Axis, 2> axes_;
    int test_property_ = 0;
    std::string line_;
    std::deque<SentBytes> said_;
    bool has_power_ = true;
};

}  // namespace touchline
