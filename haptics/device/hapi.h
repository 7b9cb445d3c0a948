// hAPI, the board's wire protocol: three commands, one reply, little-endian floats, no checksum.
// Everything here goes by port, port 1 first; board_frame.h goes between ports and joints.
// Threads: pure functions of values. No allocation. O(1).
#pragma once

#include "config/types/vec2.h"
#include "haptics/pantograph/profile.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace touchline {

/// x: port 1, y: port 2.
using PortTorques = Vec2<struct PortNewtonMetre>;
using PortAngles = Vec2<struct PortDegree>;

inline constexpr std::uint8_t board_address = 5;       // any but 0, which the firmware trips over
inline constexpr std::size_t write_bytes = 10;         // of two motors
inline constexpr std::size_t write_bytes_handle = 14;  // and of the handle's

/// Of the command that write_command() makes.
[[nodiscard]] constexpr std::size_t write_size(bool has_handle) {
    return has_handle ? write_bytes_handle : write_bytes;
}

/// The bytes of one command: to be sent as one transfer, for the board does not wait for the rest.
class Command {
  public:
    [[nodiscard]] std::span<const std::uint8_t> bytes() const { return {bytes_.data(), size_}; }

    void put(std::uint8_t byte) { bytes_[size_++] = byte; }

    void put(float value);

  private:
    std::array<std::uint8_t, 40> bytes_{};
    std::size_t size_ = 0;
};

/// Of a handle that turns, on port 3: only boards with four ports have one.
struct HandlePort {
    Turn turn = Turn::counter_clockwise;
    float offset_deg = 0.0F;
    float counts_told = 1.0F;  // a turn
};

/// Two motors with their encoders on ports 1 and 2; index 0 is port 1.
struct BoardSetUp {
    std::array<Turn, 2> turns{};
    std::array<float, 2> offsets_deg{};      // what the encoders are to say now
    std::array<float, 2> counts_told{};      // a turn
    std::optional<std::uint8_t> analog_pin;  // 55 or 56 on the M0
    std::optional<HandlePort> handle;
};

/// Forgets the set-up; motors stay as they are. No reply.
[[nodiscard]] Command reset_command();

/// Stops the motors and makes the pose of this moment the offsets. No reply.
[[nodiscard]] Command set_up_command(const BoardSetUp& set_up);

/// N m, held until the next one; `handle_Nm` where the handle was set up. A torque that is not
/// finite makes all zero. One reply.
[[nodiscard]] Command write_command(PortTorques torques, std::optional<double> handle_Nm = {});

/// 32 zeros: complete whatever half command the board waits for with zeros; the rest are resets.
/// Wait 20 ms before the set-up that must follow.
[[nodiscard]] Command flush_command();

/// For a write of which only the first sent < write_size() bytes got through: zeros in place of the
/// rest, then a write of zero torque. Only the latter after one byte: a board that finds no address
/// takes ff for it and waits for nothing.
[[nodiscard]] Command completing_command(std::size_t sent, bool has_handle = false);

/// angles: good. unconfigured: the board was reset and took the torques for commands. empty: no
/// news. wrong: not a reply to us.
enum class ReplyKind : std::uint8_t { angles, unconfigured, empty, wrong };

struct Reply {
    ReplyKind kind = ReplyKind::wrong;
    PortAngles angles;        // finite; for ReplyKind::angles
    float analog = 0.0F;      // of the analog input, if one is set up
    double handle_deg = 0.0;  // of the handle, if it is set up
};

/// One packet, judged by exact length, address and finite values. analog_inputs: 0 or 1.
[[nodiscard]] Reply decode_reply(std::span<const std::uint8_t> packet, int analog_inputs = 0,
                                 bool has_handle = false);

}  // namespace touchline
