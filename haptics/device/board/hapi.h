// hAPI, the board's wire protocol: three commands, one reply, little-endian floats, no checksum.
// Everything here goes by port, port 1 first; board_frame.h converts between ports and joints.
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

inline constexpr std::uint8_t board_address = 5;       // any but 0, which confuses the firmware
inline constexpr std::size_t write_bytes = 10;         // two motors
inline constexpr std::size_t write_bytes_handle = 14;  // two motors and the handle's

/// The size of the command that write_command() makes.
[[nodiscard]] constexpr std::size_t write_size(bool has_handle) {
    return has_handle ? write_bytes_handle : write_bytes;
}

/// The bytes of one command. Send it as one transfer, because the board does not wait for the rest.
class Command {
  public:
    [[nodiscard]] std::span<const std::uint8_t> bytes() const { return {bytes_.data(), size_}; }

    void put(std::uint8_t byte) { bytes_[size_++] = byte; }

    void put(float value);

  private:
    std::array<std::uint8_t, 40> bytes_{};
    std::size_t size_ = 0;
};

/// A turning handle on port 3; only boards with four ports have one.
struct HandlePort {
    Turn turn = Turn::counter_clockwise;
    float offset_deg = 0.0F;
    float counts_told = 1.0F;  // per turn
};

/// Two motors with their encoders on ports 1 and 2; index 0 is port 1.
struct BoardSetUp {
    std::array<Turn, 2> turns{};
    std::array<float, 2> offsets_deg{};      // what the encoders report now
    std::array<float, 2> counts_told{};      // per turn
    std::optional<std::uint8_t> analog_pin;  // 55 or 56 on the M0
    std::optional<HandlePort> handle;
};

/// Makes the board forget its set-up; motors stay as they are. No reply.
[[nodiscard]] Command reset_command();

/// Stops the motors and makes the present pose the offsets. No reply.
[[nodiscard]] Command set_up_command(const BoardSetUp& set_up);

/// Sets torques in N m, held until the next command; `handle_Nm` if the handle was set up. A torque
/// that is not finite makes all of them zero. One reply.
[[nodiscard]] Command write_command(PortTorques torques, std::optional<double> handle_Nm = {});

/// 32 zeros: they complete a half command that the board may wait for; the rest are resets. Wait 20
/// ms before the set-up that must follow.
[[nodiscard]] Command flush_command();

/// For a write of which only the first sent < write_size() bytes got through: zeros for the missing
/// bytes, then a write of zero torque. After one byte, only the write: a board that finds no
/// address takes ff for it and does not wait.
[[nodiscard]] Command completing_command(std::size_t sent, bool has_handle = false);

/// angles: good. unconfigured: the board was reset and took the torques for commands. empty: no
/// news. wrong: not a reply to a command of ours.
enum class ReplyKind : std::uint8_t { angles, unconfigured, empty, wrong };

struct Reply {
    ReplyKind kind = ReplyKind::wrong;
    PortAngles angles;        // finite; for ReplyKind::angles
    float analog = 0.0F;      // of the analog input, if one is set up
    double handle_deg = 0.0;  // of the handle, if it is set up
};

/// Decodes one packet and checks its exact length, its address and that its values are finite.
/// analog_inputs: 0 or 1.
[[nodiscard]] Reply decode_reply(std::span<const std::uint8_t> packet, int analog_inputs = 0,
                                 bool has_handle = false);

}  // namespace touchline
