#include "tests/machines/sim/umockdev/mocked_board.h"

#include "config/types/steady_clock.h"
#include "tests/machines/sim/board/board_rig.h"
#include "tests/machines/sim/board/usb_function.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <sstream>
#include <utility>

namespace touchline {
namespace {

constexpr std::size_t set_up_bytes = 8;

void answer(UMockdevIoctlClient* client, long result, int error) {
    umockdev_ioctl_client_complete(client, result, error);
}

template <class T>
void store(UMockdevIoctlData* data, std::size_t offset, const T& value) {
    umockdev_ioctl_data_update(
        data, offset, reinterpret_cast<std::uint8_t*>(const_cast<T*>(&value)), sizeof value);
}

double steady_now_s() {
    return 1e-9 * static_cast<double>(steady_now_ns());
}

std::string hex_of(const PacketBytes& bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        char digits[3];
        std::snprintf(digits, sizeof digits, "%02X", static_cast<unsigned>(byte));
        text += digits;
    }
    return text;
}

[[noreturn]] void give_up(const GError* error) {
    std::fprintf(stderr, "umockdev: %s\n", error->message);
    std::abort();
}

std::string three(int number) {
    char digits[16];
    std::snprintf(digits, sizeof digits, "%03d", number);
    return digits;
}

}  // namespace

void UsbRequests::handle(UMockdevIoctlClient* client) {
    UMockdevIoctlData* arg = umockdev_ioctl_client_get_arg(client);
    const gulong request = umockdev_ioctl_client_get_request(client);
    const bool is_reap = request == USBDEVFS_REAPURBNDELAY || request == USBDEVFS_REAPURB;
    if (!transfers_.is_plugged()) {
        // Does as the kernel: transfers under way end with ESHUTDOWN, all else fails.
        transfers_.end_all(-ESHUTDOWN);
        if (!is_reap || !transfers_.has_ended()) return answer(client, -1, ENODEV);
    }
    transfers_.deliver();
    switch (request) {
        case USBDEVFS_SUBMITURB:
            return submit(client, arg);
        case USBDEVFS_REAPURB:
        case USBDEVFS_REAPURBNDELAY:
            return reap(client, arg);
        case USBDEVFS_DISCARDURB: {
            const bool is_there = transfers_.discard(*reinterpret_cast<std::uint64_t*>(arg->data));
            return answer(client, is_there ? 0 : -1, is_there ? 0 : EINVAL);
        }
        case USBDEVFS_CLAIMINTERFACE:
        case USBDEVFS_DISCONNECT_CLAIM:
            return answer(client, faults().is_held ? -1 : 0, faults().is_held ? EBUSY : 0);
        case USBDEVFS_CLEAR_HALT:
            transfers_.clear_halts();
            return answer(client, 0, 0);
        case USBDEVFS_GETDRIVER:
        case USBDEVFS_IOCTL:
            return answer(client, -1, ENODATA);
        case USBDEVFS_GET_CAPABILITIES:
            store(umockdev_ioctl_data_resolve(arg, 0, 4, nullptr), 0, std::uint32_t{0});
            return answer(client, 0, 0);
        default:
            return answer(client, 0, 0);
    }
}

void UsbRequests::submit(UMockdevIoctlClient* client, UMockdevIoctlData* arg) {
    UMockdevIoctlData* data = umockdev_ioctl_data_resolve(arg, 0, sizeof(usbdevfs_urb), nullptr);
    const auto& urb = *reinterpret_cast<usbdevfs_urb*>(data->data);
    UMockdevIoctlData* buffer = umockdev_ioctl_data_resolve(
        data, offsetof(usbdevfs_urb, buffer), static_cast<gsize>(urb.buffer_length), nullptr);
    const std::uint64_t id = data->client_addr;
    const std::span<const std::uint8_t> bytes(buffer->data,
                                              static_cast<std::size_t>(urb.buffer_length));
    urbs_[id] = {data, buffer};
    answer(client, 0, 0);
    if (urb.type == USBDEVFS_URB_TYPE_CONTROL)
        transfers_.control(id, bytes);
    else if ((urb.endpoint & 0x80) != 0)
        transfers_.listen(id, urb.endpoint);
    else
        transfers_.send(id, bytes);
}

