#include "haptics/device/usb_node.h"

#include "haptics/device/hapi.h"

#include <optional>

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

namespace touchline {
namespace {

constexpr unsigned longest_send_ms = 10;

}  // namespace

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

}  // namespace touchline
