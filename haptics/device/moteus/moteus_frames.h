// The moteus controllers' register protocol: what one CAN-FD frame says, both ways. Little-endian
// values, several sub-frames in a frame. The frames are the same on a CAN socket and in an
// adapter's lines of text. Threads: pure functions of values. No allocation. O(1).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace touchline {

/// One CAN-FD frame. Its id is source * 256 + destination; bit 15 of a command asks for an answer.
struct CanFrame {
    std::uint32_t id = 0;
    std::array<std::uint8_t, 64> data{};
    std::size_t size = 0;  // bytes of `data`

    [[nodiscard]] std::span<const std::uint8_t> bytes() const { return {data.data(), size}; }
};

/// Whom a frame is for, and what its answer is to be known by. A controller sends its answer to
/// the source of the command; since that is any of 127, it is the number of the question.
struct MoteusAddress {
    std::uint8_t controller = 1;  // 1 to 126
    std::uint8_t question = 1;    // 1 to 127
};

/// The controller's modes that matter here (register 0).
enum class MoteusMode : std::uint8_t {
    stopped = 0,
    fault = 1,
    enabling = 2,  // 3 and 4 also come before it follows
    calibration_complete = 4,
    position = 10,
    timeout = 11
};

/// Lets the motor go and clears a fault.
[[nodiscard]] CanFrame moteus_stop(MoteusAddress address);

/// Holds a torque at the shaft (N m) and no more: position mode with every gain scaled to nothing,
/// whatever bounds are set. The controller's watchdog lets it go `watchdog_s` later unless another
/// one comes. A torque that is not finite counts as zero, and so does the torque's limit then.
[[nodiscard]] CanFrame moteus_torque(MoteusAddress address, double torque_Nm, double watchdog_s);

/// Writes text to the controller's console, at most 56 bytes; the answer has some of its output.
[[nodiscard]] CanFrame moteus_console(MoteusAddress address, std::string_view text);

/// Asks for more of the console's output.
[[nodiscard]] CanFrame moteus_console_poll(MoteusAddress address);

/// What moteus_stop() and moteus_torque() are answered with.
struct MoteusStatus {
    std::uint8_t mode = 0;
    double turns = 0.0;       // of the shaft, finite
    std::uint8_t home = 0;    // 0: turns since power only; 1: within a turn of the rotor; 2: output
    std::uint8_t fault = 0;   // the reason of mode 1; else which limit holds the torque back
    double torque_Nm = 0.0;   // that it was told
    double watchdog_s = 0.0;  // that it was told
};

struct MoteusAnswer {
    enum class Kind : std::uint8_t { status, console, unknown_register, wrong };
    Kind kind = Kind::wrong;
    MoteusAddress from;
    MoteusStatus status;
    std::array<char, 64> text{};  // of the console
    std::size_t text_size = 0;
};

/// Reads an answer. wrong: not one to a command of ours, incomplete, or with a value that is not
/// finite.
[[nodiscard]] MoteusAnswer moteus_answer(const CanFrame& frame);

/// Whether two floats are the same torque or time, sent and read back.
[[nodiscard]] bool is_read_back(double told, double read);

}  // namespace touchline
