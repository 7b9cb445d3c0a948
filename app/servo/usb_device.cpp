#include "app/servo/usb_device.h"

#include "app/servo/watched_board.h"
#include "haptics/device/usb_boards.h"
#include "haptics/pantograph/profile.h"

#include <array>
#include <charconv>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr std::size_t argument_count = 12;
constexpr double most_torque_Nm = 10.0;  // no motor of a desk

void write_zero(void* device) noexcept {
    (void)static_cast<WatchedBoard*>(device)->end_in_zero();
}

/// The whole text is a number.
template <class Number>
bool read_number(const std::string& text, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size();
}

bool is_sound(const Calibration& calibration) {
    const auto is_scale = [](double scale) { return scale >= 0.8 && scale <= 1.25; };
    return is_finite(calibration.offset) && is_scale(calibration.scale.x) &&
           is_scale(calibration.scale.y) &&
           (!calibration.torque_limit_Nm ||
            (*calibration.torque_limit_Nm > 0.0 && *calibration.torque_limit_Nm <= most_torque_Nm));
}

Result<OpenedBoard> take(const UsbBoards& boards, const UsbDevice& device) {
    const auto found = boards.find(std::array{device.id}, device.serial);
    if (!found) return tl::unexpected(found.error());
    return boards.open(*found);
}

Result<OpenedBoard> take_at(const UsbBoards& boards, const UsbDevice& device,
                            const std::string& bus_path) {
    for (const FoundBoard& board : boards.list(std::array{device.id}))
        if (board.bus_path == bus_path) return boards.open(board);
    return failure("no board is plugged in at " + bus_path);
}

}  // namespace

std::vector<std::string> arguments_of(const UsbDevice& device) {
    const Calibration& calibration = device.calibration;
    return {std::to_string(device.id.vendor),
            std::to_string(device.id.product),
            device.serial,
            device.profile,
            fmt::format("{}", calibration.offset.x),
            fmt::format("{}", calibration.offset.y),
            fmt::format("{}", calibration.scale.x),
            fmt::format("{}", calibration.scale.y),
            calibration.are_motors_swapped ? "swapped" : "straight",
            calibration.torque_limit_Nm ? fmt::format("{}", *calibration.torque_limit_Nm) : "",
            device.is_known ? "known" : "new",
            device.is_homed_first ? "home" : "at-home"};
}

Result<UsbDevice> device_of(std::span<const std::string> arguments) {
    if (arguments.size() != argument_count) return failure("not what the kiosk starts it with");
    UsbDevice device;
    Calibration& calibration = device.calibration;
    device.id.may_probe = true;  // the kiosk chose it
    device.id.name = "the pantograph's board";
    device.serial = arguments[2];
    device.profile = arguments[3];
    calibration.are_motors_swapped = arguments[8] == "swapped";
    device.is_known = arguments[10] == "known";
    device.is_homed_first = arguments[11] != "at-home";
    const bool is_read =
        read_number(arguments[0], device.id.vendor) &&
        read_number(arguments[1], device.id.product) &&
        read_number(arguments[4], calibration.offset.x) &&
        read_number(arguments[5], calibration.offset.y) &&
        read_number(arguments[6], calibration.scale.x) &&
        read_number(arguments[7], calibration.scale.y) &&
        (arguments[9].empty() || read_number(arguments[9], calibration.torque_limit_Nm.emplace()));
    if (!is_read || !is_sound(calibration)) return failure("the device's numbers are out of range");
    return device;
}

Result<OpenedDevice> open_usb_device(const UsbDevice& device, const Opening& opening) {
    const auto profile = find_profile(device.profile);
    if (!profile) return tl::unexpected(profile.error());
    auto boards = UsbBoards::create();
    if (!boards) return tl::unexpected(boards.error());
    auto taken = take(*boards, device);
    if (!taken) return tl::unexpected(taken.error());
    opening.share(taken->node);
    auto board =
        std::make_unique<WatchedBoard>(std::move(taken->link), *profile, device.calibration);
    MonotonicClock clock;
    const HomingWanted homing{device.is_homed_first, device.is_known, device.calibration};
    if (const auto opened = board->open(homing, opening, clock); !opened)
        return tl::unexpected(opened.error());
    OpenedDevice result;
    result.zero = {write_zero, board.get()};
    result.has_lost_place = &board->has_lost_place();
    result.release = [watched = board.get()] { return watched->release(); };
    result.device = std::move(board);
    result.profile = calibrated(*profile, device.calibration);
    return result;
}

Result<void> zero_usb_device(const UsbDevice& device, const std::string& bus_path) {
    const auto profile = find_profile(device.profile);
    if (!profile) return tl::unexpected(profile.error());
    auto boards = UsbBoards::create();
    if (!boards) return tl::unexpected(boards.error());
    auto taken = bus_path.empty() ? take(*boards, device) : take_at(*boards, device, bus_path);
    if (!taken) return tl::unexpected(taken.error());
    if (!zero_torque(std::move(taken->link), *profile))
        return failure("the board did not confirm zero torque");
    return {};
}

bool cut_usb_device(const UsbDevice& device, const HeldBoard& held) {
    const auto profile = find_profile(device.profile);
    return profile && write_zero(held.node.number(), held.pipes, *profile);
}

}  // namespace touchline
