// Two moteus controllers on one CAN bus as a MotorPair. Every command carries the watchdog and the
// number of its question; every answer tells the torque and the watchdog that were understood.
//
//   look for faults --> stop --> drain --> set the time-out mode --> read it back --> enable -->
//   ready
#pragma once

#include "haptics/device/drives/pair_verdict.h"
#include "haptics/device/moteus/frame_link.h"
#include "haptics/device/moteus/moteus_frames.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace touchline {

/// The controllers' ids on the bus, 1 to 126 and different: of the motor of joint 1, then 2.
using MoteusIds = std::array<std::uint8_t, 2>;

/// Threads: as MotorPair.
class MoteusPair final : public MotorPair {
  public:
    MoteusPair(std::unique_ptr<FrameLink> link, const MoteusIds& ids)
        : link_(std::move(link)), ids_(ids) {}

    void set_up() override;
    [[nodiscard]] PairNews step(double elapsed_s) override;
    [[nodiscard]] bool tell(ShaftTorques torques) override;
    void let_go() override;
    [[nodiscard]] MotorTrouble trouble() const override;
    [[nodiscard]] std::string words_of(const MotorTrouble& trouble) const override;

    [[nodiscard]] bool are_encoders_absolute() const override { return are_absolute_; }

    void rest(double span_s) override { link_->rest(span_s); }

  private:
    /// In the order of a set-up. stop stays where the motors are let go or the pair is refused.
    enum class Stage : std::uint8_t { look, stop, drain, set_mode, read_mode, enable, ready };

    /// One question to both controllers, and what they answered.
    struct Exchange {
        std::uint64_t number = 0;   // counts questions; 0: none
        Stage stage = Stage::stop;  // in which it was asked
        std::array<double, 2> torque_Nm{};
        std::array<bool, 2> is_answered{};
        std::array<MoteusStatus, 2> status{};
        bool is_text_empty = true;

        [[nodiscard]] bool is_console() const {
            return stage == Stage::drain || stage == Stage::set_mode || stage == Stage::read_mode;
        }
    };

    /// What a controller wrote to its console since the stage began, one line of it.
    struct Console {
        std::array<char, 32> line{};
        std::size_t size = 0;
        bool is_line_whole = false;

        void put(char byte);

        [[nodiscard]] std::string_view text() const { return {line.data(), size}; }
    };

    static constexpr std::size_t most_open = 16;  // questions

    void go(Stage stage);
    void take(const CanFrame& frame);
    void complete(const Exchange& exchange);
    void follow(const Exchange& exchange);
    void enable(const Exchange& exchange);
    void read_consoles();
    [[nodiscard]] bool tells_fault(const Exchange& exchange);
    void go_astray();
    void doubt(MotorTrouble::Kind kind, int motor, std::uint32_t code = 0);
    [[nodiscard]] CanFrame frame_for(MoteusAddress address, double torque_Nm) const;
    [[nodiscard]] bool is_followed(const Exchange& exchange, std::size_t motor) const;

    std::unique_ptr<FrameLink> link_;
    MoteusIds ids_;
    Stage stage_ = Stage::stop;
    bool is_let_go_ = true;  // nobody asked for a set-up, or let_go() came
    PairVerdict verdict_;
    double stage_s_ = 0.0;
    double asked_s_ = 0.0;    // since the console was last written to
    bool is_asking_ = false;  // the next tick writes to the consoles
    std::array<Console, 2> consoles_{};
    std::array<bool, 2> is_heard_{};  // since set_up()
    std::array<Exchange, most_open> open_{};
    std::uint64_t answered_ = 0;  // newest question that both answered
    int unknown_in_a_row_ = 0;
    bool are_absolute_ = false;
};

/// Says what a fault code of the controller means and what to do about it.
[[nodiscard]] std::string_view words_of_moteus_fault(std::uint32_t code);

}  // namespace touchline
