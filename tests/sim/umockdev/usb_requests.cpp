#include "tests/sim/umockdev/usb_requests.h"

#include "tests/sim/board/usb_function.h"

#include <algorithm>
#include <cerrno>
#include <span>
#include <utility>

namespace touchline {
namespace {

constexpr std::size_t set_up_bytes = 8;
constexpr std::size_t short_bytes = 4;

void answer(UMockdevIoctlClient* client, long result, int error) {
    umockdev_ioctl_client_complete(client, result, error);
}

template <class T>
void store(UMockdevIoctlData* data, std::size_t offset, const T& value) {
    umockdev_ioctl_data_update(
        data, offset, reinterpret_cast<std::uint8_t*>(const_cast<T*>(&value)), sizeof value);
}

bool take_one(int& left) {
    if (left <= 0) return false;
    --left;
    return true;
}

}  // namespace

void UsbRequests::handle(UMockdevIoctlClient* client) {
    UMockdevIoctlData* arg = umockdev_ioctl_client_get_arg(client);
    const gulong request = umockdev_ioctl_client_get_request(client);
    const bool is_reap = request == USBDEVFS_REAPURBNDELAY || request == USBDEVFS_REAPURB;
    if (!board_.is_plugged()) {
        // As the kernel does: what is under way ends with ESHUTDOWN, all else fails.
        end_all(-ESHUTDOWN);
        if (!is_reap || done_.empty()) return answer(client, -1, ENODEV);
    }
    deliver();
    switch (request) {
        case USBDEVFS_SUBMITURB:
            return submit(client, arg);
        case USBDEVFS_REAPURB:
        case USBDEVFS_REAPURBNDELAY:
            return reap(client, arg);
        case USBDEVFS_DISCARDURB:
            return discard(client, arg);
        case USBDEVFS_CLAIMINTERFACE:
        case USBDEVFS_DISCONNECT_CLAIM:
            return answer(client, faults.is_held ? -1 : 0, faults.is_held ? EBUSY : 0);
        case USBDEVFS_CLEAR_HALT:
            is_out_halted_ = is_in_halted_ = false;
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
    auto& urb = *reinterpret_cast<usbdevfs_urb*>(data->data);
    UMockdevIoctlData* buffer = umockdev_ioctl_data_resolve(
        data, offsetof(usbdevfs_urb, buffer), static_cast<gsize>(urb.buffer_length), nullptr);
    const std::uint64_t id = data->client_addr;
    urbs_[id] = {data, buffer, urb.endpoint};
    answer(client, 0, 0);
    if (urb.type == USBDEVFS_URB_TYPE_CONTROL) {
        submit_control(id, urb);
    } else if ((urb.endpoint & 0x80) != 0) {
        listening_.push_back(id);
        if (urb.endpoint == board_in_endpoint) board_.host_listens(true);
        deliver();
    } else {
        submit_out(id, urb);
    }
}

void UsbRequests::submit_control(std::uint64_t id, usbdevfs_urb& urb) {
    const std::uint8_t* bytes = urbs_[id].buffer->data;
    const std::span<const std::uint8_t> all(bytes, static_cast<std::size_t>(urb.buffer_length));
    const UsbRequest request = request_of(all);
    const auto said = touchline::answer(board_, request, all.subspan(set_up_bytes));
    if (!said) return finish(id, -EPIPE, {}, 0, 0);
    const bool is_in = (request.type & 0x80) != 0;
    finish(id, 0, is_in ? *said : PacketBytes{}, is_in ? said->size() : request.length,
           set_up_bytes);
}

void UsbRequests::submit_out(std::uint64_t id, const usbdevfs_urb& urb) {
    const std::span<const std::uint8_t> bytes(urbs_[id].buffer->data,
                                              static_cast<std::size_t>(urb.buffer_length));
    if (take_one(faults.stalls_out)) is_out_halted_ = true;
    if (is_out_halted_) return finish(id, -EPIPE, {}, 0, 0);
    if (take_one(faults.drops_out)) return;
    if (faults.unplug_after_out > 0 && --faults.unplug_after_out == 0) {
        board_.unplug();
        return end_all(-ESHUTDOWN);
    }
    const bool is_short = bytes.size() > short_bytes && take_one(faults.short_out);
    const auto sent = is_short ? bytes.first(short_bytes) : bytes;
    board_.host_sends(sent);
    finish(id, is_short ? -EPROTO : 0, {}, sent.size(), 0);
}

void UsbRequests::reap(UMockdevIoctlClient* client, UMockdevIoctlData* arg) {
    if (done_.empty()) return answer(client, -1, EAGAIN);
    const std::uint64_t id = done_.front();
    done_.pop_front();
    UMockdevIoctlData* pointer = umockdev_ioctl_data_resolve(arg, 0, sizeof(void*), nullptr);
    umockdev_ioctl_data_set_ptr(pointer, 0, urbs_[id].data);
    urbs_.erase(id);
    answer(client, 0, 0);
}

void UsbRequests::discard(UMockdevIoctlClient* client, UMockdevIoctlData* arg) {
    const std::uint64_t id = *reinterpret_cast<std::uint64_t*>(arg->data);
    if (!is_under_way(id)) return answer(client, -1, EINVAL);
    std::erase(listening_, id);
    const bool is_anyone_left = std::any_of(listening_.begin(), listening_.end(), [&](auto other) {
        return urbs_[other].endpoint == board_in_endpoint;
    });
    if (!is_anyone_left) board_.host_listens(false);
    finish(id, -ENOENT, {}, 0, 0);
    answer(client, 0, 0);
}

bool UsbRequests::is_under_way(std::uint64_t id) const {
    return urbs_.count(id) != 0 && std::find(done_.begin(), done_.end(), id) == done_.end();
}

void UsbRequests::deliver() {
    while (auto packet = board_.take_packet()) spoil(std::move(packet->bytes));
    if (board_.now_s() >= held_until_s_)
        for (; !held_back_.empty(); held_back_.pop_front()) ready_.push_back(held_back_.front());
    while (!ready_.empty() && !listening_.empty() && !is_in_halted_) {
        const auto next = std::find_if(listening_.begin(), listening_.end(), [&](auto id) {
            return urbs_[id].endpoint == board_in_endpoint;
        });
        if (next == listening_.end()) return;
        const std::uint64_t id = *next;
        listening_.erase(next);
        if (take_one(faults.stalls_in)) {
            is_in_halted_ = true;
            ready_.pop_front();
            return finish(id, -EPIPE, {}, 0, 0);
        }
        finish(id, 0, ready_.front(), ready_.front().size(), 0);
        ready_.pop_front();
    }
}

void UsbRequests::spoil(PacketBytes packet) {
    if (take_one(faults.lost_in)) return;
    if (take_one(faults.late_in)) held_until_s_ = board_.now_s() + faults.late_s;
    if (board_.now_s() < held_until_s_) return held_back_.push_back(std::move(packet));
    if (take_one(faults.empty_in)) ready_.emplace_back();
    if (take_one(faults.doubled_in)) ready_.push_back(packet);
    if (take_one(faults.garbled_in))
        for (std::uint8_t& byte : packet) byte ^= 0x15;
    ready_.push_back(std::move(packet));
}

void UsbRequests::finish(std::uint64_t id, int status, const PacketBytes& data, std::size_t actual,
                         std::size_t offset) {
    const Urb& urb = urbs_[id];
    if (!data.empty())
        umockdev_ioctl_data_update(urb.buffer, offset, const_cast<std::uint8_t*>(data.data()),
                                   static_cast<gint>(data.size()));
    store(urb.data, offsetof(usbdevfs_urb, status), status);
    store(urb.data, offsetof(usbdevfs_urb, actual_length), static_cast<int>(actual));
    done_.push_back(id);
}

void UsbRequests::end_all(int status) {
    listening_.clear();
    ready_.clear();
    held_back_.clear();
    for (const auto& [id, urb] : urbs_)
        if (std::find(done_.begin(), done_.end(), id) == done_.end()) finish(id, status, {}, 0, 0);
}

}  // namespace touchline
