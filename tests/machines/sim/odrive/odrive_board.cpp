#include "tests/machines/sim/odrive/odrive_board.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace touchline {
namespace {

constexpr double axis_step_s = 1.25e-4;
constexpr double line_answer_s = 2e-4;
constexpr double entering_s = 0.002;
constexpr std::uint32_t invalid_state = 1U << 0U, watchdog_error = 1U << 11U;
constexpr double motor_limit_Nm = 0.5;
constexpr int ramp_mode = 6;
constexpr double ramp_Nm_per_s = 0.01;

std::string printed(double value) {
    std::array<char, 64> text{};
    // The board keeps nine letters of a number.
    (void)std::snprintf(text.data(), 10, "%f", value);
    return text.data();
}

}  // namespace

OdriveBoard::OdriveBoard(const DriveTruth& truth, const std::array<OdriveTruth, 2>& axes,
                         std::shared_ptr<const IntendedPath> path)
    : plant_(truth, std::move(path)) {
    for (std::size_t i = 0; i < 2; ++i) {
        axes_[i].truth = axes[i];
        axes_[i].input_mode = axes[i].stored_input_mode;
    }
}

void OdriveBoard::reset() {
    for (Axis& axis : axes_) {
        Axis anew;
        anew.truth = axis.truth;
        anew.input_mode = axis.truth.stored_input_mode;
        axis = anew;
    }
    line_.clear();
    drive();
}

void OdriveBoard::switch_power(bool has_power) {
    if (has_power != has_power_) reset();
    has_power_ = has_power;
    if (!has_power) said_.clear();
}

void OdriveBoard::fail(std::size_t axis, std::uint32_t error) {
    axes_[axis].error |= error;
    drive();
}

void OdriveBoard::pass_on(Axis& axis, double span_s) {
    const double step_Nm = ramp_Nm_per_s * span_s;
    const double way_Nm = axis.torque_Nm - axis.setpoint_Nm;
    axis.setpoint_Nm +=
        axis.input_mode == ramp_mode ? std::clamp(way_Nm, -step_Nm, step_Nm) : way_Nm;
}

// An axis with an error has its phases floating and is idle.
void OdriveBoard::run(Axis& axis, double span_s) {
    if (axis.is_watchdog_on) {
        axis.left_s -= span_s;
        if (axis.left_s <= 0.0) axis.error |= watchdog_error;
    }
    if (axis.wanted_state != 0 && plant_.now_s() >= axis.idle_until_s) {
        const bool is_possible = axis.truth.is_calibrated && axis.truth.is_encoder_ready;
        axis.state = std::exchange(axis.wanted_state, 0);
        if (axis.state == 8 && !is_possible) axis.error |= invalid_state;
        if (axis.state == 8) axis.left_s = axis.watchdog_s * axis.truth.watchdog_factor;
    }
    if (axis.error != 0) axis.state = 1;
}

void OdriveBoard::advance_to(double t_s) {
    while (plant_.now_s() + 1e-9 < t_s) {
        const double span_s = std::min(axis_step_s, t_s - plant_.now_s());
        plant_.advance(span_s);
        for (std::size_t i = 0; i < 2; ++i) {
            Axis& axis = axes_[i];
            const double turns = plant_.shaft_turns(i);
            if (!axis.first_turns) axis.first_turns = std::round(turns);
            axis.turns = turns - *axis.first_turns;
            if (has_power_) run(axis, span_s);
            pass_on(axis, span_s);
        }
        drive();
    }
}

void OdriveBoard::drive() {
    for (std::size_t i = 0; i < 2; ++i) {
        Axis& axis = axes_[i];
        pass_on(axis, 0.0);
        const bool is_on = has_power_ && axis.state == 8 && axis.error == 0;
        const double most_Nm = std::min(axis.most_torque_Nm, motor_limit_Nm);
        plant_.drive(
            i, is_on ? Bridge::driven : Bridge::off,
            axis.control_mode == 1 ? std::clamp(axis.setpoint_Nm, -most_Nm, most_Nm) : 0.0);
    }
}

void OdriveBoard::take(std::span<const std::uint8_t> bytes) {
    if (!has_power_) return;
    for (const std::uint8_t byte : bytes) {
        const char c = static_cast<char>(byte);
        if (c == '\n' || c == '\r' || c == '!')
            obey(std::exchange(line_, {}));
        else
            line_ += c;
    }
    drive();
}

void OdriveBoard::say(const std::string& text, bool has_checksum) {
    std::string line = text;
    if (has_checksum) {
        std::uint8_t sum = 0;
        for (const char c : text)
            sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));
        line += "*" + std::to_string(sum);
    }
    line += "\r\n";
    said_.push_back({plant_.now_s() + line_answer_s, {line.begin(), line.end()}});
}

std::optional<SentBytes> OdriveBoard::leave() {
    if (said_.empty()) return std::nullopt;
    SentBytes first = std::move(said_.front());
    said_.pop_front();
    return first;
}

