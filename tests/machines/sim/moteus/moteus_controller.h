// One moteus controller by its published protocol: registers, modes, watchdog, console. Written
// from the maker's pages and not from the driver. Time comes in spans. Threads: one at a time.
#pragma once

#include "tests/machines/sim/drives/drive_plant.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// What differs from unit to unit.
struct MoteusTruth {
    std::uint8_t id = 1;
    int stored_timeout_mode = 12;  // the maker's default: damp
    bool takes_settings = true;    // false: "conf set" is refused
    bool knows_timeout_mode = true;
    bool knows_bounds = true;      // false: a firmware without register 0x2d
    double watchdog_factor = 1.0;  // of what it is told; 1 in every real one
    std::uint8_t home = 1;         // absolute within a turn of the rotor
};

class MoteusController {
  public:
    explicit MoteusController(const MoteusTruth& truth) : truth_(truth) { reset(); }

    /// Lets span_s > 0 pass; `turns` is what the encoder shows now.
    void advance(double span_s, double turns);

    /// Takes the sub-frames of a frame; returns those of the answer, which may be none.
    [[nodiscard]] std::vector<std::uint8_t> take(std::span<const std::uint8_t> subframes);

    [[nodiscard]] Bridge bridge() const;

    [[nodiscard]] double torque_Nm() const;

    [[nodiscard]] int mode() const { return mode_; }

    [[nodiscard]] std::uint8_t id() const { return truth_.id; }

    /// The power came back: everything is as stored.
    void reset();

    void fail(std::uint8_t code);

    /// What somebody else left in the console.
    void leave_in_console(std::string_view text) { console_out_ += text; }

  private:
    struct Command {
        int mode = 0;
        float velocity = 0.0F, torque_Nm = 0.0F, timeout_s = 0.0F;
        float most_torque_Nm, position = 0.0F;
        float kp = 1.0F, kd = 1.0F, integral = 1.0F;
        bool ignores_bounds = false;
        Command();
    };

    [[nodiscard]] bool write(std::uint32_t at, int type, float value);
    [[nodiscard]] std::optional<float> read(std::uint32_t at) const;
    void apply();
    void run_console();
    [[nodiscard]] std::string said_to(const std::string& line);

    MoteusTruth truth_;
    Command buffered_, command_;
    bool has_command_ = false;
    int mode_ = 0;
    int wanted_mode_ = 0;
    std::uint8_t fault_ = 0;
    double left_s_ = 0.0;  // of the watchdog; NaN: for ever
    double in_mode_s_ = 0.0;
    double turns_ = 0.0;
    std::optional<double> first_turns_;  // since the power came: whole turns are not known
    int timeout_mode_ = 12;
    std::string console_in_, console_out_;
};

}  // namespace touchline
