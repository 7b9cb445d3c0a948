// The published firmware of the pantograph's boards, byte for byte and pass for pass: what it does
// with bytes that come, are cut short or never come. No mechanics, no USB. Threads: a plain value.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace touchline {

/// m0: two ports, 1023 steps of duty, sees half the counts that it is told, waits 1 s in all for
/// the rest of a float block. due: four ports, 255 steps, sees all the counts, waits 1 s a byte, is
/// mute while DTR and RTS are low.
enum class BoardType : std::uint8_t { m0, due };

inline constexpr double full_duty_Nm = 0.123;

/// Changes that builders of a board may have made to its firmware.
struct FirmwareVariant {
    bool has_all_counts = false;            // m0: sees all the counts that it is told
    double torque_limit_Nm = full_duty_Nm;  // the torque that it takes for full duty
    bool scales_together = false;           // scales all torques if one is beyond the limit; else
                                            // clamps each
};

inline constexpr double never_s = std::numeric_limits<double>::infinity();

using PacketBytes = std::vector<std::uint8_t>;

/// The ports in use; the fourth has no function.
inline constexpr std::size_t port_count = 3;

/// Encoder counts since the board got power, counted clockwise, by port.
using PortCounts = std::array<std::int64_t, port_count>;

class Firmware {
  public:
    /// The seed fills memory that the firmware reads before it writes it.
    Firmware(BoardType type, std::uint64_t seed, const FirmwareVariant& variant = {})
        : type_(type), variant_(variant), garbage_(seed) {}

    /// Gives bytes that arrive at at_s; later calls have later times.
    void take(std::span<const std::uint8_t> bytes, double at_s);

    /// Returns when the next pass has something to do; never_s while it waits for the host.
    [[nodiscard]] double next_pass_s() const;

    /// Runs one pass of its loop at next_pass_s(). Returns a reply if it sends one.
    [[nodiscard]] std::optional<PacketBytes> pass(double now_s, const PortCounts& counts);

    /// Blocks the firmware until then, as it waits for the host to read.
    void hold_until(double t_s) { busy_until_s_ = t_s; }

    /// Returns the fraction of full duty by port, as told: -1 to 1. It is held for ever.
    [[nodiscard]] std::array<double, port_count> duty() const { return duty_; }

    /// Returns the direction bits that the motors were set up with, by port.
    [[nodiscard]] std::array<std::uint8_t, port_count> motor_turns() const { return motor_turns_; }

    [[nodiscard]] bool is_set_up() const { return address_ != 0; }

    [[nodiscard]] std::uint64_t set_ups() const { return set_ups_; }

    /// True if it was told something that makes the real firmware write where it must not: address
    /// 0 or pin 59.
    [[nodiscard]] bool is_broken() const { return is_broken_; }

    /// True while it waits for the rest of a block of floats.
    [[nodiscard]] bool is_waiting() const { return block_.has_value(); }

  private:
    struct Arrived {
        double at_s;
        std::uint8_t byte;
    };

    /// A block of floats that readBytes() waits for.
    struct Block {
        std::uint8_t command;
        std::size_t bytes;
        double from_s;
    };

    struct Encoder {
        float offset_deg = 0.0F;
        float counts_told = 1.0F;
        std::uint8_t turn = 0;
        std::int64_t start_count = 0;  // the encoder's own count at set-up
        std::int64_t counter = 0;
    };

    [[nodiscard]] std::uint8_t read(double now_s);
    [[nodiscard]] std::uint8_t read_mask(double now_s, std::array<std::uint8_t, port_count>& turns);
    void begin_set_up(double now_s);
    [[nodiscard]] std::optional<PacketBytes> begin_write(double now_s);
    [[nodiscard]] std::optional<PacketBytes> finish(double now_s, const PortCounts& counts);
    [[nodiscard]] std::vector<float> floats_of_block(double now_s);
    void set_up(const std::vector<float>& values, const PortCounts& counts);
    void set_duty(const std::vector<float>& torques);
    [[nodiscard]] double block_deadline_s() const;
    [[nodiscard]] double block_complete_s() const;
    [[nodiscard]] PacketBytes reply(const PortCounts& counts) const;
    [[nodiscard]] double resolved(float counts_told) const;

    BoardType type_;
    FirmwareVariant variant_;
    std::mt19937_64 garbage_;
    std::deque<Arrived> arrived_;
    double busy_until_s_ = 0.0;
    std::optional<Block> block_;
    std::uint8_t address_ = 0;  // address at set-up; 0: not set up
    std::uint8_t address_to_set_up_ = 0;
    std::uint8_t motors_ = 0, encoders_ = 0;  // masks
    std::size_t analog_inputs_ = 0, pwm_outputs_ = 0;
    std::array<std::uint8_t, port_count> motor_turns_{}, encoder_turns_{};
    std::array<Encoder, port_count> encoder_{};
    std::array<double, port_count> duty_{};
    std::uint64_t set_ups_ = 0;
    bool is_broken_ = false;
};

}  // namespace touchline
