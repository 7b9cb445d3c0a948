#include "haptics/device/moteus/can_socket.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <thread>

#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr std::uint32_t greatest_short_id = CAN_SFF_MASK;

// A full queue means "later"; only a device that is no more, or was taken down, is gone.
bool is_only_busy(int error) {
    return error == EAGAIN || error == EINTR || error == ENOBUFS;
}

}  // namespace

CanSocket::~CanSocket() {
    close(descriptor_);
}

bool CanSocket::send(const CanFrame& frame) {
    canfd_frame sent{};
    sent.can_id = frame.id | (frame.id > greatest_short_id ? CAN_EFF_FLAG : 0U);
    sent.len = static_cast<std::uint8_t>(frame.size);
    sent.flags = CANFD_BRS;
    std::ranges::copy(frame.bytes(), sent.data);
    const ssize_t size = ::write(descriptor_, &sent, sizeof sent);
    if (size == static_cast<ssize_t>(sizeof sent)) return true;
    is_gone_ = is_gone_ || size >= 0 || !is_only_busy(errno);
    return false;
}

std::optional<CanFrame> CanSocket::receive() {
    while (!is_gone_) {
        canfd_frame got{};
        const ssize_t size = ::read(descriptor_, &got, sizeof got);
        if (size <= 0) {
            is_gone_ = size == 0 || !is_only_busy(errno);
            return std::nullopt;
        }
        // Short frames of other devices on the bus, and of errors, are not for here.
        if (size != static_cast<ssize_t>(CANFD_MTU) || (got.can_id & CAN_ERR_FLAG) != 0) continue;
        CanFrame frame;
        frame.id = got.can_id & CAN_EFF_MASK;
        frame.size = std::min<std::size_t>(got.len, frame.data.size());
        std::copy_n(got.data, frame.size, frame.data.begin());
        return frame;
    }
    return std::nullopt;
}

void CanSocket::rest(double span_s) {
    std::this_thread::sleep_for(std::chrono::duration<double>(span_s));
}

Result<std::unique_ptr<FrameLink>> open_can_socket(const std::string& interface) {
    const auto refused = [&](const std::string& why) {
        return failure("the CAN interface '" + interface + "' could not be opened: " + why);
    };
    ifreq asked{};
    if (interface.empty() || interface.size() >= sizeof asked.ifr_name)
        return refused("a name has 1 to 15 letters: name it as 'ip link' lists it");
    std::ranges::copy(interface, asked.ifr_name);
    const int descriptor = socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, CAN_RAW);
    if (descriptor < 0)
        return refused(
            "there are no CAN sockets for it: load the module can_raw, or copy "
            "device-can.conf for a kiosk that is a service, as the manual says");
    auto link = std::make_unique<CanSocket>(descriptor);
    if (ioctl(descriptor, SIOCGIFINDEX, &asked) != 0)
        return refused("there is none of that name: name it as 'ip link' lists it");
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = asked.ifr_ifindex;
    const int on = 1;
    const bool is_fd =
        setsockopt(descriptor, SOL_CAN_RAW, CAN_RAW_FD_FRAMES, &on, sizeof on) == 0 &&
        ioctl(descriptor, SIOCGIFMTU, &asked) == 0 && asked.ifr_mtu >= static_cast<int>(CANFD_MTU);
    if (!is_fd) return refused("it carries no CAN-FD frames: set it up with 'fd on'");
    if (ioctl(descriptor, SIOCGIFFLAGS, &asked) != 0 || (asked.ifr_flags & IFF_UP) == 0)
        return refused("it is down: 'ip link set' takes it up");
    if (bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
        return refused("the system refuses it (error " + std::to_string(errno) + ")");
    return link;
}

}  // namespace touchline
