#include "tests/machines/sim/moteus/moteus_controller.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <sstream>

namespace touchline {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr double enabling_s = 0.002, calibrating_s = 0.006;
constexpr double default_timeout_s = 0.1;
constexpr double kp_Nm_per_turn = 4.0, kd_Nm_s_per_turn = 0.05;  // the maker's, for a stiff hold

// What one step of a whole number stands for, by the maker's tables.
float step_of(std::uint32_t at, int type) {
    const auto of = [type](float int8, float int16, float int32) {
        return type == 0 ? int8 : type == 1 ? int16 : int32;
    };
    switch (at) {
        case 0x001:
        case 0x020:
            return of(0.01F, 0.0001F, 0.00001F);
        case 0x002:
        case 0x021:
            return of(0.1F, 0.00025F, 0.00001F);
        case 0x003:
        case 0x022:
        case 0x025:
            return of(0.5F, 0.01F, 0.001F);
        case 0x023:
        case 0x024:
        case 0x02b:
            return of(1.0F / 127.0F, 1.0F / 32767.0F, 1.0F / 2147483647.0F);
        case 0x027:
            return of(0.01F, 0.001F, 0.000001F);
        case 0x00d:
            return of(0.5F, 0.1F, 0.001F);
        default:
            return 1.0F;
    }
}

class Subframes {
  public:
    explicit Subframes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    [[nodiscard]] bool is_at_end() const { return bytes_.empty() || is_bad_; }

    std::uint32_t varuint() {
        std::uint32_t value = 0;
        for (unsigned shift = 0; shift < 35; shift += 7) {
            const std::uint32_t byte = little_endian(1);
            value |= (byte & 0x7fU) << shift;
            if ((byte & 0x80U) == 0) return value;
        }
        is_bad_ = true;
        return 0;
    }

    std::uint32_t little_endian(std::size_t size) {
        if (bytes_.size() < size || is_bad_) {
            is_bad_ = true;
            return 0;
        }
        std::uint32_t value = 0;
        for (std::size_t i = size; i-- > 0;) value = value << 8 | bytes_[i];
        bytes_ = bytes_.subspan(size);
        return value;
    }

    float value(std::uint32_t at, int type) {
        if (type == 3) return std::bit_cast<float>(little_endian(4));
        const std::size_t size = std::size_t{1} << static_cast<unsigned>(type);
        const unsigned shift = 8U * static_cast<unsigned>(4 - size);
        const auto whole = static_cast<std::int32_t>(little_endian(size) << shift) >> shift;
        const auto lowest = std::numeric_limits<std::int32_t>::min() >> shift;
        return whole == lowest ? not_a_number : static_cast<float>(whole) * step_of(at, type);
    }

    std::string text(std::size_t size) {
        std::string all;
        for (std::size_t i = 0; i < size && !is_bad_; ++i)
            all += static_cast<char>(little_endian(1));
        return all;
    }

    [[nodiscard]] bool is_bad() const { return is_bad_; }

  private:
    std::span<const std::uint8_t> bytes_;
    bool is_bad_ = false;
};

void put_value(std::vector<std::uint8_t>& into, std::uint32_t at, int type, float value) {
    const std::size_t size = type == 3 ? 4 : std::size_t{1} << static_cast<unsigned>(type);
    const auto bits =
        type == 3
            ? std::bit_cast<std::uint32_t>(value)
            : static_cast<std::uint32_t>(static_cast<std::int32_t>(value / step_of(at, type)));
    for (std::size_t i = 0; i < size; ++i) into.push_back(static_cast<std::uint8_t>(bits >> 8 * i));
}

void put_error(std::vector<std::uint8_t>& into, std::uint8_t kind, std::uint32_t at) {
    into.insert(into.end(), {kind, static_cast<std::uint8_t>(at), std::uint8_t{1}});
}

}  // namespace

MoteusController::Command::Command() : most_torque_Nm(not_a_number) {}

void MoteusController::reset() {
    mode_ = wanted_mode_ = 0;
    fault_ = 0;
    buffered_ = command_ = {};
    timeout_mode_ = truth_.stored_timeout_mode;
    first_turns_.reset();
    console_in_.clear();
    console_out_.clear();
}

void MoteusController::fail(std::uint8_t code) {
    mode_ = 1;
    fault_ = code;
}

Bridge MoteusController::bridge() const {
    if (mode_ == 10) return Bridge::driven;
    if (mode_ == 11 && timeout_mode_ != 0) return Bridge::damped;
    return Bridge::off;
}

double MoteusController::torque_Nm() const {
    if (mode_ != 10) return 0.0;
    const double error = std::isnan(command_.position) ? 0.0 : double{command_.position} - turns_;
    const double hold = double{command_.kp} * kp_Nm_per_turn * error +
                        double{std::min(command_.kd, command_.kp)} * kd_Nm_s_per_turn * 0.0;
    const double most = std::isnan(command_.most_torque_Nm)
                            ? std::numeric_limits<double>::infinity()
                            : double{command_.most_torque_Nm};
    return std::clamp(hold + double{command_.torque_Nm}, -most, most);
}

