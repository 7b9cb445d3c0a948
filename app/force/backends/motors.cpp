#include "app/force/backends/motors.h"

#include "app/documents/decode/files.h"
#include "app/isolation/process/places.h"

#include <algorithm>
#include <array>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view ports_by_kind = "/dev/serial/by-id";
constexpr std::array<std::string_view, 2> makes{"moteus", "odrive"};

/// The adapters are called as their makers name them.
bool is_adapter(MotorsMake make, const std::string& name) {
    const auto has = [&](std::string_view part) { return name.find(part) != std::string::npos; };
    return make == MotorsMake::moteus ? has("fdcanusb") || has("mjcanfd") : has("ODrive");
}

JointDrive drive_of(const MotorSettings& motor) {
    return {motor.is_clockwise ? Turn::clockwise : Turn::counter_clockwise, motor.ratio,
            motor.zero_turns};
}

MotorDevice with_controllers(const MotorsDevice& device) {
    MotorDevice made;
    made.servo.arguments = arguments_of(device);
    made.servo.arguments.insert(made.servo.arguments.begin(), std::string(name_of(device.make)));
    // The watchdogs have let go before; where the handle is, the encoders tell.
    made.servo.zero_torque = [device](const std::string&) {
        return zero_motors(device).map([] { return ZeroedBoard::unknown; });
    };
    made.profile = open_five_bar();
    made.name = std::string(name_of(device.make));
    return made;
}

}  // namespace

std::string_view name_of(MotorsMake make) {
    return makes.at(static_cast<std::size_t>(make));
}

fs::path motors_file() {
    const std::string named = environment("TOUCHLINE_MOTORS");
    return named.empty() ? user_settings_folder() / "touchline" / "motors.toml" : fs::path(named);
}

Result<std::optional<MotorUnit>> stored_motors(MotorsMake make) {
    return read_motor_units(motors_file()).map([make](const std::vector<MotorUnit>& units) {
        const auto found = std::ranges::find(units, name_of(make), &MotorUnit::make);
        return found == units.end() ? std::nullopt : std::optional(*found);
    });
}

Result<void> keep_motors(const MotorUnit& unit) {
    const fs::path file = motors_file();
    auto units = read_motor_units(file);
    if (!units) return tl::unexpected(units.error());
    std::erase_if(*units, [&](const MotorUnit& kept) { return kept.make == unit.make; });
    units->push_back(unit);
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error) {
        return failure("the folder " + file.parent_path().string() +
                       " cannot be made: " + error.message());
    }
    return write_whole_file(file.string(), motor_units_text(*units));
}

MotorsDevice device_at(const std::string& port, MotorsMake make, const MotorUnit& unit) {
    MotorsDevice device{make, port, {}, {}};
    for (std::size_t i = 0; i < 2; ++i)
        device.ids[i] = static_cast<std::uint8_t>(unit.motors[i].id);
    device.drives = {drive_of(unit.motors[0]), drive_of(unit.motors[1])};
    return device;
}

std::vector<std::string> motor_ports(MotorsMake make) {
    std::vector<std::string> ports;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(ports_by_kind, error))
        if (is_adapter(make, entry.path().filename().string()))
            ports.push_back(entry.path().string());
    std::ranges::sort(ports);
    return ports;
}

Result<std::optional<std::string>> motor_port(MotorsMake make, const std::string& named) {
    if (!named.empty()) return std::optional(named);
    const auto ports = motor_ports(make);
    if (ports.empty()) return std::optional<std::string>();
    if (ports.size() == 1) return std::optional(ports.front());
    return failure(
        fmt::format("{} adapters of the make {} are plugged in: name the one of the "
                    "pantograph, for example {}",
                    ports.size(), name_of(make), ports.front()));
}

namespace {

Result<std::optional<MotorDevice>> find_motors(MotorsMake make, const std::string& named) {
    const auto port = motor_port(make, named);
    if (!port) return tl::unexpected(port.error());
    if (!*port) return std::nullopt;
    const auto unit = stored_motors(make);
    if (!unit) return tl::unexpected(unit.error());
    if (!*unit)
        return failure(
            fmt::format("the motors of the make {0} were never set up: do 'touchline "
                        "device home --make {0}'",
                        name_of(make)));
    return with_controllers(device_at(**port, make, **unit));
}

}  // namespace

Result<std::optional<MotorDevice>> find_moteus(const std::string& port) {
    return find_motors(MotorsMake::moteus, port);
}

Result<std::optional<MotorDevice>> find_odrive(const std::string& port) {
    return find_motors(MotorsMake::odrive, port);
}

}  // namespace touchline
