#include "app/force/servo/usb_device.h"

#include "app/force/servo/watched_board.h"
#include "config/types/utf8.h"
#include "haptics/device/board/usb_boards.h"
#include "haptics/pantograph/profile.h"
#include "haptics/servo/real_time.h"

#include <array>
#include <memory>
#include <thread>
#include <utility>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr std::size_t argument_count = 13;
constexpr std::size_t handover_count = 8;  // more arguments

void write_zero(void* device) noexcept {
    (void)static_cast<WatchedBoard*>(device)->end_in_zero();
}

template <class Number>
bool read_number(const std::string& text, Number& number) {
    const auto read = number_in<Number>(text);
    number = read.value_or(number);
    return read.has_value();
}

bool read_plugs(const std::string& text, Plugs& plugs) {
    const auto number = number_in<std::uint32_t>(text, 0, number_of({true, true, true}));
    plugs = plugs_of(number.value_or(0));
    return number.has_value();
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

std::vector<std::string> arguments_of(const Handover& handover) {
    return {fmt::format("{}", handover.place.offset.x), fmt::format("{}", handover.place.offset.y),
            std::to_string(handover.place.slept_ns),    fmt::format("{}", handover.last.x),
            fmt::format("{}", handover.last.y),         std::to_string(handover.seen_ns),
            fmt::format("{}", handover.motor_heat),     handover.bus_path};
}

bool read_handover(std::span<const std::string> words, Handover& handover) {
    handover.bus_path = words[7];
    return read_number(words[0], handover.place.offset.x) &&
           read_number(words[1], handover.place.offset.y) &&
           read_number(words[2], handover.place.slept_ns) &&
           read_number(words[3], handover.last.x) && read_number(words[4], handover.last.y) &&
           read_number(words[5], handover.seen_ns) && read_number(words[6], handover.motor_heat) &&
           is_sound(handover);
}

/// The thread has the loop's priority, because its silence while the motors are tried ends the
/// servo.
Result<void> open_in_time(WatchedBoard& board, const UsbDevice& device, const Opening& opening) {
    Result<void> opened;
    std::thread([&] {
        (void)become_real_time(MemoryLock::as_touched);
        MonotonicClock clock;
        if (device.handover && board.take_over(*device.handover)) return;
        opened = board.open(device.is_homed_first, opening, clock);
    }).join();
    return opened;
}

}  // namespace

std::vector<std::string> arguments_of(const UsbDevice& device) {
    const Calibration& calibration = device.calibration;
    std::vector<std::string> words{
        std::to_string(device.id.vendor),
        std::to_string(device.id.product),
        device.serial,
        device.profile,
        calibration.is_measured ? "known" : "new",
        fmt::format("{}", calibration.stop_off.x),
        fmt::format("{}", calibration.stop_off.y),
        fmt::format("{}", calibration.scale),
        std::to_string(number_of(calibration.encoders)),
        std::to_string(number_of(calibration.motors)),
        calibration.has_all_counts ? "all" : "half",
        calibration.torque_limit_Nm ? fmt::format("{}", *calibration.torque_limit_Nm) : "",
        device.is_homed_first ? "home" : "at-home"};
    if (device.handover) {
        const std::vector<std::string> more = arguments_of(*device.handover);
        words.insert(words.end(), more.begin(), more.end());
    }
    return words;
}

Result<UsbDevice> device_of(std::span<const std::string> arguments) {
    const bool has_handover = arguments.size() == argument_count + handover_count;
    if (!has_handover && arguments.size() != argument_count)
        return failure("not what the kiosk starts it with");
    UsbDevice device;
    Calibration& calibration = device.calibration;
    device.id.may_probe = true;  // the kiosk chose it
    device.id.name = "the pantograph's board";
    device.serial = arguments[2];
    device.profile = arguments[3];
    calibration.is_measured = arguments[4] == "known";
    calibration.has_all_counts = arguments[10] == "all";
    device.is_homed_first = arguments[12] != "at-home";
    const bool is_read = read_number(arguments[0], device.id.vendor) &&
                         read_number(arguments[1], device.id.product) &&
                         read_number(arguments[5], calibration.stop_off.x) &&
                         read_number(arguments[6], calibration.stop_off.y) &&
                         read_number(arguments[7], calibration.scale) &&
                         read_plugs(arguments[8], calibration.encoders) &&
                         read_plugs(arguments[9], calibration.motors) &&
                         (arguments[11].empty() ||
                          read_number(arguments[11], calibration.torque_limit_Nm.emplace()));
    const bool is_handover_read = !has_handover || read_handover(arguments.subspan(argument_count),
                                                                 device.handover.emplace());
    if (!is_read || !is_handover_read || !is_sound(calibration))
        return failure("the device's numbers are out of range");
    return device;
}

Result<OpenedDevice> open_usb_device(const UsbDevice& device, const Opening& opening) {
    const auto profile = find_profile(device.profile);
    if (!profile) return tl::unexpected(profile.error());
    auto boards = UsbBoards::create();
    if (!boards) return tl::unexpected(boards.error());
    auto taken = device.handover ? take_at(*boards, device, device.handover->bus_path)
                                 : take(*boards, device);
    if (!taken) return tl::unexpected(taken.error());
    opening.share(taken->node);
    auto board =
        std::make_unique<WatchedBoard>(std::move(taken->link), *profile, device.calibration);
    if (const auto opened = open_in_time(*board, device, opening); !opened)
        return tl::unexpected(opened.error());
    OpenedDevice result;
    result.zero = {write_zero, board.get()};
    result.has_lost_place = &board->has_lost_place();
    result.release = [watched = board.get()] { return watched->release(); };
    result.profile = board->profile();
    result.place = board->place();
    if (device.handover) result.motor_heat = device.handover->motor_heat;
    result.device = std::move(board);
    return result;
}

Result<ZeroedBoard> zero_usb_device(const UsbDevice& device, const std::string& bus_path) {
    auto boards = UsbBoards::create();
    if (!boards) return tl::unexpected(boards.error());
    auto taken = bus_path.empty() ? take(*boards, device) : take_at(*boards, device, bus_path);
    if (!taken) return tl::unexpected(taken.error());
    const ZeroedBoard zeroed =
        zero_board(std::move(taken->link), profile_or_default(device.profile));
    if (zeroed == ZeroedBoard::not_confirmed)
        return failure("the board did not confirm zero torque");
    return zeroed;
}

bool cut_usb_device(const UsbDevice& device, const HeldBoard& held) {
    return write_zero(held.node.number(), held.pipes, profile_or_default(device.profile));
}

}  // namespace touchline
