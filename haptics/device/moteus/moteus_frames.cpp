#include "haptics/device/moteus/moteus_frames.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>

namespace touchline {
namespace {

// Sub-frames: what is done, in the upper bits; of what type, in bits 2 and 3; how many, in bits 0
// and 1, or in a byte of its own if those are 0.
constexpr std::uint8_t write_int8 = 0x00, write_float = 0x0c;
constexpr std::uint8_t read_int8 = 0x10, read_float = 0x1c;
constexpr std::uint8_t reply_int8 = 0x20, reply_float = 0x2c;
constexpr std::uint8_t write_error = 0x30, read_error = 0x31;
constexpr std::uint8_t to_console = 0x40, from_console = 0x41, poll_console = 0x42;
constexpr std::uint8_t nothing = 0x50;

constexpr std::uint8_t mode_register = 0x00, turns_register = 0x01, home_register = 0x0c;
constexpr std::uint8_t fault_register = 0x0f, position_register = 0x20, torque_register = 0x22;
constexpr std::uint8_t gains_register = 0x23, most_torque_register = 0x25;
constexpr std::uint8_t watchdog_register = 0x27, integral_register = 0x2b;
constexpr std::uint8_t bounds_register = 0x2d;

constexpr std::uint8_t console_channel = 1;
constexpr std::uint8_t most_console_bytes = 48;
constexpr std::uint8_t as_it_is = 0x80;  // the lowest int8: the position where the shaft is now
constexpr std::uint32_t wants_answer = 0x8000;

// The lengths that a CAN-FD frame may have beyond 8 bytes.
constexpr std::array<std::size_t, 7> lengths{12, 16, 20, 24, 32, 48, 64};

class Writer {
  public:
    explicit Writer(MoteusAddress address) {
        frame_.id = wants_answer | static_cast<std::uint32_t>(address.question & 0x7fU) << 8U |
                    (address.controller & 0x7fU);
    }

    void put(std::uint8_t byte) { frame_.data[frame_.size++] = byte; }

    void put(double value) {
        const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
        for (unsigned shift = 0; shift < 32; shift += 8)
            put(static_cast<std::uint8_t>(bits >> shift));
    }

    void read(std::uint8_t type, std::uint8_t first, std::uint8_t count = 1) {
        put(static_cast<std::uint8_t>(type | (count & 3U)));
        if (count > 3) put(count);
        put(first);
    }

    CanFrame padded() {
        const auto* const length = std::ranges::lower_bound(lengths, frame_.size);
        while (frame_.size > 8 && frame_.size < *length) put(nothing);
        return frame_;
    }

  private:
    CanFrame frame_;
};

void put_questions(Writer& frame) {
    frame.read(read_int8, mode_register);
    frame.read(read_float, turns_register);
    frame.read(read_int8, home_register, 4);
    frame.read(read_float, torque_register);
    frame.read(read_float, watchdog_register);
}

// Reads values in turn. After the end, or a bad length, it is broken and gives zeros.
class Reader {
  public:
    explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    [[nodiscard]] bool is_at_end() const { return bytes_.empty(); }

    [[nodiscard]] bool is_broken() const { return is_broken_; }

    std::uint8_t byte() {
        is_broken_ = is_broken_ || bytes_.empty();
        if (is_broken_) return 0;
        const std::uint8_t value = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return value;
    }

    // All numbers here are below 128, which take one byte.
    std::uint8_t number() {
        const std::uint8_t value = byte();
        is_broken_ = is_broken_ || value > 127;
        return value;
    }

    double real() {
        std::uint32_t bits = 0;
        for (unsigned shift = 0; shift < 32; shift += 8) bits |= std::uint32_t{byte()} << shift;
        return static_cast<double>(std::bit_cast<float>(bits));
    }

  private:
    std::span<const std::uint8_t> bytes_;
    bool is_broken_ = false;
};

/// Which of the status's values have come.
struct Heard {
    bool mode = false, turns = false, home = false, fault = false, torque = false, watchdog = false;

