#include "haptics/device/board/usb_boards.h"

#include "haptics/device/board/hapi.h"
#include "haptics/device/board/usb_link.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <optional>

#include <fcntl.h>
#include <fmt/core.h>
#include <libusb.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace touchline {
namespace {

using DevicePointer = std::unique_ptr<libusb_device, decltype(&libusb_unref_device)>;
using HandlePointer = std::unique_ptr<libusb_device_handle, decltype(&libusb_close)>;

struct Plugged {
    FoundBoard found;
    DevicePointer device;
};

std::string ids_of(const BoardId& id) {
    return fmt::format("{:04x}:{:04x}", id.vendor, id.product);
}

std::string node_of(int bus, int device_number) {
    return fmt::format("/dev/bus/usb/{:03}/{:03}", bus, device_number);
}

// Describes the process that has the node open.
std::string holder_of(const std::string& node) {
    std::error_code error;
    for (const auto& process : std::filesystem::directory_iterator("/proc", error)) {
        if (process.path().filename() == std::to_string(getpid())) continue;
        std::error_code unreadable;
        for (const auto& file :
             std::filesystem::directory_iterator(process.path() / "fd", unreadable)) {
            if (std::filesystem::read_symlink(file.path(), unreadable) != node) continue;
            return "process " + process.path().filename().string();
        }
    }
    return {};
}

std::string bus_path_of(libusb_device* device) {
    std::array<std::uint8_t, 8> ports{};
    const int count = libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
    std::string path = std::to_string(libusb_get_bus_number(device)) + "-";
    for (int i = 0; i < count; ++i)
        path += (i > 0 ? "." : "") + std::to_string(ports[static_cast<std::size_t>(i)]);
    return path;
}

std::string serial_of(libusb_device_handle* handle, std::uint8_t index) {
    std::array<unsigned char, 256> text{};
    const int size = libusb_get_string_descriptor_ascii(handle, index, text.data(),
                                                        static_cast<int>(text.size()));
    return size > 0 ? std::string(text.begin(), text.begin() + size) : std::string();
}

std::optional<SerialPipes> pipes_of(const libusb_config_descriptor& configuration) {
    for (int i = 0; i < configuration.bNumInterfaces; ++i) {
        const libusb_interface_descriptor& data = configuration.interface[i].altsetting[0];
        SerialPipes pipes{0, data.bInterfaceNumber, 0, 0};
        for (int e = 0; e < data.bNumEndpoints; ++e) {
            const libusb_endpoint_descriptor& endpoint = data.endpoint[e];
            if ((endpoint.bmAttributes & 3) != LIBUSB_TRANSFER_TYPE_BULK) continue;
            const bool is_in = (endpoint.bEndpointAddress & LIBUSB_ENDPOINT_IN) != 0;
            (is_in ? pipes.in_endpoint : pipes.out_endpoint) = endpoint.bEndpointAddress;
        }
        if (pipes.in_endpoint != 0 && pipes.out_endpoint != 0) return pipes;
    }
    return std::nullopt;
}

std::optional<SerialPipes> pipes_of(libusb_device* device) {
    libusb_config_descriptor* configuration = nullptr;
    if (libusb_get_active_config_descriptor(device, &configuration) != 0) return std::nullopt;
    const auto pipes = pipes_of(*configuration);
    libusb_free_config_descriptor(configuration);
    return pipes;
}

// Tells whether another program holds the board. The kernel's serial driver is no obstacle.
bool is_held(libusb_device_handle* handle, const SerialPipes& pipes) {
    if (libusb_kernel_driver_active(handle, pipes.data_interface) == 1) return false;
    if (libusb_claim_interface(handle, pipes.data_interface) == LIBUSB_ERROR_BUSY) return true;
    libusb_release_interface(handle, pipes.data_interface);
    return false;
}

void look_at(FoundBoard& found, libusb_device* device) {
    libusb_device_handle* raw = nullptr;
    const int error = libusb_open(device, &raw);
    if (error == LIBUSB_ERROR_ACCESS) found.access = BoardAccess::denied;
    if (error != 0) return;
    const HandlePointer handle(raw, libusb_close);
    libusb_device_descriptor descriptor{};
    libusb_get_device_descriptor(device, &descriptor);
    found.serial = serial_of(raw, descriptor.iSerialNumber);
    const auto pipes = pipes_of(device);
    if (pipes) found.access = is_held(raw, *pipes) ? BoardAccess::busy : BoardAccess::available;
}

std::optional<Plugged> recognise(libusb_device* device, std::span<const BoardId> known) {
    libusb_device_descriptor descriptor{};
    if (libusb_get_device_descriptor(device, &descriptor) != 0) return std::nullopt;
    const auto id = std::ranges::find_if(known, [&](const BoardId& candidate) {
        return candidate.vendor == descriptor.idVendor && candidate.product == descriptor.idProduct;
    });
    if (id == known.end()) return std::nullopt;
    FoundBoard found{
        *id, {}, bus_path_of(device), libusb_get_device_address(device), BoardAccess::unknown, {}};
    if (id->condition == BoardCondition::running) look_at(found, device);
    if (found.access == BoardAccess::busy)
        found.holder = holder_of(node_of(libusb_get_bus_number(device), found.device_number));
    return Plugged{std::move(found), DevicePointer(libusb_ref_device(device), libusb_unref_device)};
}

std::vector<Plugged> scan(libusb_context* context, std::span<const BoardId> known) {
    libusb_device** devices = nullptr;
    const ssize_t count = libusb_get_device_list(context, &devices);
    std::vector<Plugged> boards;
    for (ssize_t i = 0; i < count; ++i)
        if (auto board = recognise(devices[i], known)) boards.push_back(std::move(*board));
    if (count >= 0) libusb_free_device_list(devices, 1);
    std::ranges::sort(boards, {}, [](const Plugged& board) { return board.found.bus_path; });
    return boards;
}

std::string name_of(const FoundBoard& board) {
    return board.id.name + " (" + ids_of(board.id) + ", " +
           (board.serial.empty() ? "" : "serial number " + board.serial + ", ") + "at " +
           board.bus_path + ")";
}

std::string none_found(std::span<const BoardId> known) {
    std::string line = "no pantograph's board is plugged in; looked for";
    const char* separator = " ";
    for (const BoardId& id : known) {
        if (id.condition != BoardCondition::running) continue;
        line += separator + id.name + " (" + ids_of(id) + ")";
        separator = ", ";
    }
    return line;
}

std::string all_of(const std::vector<Plugged>& boards) {
    std::string line;
    for (const Plugged& board : boards) line += (line.empty() ? "" : "; ") + describe(board.found);
    return line;
}

/// Returns the board meant by `serial`, or why there is none.
Result<const Plugged*> choose(const std::vector<Plugged>& boards, std::span<const BoardId> known,
                              std::string_view serial) {
    if (boards.empty()) return failure(none_found(known));
    std::vector<const Plugged*> meant;
    for (const Plugged& board : boards) {
        const bool is_meant =
            serial.empty() ? board.found.id.may_probe : board.found.serial == serial;
        if (is_meant && board.found.id.condition == BoardCondition::running)
            meant.push_back(&board);
    }
    if (meant.size() == 1) return meant.front();
    if (meant.size() > 1)
        return failure(
            "more than one board is plugged in: choose one by its serial number; found " +
            all_of(boards));
    if (serial.empty()) return failure("found only " + all_of(boards));
    return failure("no board has the serial number " + std::string(serial) + "; found " +
                   all_of(boards));
}

constexpr unsigned longest_send_ms = 10;

}  // namespace

