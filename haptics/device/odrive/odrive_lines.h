// The ODrive's ASCII protocol: lines of text with a checksum, one command a line, answers in order.
// Threads: values and pure functions. No allocation. O(1).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace touchline {

/// Lines to be sent as one piece, each with its checksum. At most 1024 bytes, which is more than
/// any piece here has.
class OdriveText {
  public:
    /// Ends a line that another program left.
    void end_line() { put_raw("\n"); }

    /// Sets an axis's torque at the shaft (N m); its watchdog starts anew. Not finite: zero.
    void torque(int axis, double torque_Nm);

    /// Starts an axis's watchdog anew and changes nothing.
    void feed(int axis);

    /// Asks for an axis's place and speed.
    void ask_place(int axis);

    /// Asks for a property of an axis, e.g. "error".
    void ask(int axis, std::string_view property);

    void set(int axis, std::string_view property, double value);

    /// Sets the number that the board keeps for whoever tests it, and does nothing with.
    void set_mark(std::uint32_t mark);

    void ask_mark() { put_line("r test_property"); }

    /// Clears the errors of both axes.
    void clear_errors() { put_line("sc"); }

    [[nodiscard]] std::span<const std::uint8_t> bytes() const { return {text_.data(), size_}; }

  private:
    void begin() { line_size_ = 0; }

    void add(std::string_view text);
    void add_number(double value);
    void end();
    void put_line(std::string_view line);
    void put_raw(std::string_view text);

    std::array<char, 96> line_{};
    std::size_t line_size_ = 0;
    std::array<std::uint8_t, 1024> text_{};
    std::size_t size_ = 0;
};

/// place: the turns of a shaft, from the question for it. number: a property's value. refused: the
/// board does not know the property or the command. wrong: no whole line of its.
struct OdriveAnswer {
    enum class Kind : std::uint8_t { place, number, refused, wrong };
    Kind kind = Kind::wrong;
    double value = 0.0;  // finite: turns, or the number
};

/// Reads a line, which must have the checksum that every answer to a line with one has.
[[nodiscard]] OdriveAnswer odrive_answer(std::string_view line);

}  // namespace touchline
