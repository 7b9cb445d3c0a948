#include "tests/machines/sim/board/emulated_link.h"

#include <algorithm>
#include <utility>

namespace touchline {
namespace {

constexpr double way_s = 1e-4;  // one way over the bus
constexpr double send_time_out_s = 0.01;
constexpr double control_s = 1e-3;
constexpr double leap_rad = 0.15;

bool spoils_reply(LinkFault fault) {
    return fault >= LinkFault::late_reply && fault <= LinkFault::failed_reply;
}

PacketBytes garbled(PacketBytes bytes, std::mt19937_64& random) {
    const auto flips = 1 + random() % 8;
    for (std::uint64_t i = 0; i < flips && !bytes.empty(); ++i)
        bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1U << random() % 8);
    return bytes;
}

PacketBytes cut(PacketBytes bytes, std::mt19937_64& random) {
    const std::size_t size = 2 + random() % 63;
    bytes.resize(size == bytes.size() ? size - 1 : size, 0x5a);
    return bytes;
}

}  // namespace

EmulatedLink::EmulatedLink(BoardEmulator& board, VirtualTime& time,
                           std::vector<PlannedFault> faults)
    : board_(board), time_(time), faults_(std::move(faults)) {
    board_.advance_to(time_.now_s);
    board_.host_listens(true);
}

void EmulatedLink::sever() {
    is_severed_ = true;
    held_back_.reset();
    board_.host_listens(false);
}

EmulatedLink::~EmulatedLink() {
    if (is_severed_) return;
    catch_up();
    board_.host_listens(false);
    board_.set_lines(false, false);
}

LinkStatus EmulatedLink::send(std::span<const std::uint8_t> command) {
    catch_up();
    if (is_gone()) return LinkStatus::gone;
    if (sent().status == LinkStatus::under_way) return LinkStatus::under_way;
    if (is_out_stalled_) return LinkStatus::stalled;
    const auto planned = std::find_if(faults_.begin(), faults_.end(),
                                      [&](const auto& fault) { return fault.at_send == sends_; });
    now_ = planned == faults_.end() ? PlannedFault{} : *planned;
    ++sends_;
    if (keeps_commands_) commands_.emplace_back(command.begin(), command.end());
    sending_ = {LinkStatus::done, command.size()};
    send_ends_s_ = time_.now_s + way_s;
    hand_over(command);
    return LinkStatus::done;
}

void EmulatedLink::hand_over(std::span<const std::uint8_t> command) {
    std::mt19937_64 random(now_.seed);
    if (spoils_reply(now_.fault)) reply_fault_ = now_;
    switch (now_.fault) {
        case LinkFault::short_send:
            sending_ = {LinkStatus::timed_out, 1 + random() % (command.size() - 1)};
            board_.host_sends(command.first(sending_.bytes));
            return;
        case LinkFault::late_send:
            send_ends_s_ = time_.now_s + now_.span_s;
            held_back_.emplace(command.begin(), command.end());
            return;
        case LinkFault::lost_send:
            sending_ = {LinkStatus::timed_out, 0};
            send_ends_s_ = time_.now_s + send_time_out_s;
            return;
        case LinkFault::unconfirmed_send:
            sending_.status = LinkStatus::timed_out;
            send_ends_s_ = time_.now_s + send_time_out_s;
            break;
        case LinkFault::stalled_send:
            sending_ = {LinkStatus::stalled, 0};
            is_out_stalled_ = true;
            return;
        case LinkFault::unplugged_before:
            board_.unplug();
            return;
        case LinkFault::reset_board:
            board_.host_sends(std::array<std::uint8_t, 2>{});
            break;
        case LinkFault::lost_counts:
            board_.lose_counts(
                1 + static_cast<int>(random() % 2),
                static_cast<std::int64_t>(leap_rad / encoder_quantum(board_.truth().profile).x));
            break;
        default:
            break;
    }
    board_.host_sends(command);
    if (now_.fault == LinkFault::unplugged_after) {
        board_.advance_to(time_.now_s);
        board_.unplug();
    }
}