void UsbRequests::reap(UMockdevIoctlClient* client, UMockdevIoctlData* arg) {
    const auto ended = transfers_.reap();
    if (!ended) return answer(client, -1, EAGAIN);
    const Urb urb = urbs_.at(ended->id);
    urbs_.erase(ended->id);
    const bool is_control =
        reinterpret_cast<usbdevfs_urb*>(urb.data->data)->type == USBDEVFS_URB_TYPE_CONTROL;
    if (!ended->received.empty())
        umockdev_ioctl_data_update(urb.buffer, is_control ? set_up_bytes : 0,
                                   const_cast<std::uint8_t*>(ended->received.data()),
                                   static_cast<gint>(ended->received.size()));
    store(urb.data, offsetof(usbdevfs_urb, status), ended->status);
    store(urb.data, offsetof(usbdevfs_urb, actual_length),
          static_cast<int>(ended->received.size() + ended->sent));
    UMockdevIoctlData* pointer = umockdev_ioctl_data_resolve(arg, 0, sizeof(void*), nullptr);
    umockdev_ioctl_data_set_ptr(pointer, 0, urb.data);
    answer(client, 0, 0);
}

MockedUsb::MockedUsb() : testbed_(umockdev_testbed_new()) {}

MockedUsb::~MockedUsb() {
    g_object_unref(testbed_);
}

std::string MockedUsb::folder() const {
    gchar* folder = umockdev_testbed_get_root_dir(testbed_);
    std::string text(folder);
    g_free(folder);
    return text;
}

MockedBoard::MockedBoard(MockedUsb& usb, const BoardTruth& truth, int port,
                         std::shared_ptr<const IntendedPath> path)
    : usb_(usb),
      port_(port),
      board_(truth, path ? std::move(path) : resting_hand(truth.profile)),
      requests_(board_),
      start_s_(steady_now_s()) {
    show();
}

MockedBoard::~MockedBoard() {
    if (!path_.empty()) unplug();
}

std::string MockedUsb::node_of(int device_number) {
    return "/dev/bus/usb/001/" + three(device_number);
}

void MockedUsb::show(const BoardEmulator& board, int port, int device_number) {
    const std::string hex =
        hex_of(device_descriptor(board)) + hex_of(configuration_descriptor(board));
    std::ostringstream text;
    text << "P: /devices/pci0000:00/0000:00:03.0/usb1/1-" << port << "\n"
         << "N: bus/usb/001/" << three(device_number) << "=" << hex << "\n"
         << "E: DEVNAME=" << node_of(device_number) << "\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\n"
         << "E: BUSNUM=001\nE: DEVNUM=" << three(device_number) << "\n"
         << "A: bConfigurationValue=1\\n\nA: busnum=1\\n\nA: devnum=" << device_number << "\\n\n"
         << "A: speed=12\\n\nH: descriptors=" << hex << "\n";
    GError* error = nullptr;
    if (!umockdev_testbed_add_from_string(testbed_, text.str().c_str(), &error)) give_up(error);
}

std::string MockedBoard::node() const {
    return MockedUsb::node_of(device_number_);
}

void MockedBoard::show() {
    device_number_ += 1 + port_;
    usb_.show(board_, port_, device_number_);
    GError* error = nullptr;
    handler_ = static_cast<UMockdevIoctlBase*>(g_object_new(UMOCKDEV_TYPE_IOCTL_BASE, nullptr));
    g_signal_connect(handler_, "handle-ioctl", G_CALLBACK(on_ioctl), this);
    if (!umockdev_testbed_attach_ioctl(usb_.testbed(), node().c_str(), handler_, &error))
        give_up(error);
    path_ = "/sys/devices/pci0000:00/0000:00:03.0/usb1/1-" + std::to_string(port_);
}

void MockedBoard::unplug() {
    with([](BoardEmulator& board, UsbFaults&) {
        if (board.is_plugged()) board.unplug();
    });
    umockdev_testbed_uevent(usb_.testbed(), path_.c_str(), "remove");
    umockdev_testbed_detach_ioctl(usb_.testbed(), node().c_str(), nullptr);
    umockdev_testbed_remove_device(usb_.testbed(), path_.c_str());
    g_object_unref(handler_);
    path_.clear();
}

void MockedBoard::plug() {
    with([](BoardEmulator& board, UsbFaults&) { board.plug(); });
    show();
    umockdev_testbed_uevent(usb_.testbed(), path_.c_str(), "add");
}

void MockedBoard::with(const std::function<void(BoardEmulator&, UsbFaults&)>& look) {
    const std::lock_guard lock(mutex_);
    board_.advance_to(steady_now_s() - start_s_);
    look(board_, requests_.faults());
}

gboolean MockedBoard::on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer me) {
    auto& mocked = *static_cast<MockedBoard*>(me);
    const std::lock_guard lock(mocked.mutex_);
    mocked.board_.advance_to(steady_now_s() - mocked.start_s_);
    mocked.requests_.handle(client);
    return TRUE;
}

}  // namespace touchline
