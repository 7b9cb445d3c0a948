#include "tests/machines/sim/board/usb_transfers.h"

#include "tests/machines/sim/board/usb_function.h"

#include <cerrno>
#include <utility>

namespace touchline {
namespace {

constexpr std::size_t set_up_bytes = 8;
constexpr std::size_t short_bytes = 4;

bool take_one(int& left) {
    if (left <= 0) return false;
    --left;
    return true;
}

}  // namespace

void UsbTransfers::send(std::uint64_t id, std::span<const std::uint8_t> bytes) {
    if (auto ended = sent(id, bytes))
        ended_.push_back(std::move(*ended));
    else
        under_way_[id] = board_out_endpoint;
}

std::optional<UsbTransfers::Ended> UsbTransfers::sent(std::uint64_t id,
                                                      std::span<const std::uint8_t> bytes) {
    if (take_one(faults.stalls_out)) is_out_halted_ = true;
    if (is_out_halted_) return Ended{id, -EPIPE, {}, 0};
    if (take_one(faults.drops_out)) return std::nullopt;
    if (faults.unplug_after_out > 0 && --faults.unplug_after_out == 0) {
        board_.unplug();
        end_all(-ESHUTDOWN);
        return Ended{id, -ESHUTDOWN, {}, 0};
    }
    const bool is_short = bytes.size() > short_bytes && take_one(faults.short_out);
    const auto through = is_short ? bytes.first(short_bytes) : bytes;
    board_.host_sends(through);
    return Ended{id, is_short ? -EPROTO : 0, {}, through.size()};
}

void UsbTransfers::listen(std::uint64_t id, std::uint8_t endpoint) {
    under_way_[id] = endpoint;
    if (endpoint == board_in_endpoint) {
        listening_.push_back(id);
        board_.host_listens(true);
    }
    deliver();
}

void UsbTransfers::control(std::uint64_t id, std::span<const std::uint8_t> bytes) {
    const UsbRequest request = request_of(bytes);
    auto said = answer(board_, request, bytes.subspan(set_up_bytes));
    if (!said) return ended_.push_back({id, -EPIPE, {}, 0});
    const bool is_in = (request.type & 0x80) != 0;
    if (is_in)
        ended_.push_back({id, 0, std::move(*said), 0});
    else
        ended_.push_back({id, 0, {}, request.length});
}

bool UsbTransfers::discard(std::uint64_t id) {
    if (under_way_.erase(id) == 0) return false;
    std::erase(listening_, id);
    if (listening_.empty()) board_.host_listens(false);
    ended_.push_back({id, -ENOENT, {}, 0});
    return true;
}

void UsbTransfers::end_all(int status) {
    listening_.clear();
    ready_.clear();
    held_back_.clear();
    for (const auto& [id, endpoint] : std::exchange(under_way_, {}))
        ended_.push_back({id, status, {}, 0});
}

void UsbTransfers::forget_all() {
    end_all(-ENOENT);
    ended_.clear();
    board_.host_listens(false);
}

void UsbTransfers::deliver() {
    while (auto packet = board_.take_packet()) spoil(std::move(packet->bytes));
    if (board_.now_s() >= held_until_s_)
        for (; !held_back_.empty(); held_back_.pop_front()) ready_.push_back(held_back_.front());
    for (; !ready_.empty() && !listening_.empty() && !is_in_halted_; ready_.pop_front()) {
        const std::uint64_t id = listening_.front();
        listening_.pop_front();
        under_way_.erase(id);
        is_in_halted_ = take_one(faults.stalls_in);
        if (is_in_halted_)
            ended_.push_back({id, -EPIPE, {}, 0});
        else
            ended_.push_back({id, 0, std::move(ready_.front()), 0});
    }
}

std::optional<UsbTransfers::Ended> UsbTransfers::reap() {
    if (ended_.empty()) return std::nullopt;
    Ended first = std::move(ended_.front());
    ended_.pop_front();
    return first;
}

void UsbTransfers::spoil(PacketBytes packet) {
    if (take_one(faults.lost_in)) return;
    if (take_one(faults.late_in)) held_until_s_ = board_.now_s() + faults.late_s;
    if (board_.now_s() < held_until_s_) return held_back_.push_back(std::move(packet));
    if (take_one(faults.empty_in)) ready_.emplace_back();
    if (take_one(faults.doubled_in)) ready_.push_back(packet);
    if (take_one(faults.garbled_in))
        for (std::uint8_t& byte : packet) byte ^= 0x15;
    ready_.push_back(std::move(packet));
}

}  // namespace touchline