// A line with a wrong checksum is ignored; one without any is obeyed.
void OdriveBoard::obey(const std::string& whole) {
    std::string line = whole.substr(0, whole.find(';'));
    const std::size_t star = line.find('*');
    const bool has_checksum = star != std::string::npos;
    if (has_checksum) {
        unsigned told = 0, sum = 0;
        for (const char c : line.substr(0, star)) sum ^= static_cast<unsigned char>(c);
        if (std::sscanf(line.c_str() + star + 1, "%u", &told) < 1 || told != sum) return;
        line.resize(star);
    }
    if (line.empty()) return say("unknown command", has_checksum);
    std::array<char, 257> name{}, value{};
    unsigned number = 0;
    float torque = 0.0F;
    switch (line[0]) {
        case 'c':
            if (std::sscanf(line.c_str(), "c %u %f", &number, &torque) < 2)
                return say("invalid command format", has_checksum);
            if (number > 1) return say("invalid motor", has_checksum);
            axes_[number].control_mode = 1;
            axes_[number].torque_Nm = static_cast<double>(torque);
            axes_[number].left_s = axes_[number].watchdog_s * axes_[number].truth.watchdog_factor;
            return;
        case 'u':
            if (std::sscanf(line.c_str(), "u %u", &number) < 1 || number > 1)
                return say("invalid command format", has_checksum);
            axes_[number].left_s = axes_[number].watchdog_s * axes_[number].truth.watchdog_factor;
            return;
        case 'f':
            if (std::sscanf(line.c_str(), "f %u", &number) < 1 || number > 1)
                return say("invalid command format", has_checksum);
            {
                std::array<char, 64> text{};
                (void)std::snprintf(text.data(), text.size(), "%f %f", axes_[number].turns, 0.0);
                return say(text.data(), has_checksum);
            }
        case 'r':
            if (std::sscanf(line.c_str(), "r %256s", name.data()) < 1)
                return say("invalid command format", has_checksum);
            return say(read(name.data()), has_checksum);
        case 'w':
            if (std::sscanf(line.c_str(), "w %256s %256s", name.data(), value.data()) < 2)
                return say("invalid command format", has_checksum);
            if (!write(name.data(), value.data())) say("invalid property", has_checksum);
            return;
        case 's':
            if (line == "sc")
                for (Axis& axis : axes_) axis.error = 0;
            return;
        default:
            return say("unknown command", has_checksum);
    }
}

std::string OdriveBoard::read(const std::string& property) const {
    if (property == "test_property") return std::to_string(test_property_);
    const bool is_axis = property.starts_with("axis0.") || property.starts_with("axis1.");
    if (!is_axis) return "invalid property";
    const Axis& axis = axes_[property[4] == '0' ? 0 : 1];
    const std::string name = property.substr(6);
    if (name == "controller.input_torque") return printed(axis.torque_Nm);
    if (name == "error") return std::to_string(axis.error);
    if (name == "current_state") return std::to_string(axis.state);
    if (name == "config.watchdog_timeout")
        return printed(axis.watchdog_s * axis.truth.watchdog_factor);
    if (name == "config.enable_watchdog") return axis.is_watchdog_on ? "1" : "0";
    if (name == "encoder.is_ready") return axis.truth.is_encoder_ready ? "1" : "0";
    if (name == "encoder.config.mode") return std::to_string(axis.truth.encoder_mode);
    if (name == "motor.is_calibrated") return axis.truth.is_calibrated ? "1" : "0";
    if (name == "motor.config.torque_lim" && axis.truth.knows_torque_limit)
        return printed(axis.most_torque_Nm);
    if (name == "controller.config.control_mode") return std::to_string(axis.control_mode);
    if (name == "controller.config.input_mode") return std::to_string(axis.input_mode);
    return "invalid property";
}

bool OdriveBoard::write(const std::string& property, const std::string& value) {
    if (property == "test_property") {
        test_property_ = std::atoi(value.c_str());
        return true;
    }
    const bool is_axis = property.starts_with("axis0.") || property.starts_with("axis1.");
    if (!is_axis) return false;
    Axis& axis = axes_[property[4] == '0' ? 0 : 1];
    const std::string name = property.substr(6);
    const double number = std::atof(value.c_str());
    if (name == "requested_state") {
        axis.wanted_state = static_cast<int>(number);
        axis.idle_until_s = plant_.now_s() + (axis.wanted_state == 8 ? entering_s : 0.0);
    } else if (name == "config.watchdog_timeout") {
        axis.watchdog_s = number;
    } else if (name == "config.enable_watchdog") {
        axis.is_watchdog_on = axis.truth.has_watchdog && number != 0.0;
    } else if (name == "controller.config.control_mode") {
        axis.control_mode = static_cast<int>(number);
    } else if (name == "controller.config.input_mode") {
        if (axis.truth.deaf_to_input_modes > 0)
            --axis.truth.deaf_to_input_modes;
        else
            axis.input_mode = static_cast<int>(number);
    } else if (name == "motor.config.torque_lim" && axis.truth.knows_torque_limit) {
        axis.most_torque_Nm = number;
    } else {
        return false;
    }
    return true;
}

}  // namespace touchline