Result<UsbBoards> UsbBoards::create() {
    libusb_context* context = nullptr;
    const int error = libusb_init(&context);
    if (error != 0)
        return failure(std::string("the USB cannot be reached: ") +
                       libusb_strerror(static_cast<libusb_error>(error)));
    return UsbBoards(std::shared_ptr<libusb_context>(context, libusb_exit));
}

std::vector<FoundBoard> UsbBoards::list(std::span<const BoardId> known) const {
    std::vector<FoundBoard> all;
    for (Plugged& board : scan(context_.get(), known)) all.push_back(std::move(board.found));
    return all;
}

Result<FoundBoard> UsbBoards::find(std::span<const BoardId> known, std::string_view serial) const {
    const std::vector<Plugged> boards = scan(context_.get(), known);
    const auto chosen = choose(boards, known, serial);
    if (!chosen) return tl::unexpected(chosen.error());
    return (*chosen)->found;
}

Result<OpenedBoard> UsbBoards::open(const FoundBoard& board, const UsbLinkOptions& options) const {
    const std::vector<Plugged> boards = scan(context_.get(), std::span(&board.id, 1));
    const auto same = std::ranges::find_if(boards, [&](const Plugged& plugged) {
        return plugged.found.bus_path == board.bus_path && plugged.found.serial == board.serial;
    });
    if (same == boards.end()) return failure(name_of(board) + " is no longer plugged in");
    if (same->found.access != BoardAccess::available) return failure(describe(same->found));
    const auto cannot = [&](const std::string& why) {
        return failure("cannot open " + name_of(board) + ": " + why);
    };
    const auto pipes = pipes_of(same->device.get());
    if (!pipes) return failure(name_of(board) + " is no serial board");
    // Opened here and not by libusb, which keeps the descriptor to itself.
    const int bus = libusb_get_bus_number(same->device.get());
    const int node = ::open(node_of(bus, same->found.device_number).c_str(), O_RDWR | O_CLOEXEC);
    if (node < 0) return cannot(std::strerror(errno));
    libusb_device_handle* raw = nullptr;
    int error = libusb_wrap_sys_device(context_.get(), node, &raw);
    HandlePointer handle(raw, libusb_close);
    if (error == 0) {
        libusb_set_auto_detach_kernel_driver(raw, 1);
        error = libusb_claim_interface(raw, pipes->control_interface);
    }
    if (error == 0) error = libusb_claim_interface(raw, pipes->data_interface);
    if (error != 0) {
        handle.reset();
        ::close(node);
        return cannot(libusb_strerror(static_cast<libusb_error>(error)));
    }
    return OpenedBoard{std::make_unique<UsbLink>(context_, handle.release(), node, *pipes,
                                                 options.send_time_out_ms),
                       {node, *pipes, board.bus_path}};
}

