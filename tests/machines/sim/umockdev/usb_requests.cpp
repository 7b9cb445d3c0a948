#include "tests/machines/sim/umockdev/usb_requests.h"

#include <cerrno>
#include <span>

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

}  // namespace touchline
