// The two axes of an ODrive as a MotorPair. Answers bear no names. So a burst of questions must be
// answered line by line, each of its own kind, and ends with a number of its own that comes back;
// the first line that is otherwise makes us begin anew.
//
//   quiet --> look for errors --> arm --> read back --> closed loop --> ready
#pragma once

#include "haptics/device/drives/pair_verdict.h"
#include "haptics/device/odrive/odrive_lines.h"
#include "haptics/device/serial/byte_link.h"
#include "haptics/device/serial/line_reader.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace touchline {

/// Threads: as MotorPair. Axis 0 is the motor of joint 1, axis 1 that of joint 2.
class OdrivePair final : public MotorPair {
  public:
    /// most_Nm > 0: the greatest torque of a shaft, which the board is told too.
    OdrivePair(std::unique_ptr<ByteLink> port, double most_Nm)
        : port_(std::move(port)), most_Nm_(most_Nm) {}

    void set_up() override;
    [[nodiscard]] PairNews step(double elapsed_s) override;
    [[nodiscard]] bool tell(ShaftTorques torques) override;
    void let_go() override;
    [[nodiscard]] MotorTrouble trouble() const override;
    [[nodiscard]] std::string words_of(const MotorTrouble& trouble) const override;

    [[nodiscard]] bool are_encoders_absolute() const override { return are_absolute_; }

    void rest(double span_s) override { port_->rest(span_s); }

  private:
    /// In the order of a set-up. let_go stays where nobody wants a torque any more.
    enum class Stage : std::uint8_t { let_go, quiet, look, arm, read_back, close_loop, ready };

    enum class Asked : std::uint8_t {
        place,
        held_torque,
        error,
        state,
        watchdog_time,
        watchdog_on,
        most_torque,
        control_mode,
        input_mode,
        encoder_ready,
        encoder_mode,
        motor_calibrated,
        mark
    };

    static constexpr std::array read_backs{
        Asked::watchdog_time, Asked::watchdog_on,   Asked::most_torque,  Asked::control_mode,
        Asked::input_mode,    Asked::encoder_ready, Asked::encoder_mode, Asked::motor_calibrated};

    struct Question {
        Asked asked = Asked::place;
        std::size_t axis = 0;
        double answer = 0.0;
    };

    /// Questions that went out as one piece, and their answers in order.
    struct Burst {
        std::uint64_t number = 0;
        Stage stage = Stage::let_go;  // in which it was asked
        std::array<Question, 2 * read_backs.size() + 1> questions{};
        std::size_t count = 0;
        std::size_t answered = 0;
    };

    static constexpr std::size_t most_open = 16;  // bursts

    void go(Stage stage);
    void go_astray();
    void take(std::string_view line);
    void complete(const Burst& burst);
    void read_back(const Burst& burst);
    void look(const Burst& burst);
    void judge_axes(const Burst& burst);
    void refuse(MotorTrouble::Kind kind, std::size_t axis, double code = 0.0);
    void doubt(MotorTrouble::Kind kind, std::size_t axis);
    void put_stage(OdriveText& text, Burst& burst, ShaftTorques torques);
    void put_questions(OdriveText& text, Burst& burst, bool is_zero);
    void put_release(OdriveText& text) const;
    void put_arming(OdriveText& text, Burst& burst) const;
    static void ask_mark(OdriveText& text, Burst& burst);
    static void ask(OdriveText& text, Burst& burst, Asked asked);
    [[nodiscard]] std::size_t asked_axis() const;

    std::unique_ptr<ByteLink> port_;
    double most_Nm_;
    LineReader lines_;
    Stage stage_ = Stage::let_go;
    PairVerdict verdict_;
    double stage_s_ = 0.0;
    double deaf_s_ = 0.0;  // what comes until then belongs to no question
    bool is_first_of_stage_ = true;
    std::array<Burst, most_open> open_{};  // by time; first_open_ is the oldest
    std::size_t first_open_ = 0;
    std::size_t open_count_ = 0;
    bool are_absolute_ = false;
    bool clears_errors_ = true;  // in arming
};

}  // namespace touchline