void MoteusController::advance(double span_s, double turns) {
    if (!first_turns_) first_turns_ = std::round(turns);
    turns_ = turns - *first_turns_;
    in_mode_s_ += span_s;
    left_s_ = std::max(0.0, left_s_ - span_s);  // NaN stays
    if (mode_ == 2 && in_mode_s_ >= enabling_s) mode_ = 3;
    if (mode_ == 3 && in_mode_s_ >= calibrating_s) mode_ = 4;
    if (mode_ == 4) mode_ = wanted_mode_;
    if (mode_ == 10 && left_s_ <= 0.0) mode_ = 11;
}

// A watchdog that has expired, and a fault, are only left by a stop.
void MoteusController::apply() {
    command_ = buffered_;
    left_s_ = truth_.watchdog_factor *
              (command_.timeout_s == 0.0F ? default_timeout_s : double{command_.timeout_s});
    if (std::isnan(command_.timeout_s)) left_s_ = not_a_number;
    if (command_.mode == 0) {
        mode_ = 0;
        fault_ = 0;
    } else if (mode_ == 0) {
        wanted_mode_ = command_.mode;
        mode_ = 2;
        in_mode_s_ = 0.0;
    } else if (mode_ >= 5 && mode_ != 11) {
        mode_ = command_.mode;
    }
}

bool MoteusController::write(std::uint32_t at, int type, float value) {
    (void)type;
    switch (at) {
        case 0x000:
            buffered_ = {};
            buffered_.mode = static_cast<int>(value);
            has_command_ = true;
            return true;
        case 0x020:
            buffered_.position = value;
            return true;
        case 0x021:
            buffered_.velocity = value;
            return true;
        case 0x022:
            buffered_.torque_Nm = value;
            return true;
        case 0x023:
            buffered_.kp = value;
            return true;
        case 0x024:
            buffered_.kd = value;
            return true;
        case 0x025:
            buffered_.most_torque_Nm = value;
            return true;
        case 0x027:
            buffered_.timeout_s = value;
            return true;
        case 0x02b:
            buffered_.integral = value;
            return true;
        case 0x02d:
            buffered_.ignores_bounds = value != 0.0F;
            return truth_.knows_bounds;
        default:
            return false;
    }
}

std::optional<float> MoteusController::read(std::uint32_t at) const {
    switch (at) {
        case 0x000:
            return static_cast<float>(mode_);
        case 0x001:
            return static_cast<float>(turns_);
        case 0x002:
            return 0.0F;
        case 0x003:
            return static_cast<float>(torque_Nm());
        case 0x00c:
            return static_cast<float>(truth_.home);
        case 0x00d:
            return 24.0F;
        case 0x00e:
            return 31.0F;
        case 0x00f:
            return static_cast<float>(fault_);
        case 0x022:
            return buffered_.torque_Nm;
        case 0x027:
            return static_cast<float>(truth_.watchdog_factor) * buffered_.timeout_s;
        default:
            return std::nullopt;
    }
}

// The answer tells the state before the command, which takes effect once the frame is over.
std::vector<std::uint8_t> MoteusController::take(std::span<const std::uint8_t> subframes) {
    Subframes in(subframes);
    std::vector<std::uint8_t> out;
    has_command_ = false;
    while (!in.is_at_end()) {
        const std::uint32_t kind = in.varuint();
        const int type = static_cast<int>(kind >> 2U & 3U);
        if (kind == 0x50) continue;
        if (kind < 0x20) {
            const std::uint32_t count = (kind & 3U) != 0 ? kind & 3U : in.varuint();
            const std::uint32_t first = in.varuint();
            if (kind >= 0x10)
                out.insert(out.end(),
                           {static_cast<std::uint8_t>(0x20 | type << 2),
                            static_cast<std::uint8_t>(count), static_cast<std::uint8_t>(first)});
            for (std::uint32_t at = first; at < first + count && !in.is_bad(); ++at) {
                if (kind < 0x10) {
                    if (!write(at, type, in.value(at, type))) put_error(out, 0x30, at);
                } else {
                    put_value(out, at, type, read(at).value_or(0.0F));
                }
            }
        } else if (kind == 0x40 || kind == 0x42) {
            (void)in.varuint();
            const std::uint32_t size = in.varuint();
            if (kind == 0x40) console_in_ += in.text(size);
            if (kind == 0x40) run_console();
            const std::size_t given =
                std::min<std::size_t>(console_out_.size(), kind == 0x42 ? std::min(size, 40U) : 0U);
            out.insert(out.end(), {0x41, 1, static_cast<std::uint8_t>(given)});
            out.insert(out.end(), console_out_.begin(),
                       console_out_.begin() + static_cast<std::ptrdiff_t>(given));
            console_out_.erase(0, given);
        } else {
            break;
        }
    }
    if (has_command_ && !in.is_bad()) apply();
    return out;
}

void MoteusController::run_console() {
    for (auto end = console_in_.find('\n'); end != std::string::npos;
         end = console_in_.find('\n')) {
        console_out_ += said_to(console_in_.substr(0, end)) + "\r\n";
        console_in_.erase(0, end + 1);
    }
}

std::string MoteusController::said_to(const std::string& line) {
    std::istringstream words(line);
    std::string conf, what, name;
    int value = -1;
    words >> conf >> what >> name >> value;
    if (conf != "conf") return "ERR unknown command";
    if (name != "servo.timeout_mode" || !truth_.knows_timeout_mode) return "ERR error reading";
    if (what == "get") return std::to_string(timeout_mode_);
    if (what != "set") return "ERR unknown subcommand";
    if (truth_.takes_settings) timeout_mode_ = value;
    return "OK";
}

}  // namespace touchline