std::string describe(const FoundBoard& board) {
    const std::string name = name_of(board);
    if (board.id.condition == BoardCondition::needs_firmware)
        return name + " has no firmware: it waits to be flashed";
    if (board.id.condition == BoardCondition::wrong_socket)
        return name + " is plugged in by its programming socket: use its other USB socket";
    switch (board.access) {
        case BoardAccess::available:
            return name + " is ready to be opened";
        case BoardAccess::busy:
            return name + " is in use by " +
                   (board.holder.empty() ? "another program" : board.holder) +
                   ": close that program";
        case BoardAccess::denied:
            return name + " may not be opened by this user: install the udev rules of Touchline";
        default:
            return name + " does not answer: unplug it and plug it in again";
    }
}

// Does not use libusb: it would get the transfers that a dead process began, with addresses of that
// process's memory to write to. Giving the interface back ends them all, unread.
bool write_zero(int descriptor, const SerialPipes& pipes, const DeviceProfile& profile) {
    auto interface = static_cast<unsigned>(pipes.data_interface);
    (void)ioctl(descriptor, USBDEVFS_RELEASEINTERFACE, &interface);
    if (ioctl(descriptor, USBDEVFS_CLAIMINTERFACE, &interface) != 0) return false;
    Command zero = write_command({}, profile.handle ? std::optional(0.0) : std::nullopt);
    usbdevfs_bulktransfer transfer{pipes.out_endpoint, static_cast<unsigned>(zero.bytes().size()),
                                   longest_send_ms, const_cast<std::uint8_t*>(zero.bytes().data())};
    return ioctl(descriptor, USBDEVFS_BULK, &transfer) == static_cast<int>(zero.bytes().size());
}

Result<UsbPantograph> take_pantograph(const UsbBoards& usb, const BoardSettings& settings,
                                      std::string_view serial, std::string_view profile_name,
                                      const UsbLinkOptions& options) {
    auto found = usb.find(settings.boards, serial);
    if (!found) return tl::unexpected(found.error());
    const UnitSettings* unit = find_unit(settings, found->serial);
    const auto profile = find_profile(unit != nullptr ? unit->profile : profile_name);
    if (!profile) return tl::unexpected(profile.error());
    auto opened = usb.open(*found, options);
    if (!opened) return tl::unexpected(opened.error());
    const Calibration calibration = unit != nullptr ? unit->calibration : Calibration{};
    return UsbPantograph{
        std::move(*found), calibrated(*profile, calibration),
        std::make_unique<PantographBoard>(std::move(opened->link), *profile, calibration)};
}

}  // namespace touchline
