// The published firmware of the pantograph's boards, byte for byte and pass for pass: what it does
// with bytes that come, are cut short or never come. No mechanics, no USB.
// Threads: a plain value.
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
/// the rest of a float block. due: four ports, 256 steps, all the counts, waits 1 s a byte, is mute
/// while DTR and RTS are low.
enum class BoardType : std::uint8_t { m0, due };

inline constexpr double full_duty_Nm = 0.123;

/// What a firmware may have been changed in by those who built it.
struct FirmwareVariant {
    bool has_all_counts = false;            // m0: counts all that it is told
    double torque_limit_Nm = full_duty_Nm;  // full duty, which it takes for this
    bool scales_together = false;           // torques beyond the limit; else each for itself
};

inline constexpr double never_s = std::numeric_limits<double>::infinity();

using PacketBytes = std::vector<std::uint8_t>;

/// Ports that are looked at here: the fourth has nothing to do.
inline constexpr std::size_t port_count = 3;

/// Counts of the encoders since the board got power, counted clockwise, by port.
using PortCounts = std::array<std::int64_t, port_count>;

class Firmware {
  public:
    /// The seed fills memory that the firmware reads before anything was written to it.
    Firmware(BoardType type, std::uint64_t seed, const FirmwareVariant& variant = {})
        : type_(type), variant_(variant), garbage_(seed) {}

    /// Bytes that are there from at_s on; later calls, later times.
    void take(std::span<const std::uint8_t> bytes, double at_s);

    /// When the next pass has something to do; never_s when it waits for the host.
    [[nodiscard]] double next_pass_s() const;

    /// One pass of its loop at next_pass_s(). A reply that it sends.
    [[nodiscard]] std::optional<PacketBytes> pass(double now_s, const PortCounts& counts);

    /// It can do nothing until then (it waits for the host to read).
    void hold_until(double t_s) { busy_until_s_ = t_s; }

    /// Fraction of full duty by port, as told: -1 to 1. Held for ever.
    [[nodiscard]] std::array<double, port_count> duty() const { return duty_; }

    /// Direction bits that the motors were set up with, by port.
    [[nodiscard]] std::array<std::uint8_t, port_count> motor_turns() const { return motor_turns_; }

    [[nodiscard]] bool is_set_up() const { return address_ != 0; }

    [[nodiscard]] std::uint64_t set_ups() const { return set_ups_; }

    /// It was told something that makes the real one write where it must not: address 0 or pin 59.
    [[nodiscard]] bool is_broken() const { return is_broken_; }

    /// Waits for the rest of a block of floats.
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
        std::int64_t start_count = 0;  // the encoder's own when it was set up
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
    std::uint8_t address_ = 0;  // set up; 0: none
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