Sent EmulatedLink::sent() {
    catch_up();
    if (is_gone()) return {LinkStatus::gone, 0};
    return time_.now_s < send_ends_s_ ? Sent{LinkStatus::under_way, 0} : sending_;
}

Received EmulatedLink::receive() {
    catch_up();
    if (is_gone()) return {LinkStatus::gone, {}, 0};
    if (waiting_.empty() || waiting_.front().at_s > time_.now_s) return {};
    Received received;
    received.status = waiting_.front().status;
    received.size = std::min(waiting_.front().bytes.size(), received.data.size());
    std::copy_n(waiting_.front().bytes.begin(), received.size, received.data.begin());
    waiting_.pop_front();
    return received;
}

LinkStatus EmulatedLink::set_lines(bool are_high) {
    rest(control_s);
    if (is_gone()) return LinkStatus::gone;
    board_.set_line_coding(115200);
    board_.set_lines(are_high, are_high);
    return LinkStatus::done;
}

LinkStatus EmulatedLink::clear_stall() {
    catch_up();
    if (is_gone()) return LinkStatus::gone;
    if (!stall_ends_s_) stall_ends_s_ = time_.now_s + control_s;
    if (time_.now_s < *stall_ends_s_) return LinkStatus::under_way;
    stall_ends_s_.reset();
    is_out_stalled_ = is_in_stalled_ = false;
    return LinkStatus::done;
}

void EmulatedLink::cancel_send() {
    if (sent().status != LinkStatus::under_way) return;
    if (held_back_) sending_.bytes = 0;
    held_back_.reset();
    sending_.status = LinkStatus::timed_out;
    send_ends_s_ = std::min(send_ends_s_, time_.now_s + way_s);
}

void EmulatedLink::rest(double span_s) {
    time_.now_s += span_s;
    catch_up();
}

void EmulatedLink::catch_up() {
    if (is_severed_) return;
    if (held_back_ && time_.now_s >= send_ends_s_) {
        board_.advance_to(send_ends_s_);
        board_.host_sends(*held_back_);
        held_back_.reset();
    }
    board_.advance_to(time_.now_s);
    while (auto packet = board_.take_packet()) spoil(std::move(*packet));
}

void EmulatedLink::spoil(SentPacket packet) {
    const bool is_slow = time_.now_s <= slow_until_s_;
    const double at_s = packet.at_s + way_s + (is_slow ? slow_s_ : 0.0);
    if (!reply_fault_) return arrive(at_s, LinkStatus::done, std::move(packet.bytes));
    const PlannedFault planned = *std::exchange(reply_fault_, std::nullopt);
    std::mt19937_64 random(planned.seed);
    switch (planned.fault) {
        case LinkFault::late_reply:
            return arrive(at_s + planned.span_s, LinkStatus::done, std::move(packet.bytes));
        case LinkFault::lost_reply:
            return;
        case LinkFault::garbled_reply:
            return arrive(at_s, LinkStatus::done, garbled(std::move(packet.bytes), random));
        case LinkFault::cut_reply:
            return arrive(at_s, LinkStatus::done, cut(std::move(packet.bytes), random));
        case LinkFault::duplicate_reply:
            arrive(at_s, LinkStatus::done, packet.bytes);
            return arrive(at_s, LinkStatus::done, std::move(packet.bytes));
        case LinkFault::empty_packet:
            arrive(at_s, LinkStatus::done, {});
            return arrive(at_s, LinkStatus::done, std::move(packet.bytes));
        case LinkFault::stalled_reply:
            is_in_stalled_ = true;
            return arrive(at_s, LinkStatus::stalled, {});
        default:
            return arrive(at_s, LinkStatus::failed, {});
    }
}

// Packets arrive in order: none overtakes a late one. A halted endpoint gives nothing more.
void EmulatedLink::arrive(double at_s, LinkStatus status, PacketBytes bytes) {
    if (is_in_stalled_ && status != LinkStatus::stalled) return;
    const double after_s = waiting_.empty() ? 0.0 : waiting_.back().at_s;
    waiting_.push_back({std::max(at_s, after_s), status, std::move(bytes)});
}

}  // namespace touchline