    [[nodiscard]] bool is_whole() const {
        return mode && turns && home && fault && torque && watchdog;
    }
};

void keep(std::uint8_t at, double value, MoteusStatus& status, Heard& heard) {
    const auto set = [&](auto& into, bool& is_heard) {
        using Kept = std::remove_reference_t<decltype(into)>;
        if (std::is_integral_v<Kept> && !(value >= 0.0 && value <= 255.0)) return;
        into = static_cast<Kept>(value);
        is_heard = true;
    };
    switch (at) {
        case mode_register:
            return set(status.mode, heard.mode);
        case turns_register:
            return set(status.turns, heard.turns);
        case home_register:
            return set(status.home, heard.home);
        case fault_register:
            return set(status.fault, heard.fault);
        case torque_register:
            return set(status.torque_Nm, heard.torque);
        case watchdog_register:
            return set(status.watchdog_s, heard.watchdog);
        default:
            return;
    }
}

void read_reply(std::uint8_t subframe, Reader& reader, MoteusStatus& status, Heard& heard) {
    const auto in_type = static_cast<std::uint8_t>(subframe & 3U);
    const std::uint8_t count = in_type != 0 ? in_type : reader.number();
    const std::uint8_t first = reader.number();
    const bool is_float = (subframe & 0x0cU) == 0x0cU;
    for (std::uint8_t i = 0; i < count && !reader.is_broken(); ++i) {
        const double value = is_float ? reader.real() : static_cast<double>(reader.byte());
        keep(static_cast<std::uint8_t>(first + i), value, status, heard);
    }
}

void read_console(Reader& reader, MoteusAnswer& answer) {
    (void)reader.number();
    const std::uint8_t size = reader.number();
    for (std::uint8_t i = 0; i < size && !reader.is_broken(); ++i) {
        const char byte = static_cast<char>(reader.byte());
        if (!reader.is_broken() && answer.text_size < answer.text.size())
            answer.text[answer.text_size++] = byte;
    }
    answer.kind = MoteusAnswer::Kind::console;
}

MoteusAnswer wrong_from(MoteusAddress from) {
    MoteusAnswer answer;
    answer.from = from;
    return answer;
}

bool is_reply(std::uint8_t subframe) {
    const auto type = static_cast<std::uint8_t>(subframe & 0xfcU);
    return type == reply_int8 || type == reply_float;
}

}  // namespace

CanFrame moteus_stop(MoteusAddress address) {
    Writer frame(address);
    frame.read(write_int8, mode_register);
    frame.put(static_cast<std::uint8_t>(MoteusMode::stopped));
    put_questions(frame);
    return frame.padded();
}

CanFrame moteus_torque(MoteusAddress address, double torque_Nm, double watchdog_s) {
    const double safe_Nm = std::isfinite(torque_Nm) ? torque_Nm : 0.0;
    Writer frame(address);
    frame.read(write_int8, mode_register);
    frame.put(static_cast<std::uint8_t>(MoteusMode::position));
    frame.read(write_int8, position_register, 2);
    frame.put(as_it_is);
    frame.put(std::uint8_t{0});  // velocity
    frame.read(write_float, torque_register);
    frame.put(safe_Nm);
    frame.read(write_int8, gains_register, 2);
    frame.put(std::uint8_t{0});
    frame.put(std::uint8_t{0});
    frame.read(write_float, most_torque_register);
    frame.put(std::abs(safe_Nm));
    frame.read(write_float, watchdog_register);
    frame.put(watchdog_s);
    frame.read(write_int8, integral_register);
    frame.put(std::uint8_t{0});
    frame.read(write_int8, bounds_register);
    frame.put(std::uint8_t{1});
    put_questions(frame);
    return frame.padded();
}

CanFrame moteus_console(MoteusAddress address, std::string_view text) {
    Writer frame(address);
    frame.put(to_console);
    frame.put(console_channel);
    frame.put(static_cast<std::uint8_t>(text.size()));
    for (const char c : text) frame.put(static_cast<std::uint8_t>(c));
    return frame.padded();
}

CanFrame moteus_console_poll(MoteusAddress address) {
    Writer frame(address);
    frame.put(poll_console);
    frame.put(console_channel);
    frame.put(most_console_bytes);
    return frame.padded();
}

MoteusAnswer moteus_answer(const CanFrame& frame) {
    MoteusAnswer answer;
    answer.from = {static_cast<std::uint8_t>(frame.id >> 8U & 0x7fU),
                   static_cast<std::uint8_t>(frame.id & 0x7fU)};
    Reader reader(frame.bytes());
    Heard heard;
    bool is_unknown = false;
    while (!reader.is_at_end() && !reader.is_broken()) {
        const std::uint8_t subframe = reader.byte();
        if (subframe == nothing) continue;
        if (is_reply(subframe)) {
            read_reply(subframe, reader, answer.status, heard);
        } else if (subframe == from_console) {
            read_console(reader, answer);
        } else if (subframe == write_error || subframe == read_error) {
            (void)reader.number();
            (void)reader.number();
            is_unknown = true;
        } else {
            return wrong_from(answer.from);
        }
    }
    const MoteusStatus& said = answer.status;
    const bool is_sound = std::isfinite(said.turns) && std::isfinite(said.torque_Nm) &&
                          std::isfinite(said.watchdog_s);
    if (reader.is_broken() || !is_sound) return wrong_from(answer.from);
    if (is_unknown)
        answer.kind = MoteusAnswer::Kind::unknown_register;
    else if (heard.is_whole())
        answer.kind = MoteusAnswer::Kind::status;
    return answer;
}

bool is_read_back(double told, double read) {
    return static_cast<float>(told) == static_cast<float>(read);
}

}  // namespace touchline
