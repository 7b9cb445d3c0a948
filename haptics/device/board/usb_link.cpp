#include "haptics/device/board/usb_link.h"

#include "config/types/steady_clock.h"

#include <algorithm>
#include <utility>

#include <sys/time.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr unsigned control_time_out_ms = 200;
constexpr double longest_close_s = 1.0;
constexpr std::uint8_t to_interface = 0x21;  // host to device, class, interface
constexpr std::uint8_t set_line_coding = 0x20, set_control_lines = 0x22;
constexpr std::uint16_t both_lines = 0x0003;  // DTR and RTS

LinkStatus status_of(libusb_transfer_status status) {
    switch (status) {
        case LIBUSB_TRANSFER_COMPLETED:
            return LinkStatus::done;
        case LIBUSB_TRANSFER_TIMED_OUT:
        case LIBUSB_TRANSFER_CANCELLED:
            return LinkStatus::timed_out;
        case LIBUSB_TRANSFER_STALL:
            return LinkStatus::stalled;
        case LIBUSB_TRANSFER_NO_DEVICE:
            return LinkStatus::gone;
        default:
            return LinkStatus::failed;
    }
}

LinkStatus status_of(int error) {
    switch (error) {
        case LIBUSB_ERROR_NO_DEVICE:
            return LinkStatus::gone;
        case LIBUSB_ERROR_TIMEOUT:
            return LinkStatus::timed_out;
        case LIBUSB_ERROR_PIPE:
            return LinkStatus::stalled;
        default:
            return error < 0 ? LinkStatus::failed : LinkStatus::done;
    }
}

}  // namespace

StallClearer::StallClearer(libusb_device_handle* handle, std::array<std::uint8_t, 2> endpoints)
    : handle_(handle), endpoints_(endpoints), thread_([this] { clear_when_asked(); }) {}

StallClearer::~StallClearer() {
    is_closing_ = true;
    asked_.release();
    thread_.join();
}

std::optional<int> StallClearer::step() {
    if (work_ == Work::ended) {
        work_ = Work::none;
        return error_;
    }
    if (work_ == Work::none) {
        work_ = Work::wanted;
        asked_.release();
    }
    return std::nullopt;
}

void StallClearer::clear_when_asked() {
    for (;;) {
        asked_.acquire();
        if (is_closing_) return;
        int error = 0;  // the first error
        for (const std::uint8_t endpoint : endpoints_)
            if (error == 0) error = libusb_clear_halt(handle_, endpoint);
        error_ = error;
        work_ = Work::ended;
    }
}

UsbLink::UsbLink(std::shared_ptr<libusb_context> context, libusb_device_handle* handle, int node,
                 const SerialPipes& pipes, unsigned send_time_out_ms)
    : context_(std::move(context)),
      handle_(handle),
      node_(node),
      pipes_(pipes),
      send_time_out_ms_(send_time_out_ms),
      out_(libusb_alloc_transfer(0)),
      stall_clearer_(std::in_place, handle, std::array{pipes.out_endpoint, pipes.in_endpoint}) {
    for (InTransfer& in : in_) {
        in.transfer = libusb_alloc_transfer(0);
        libusb_fill_bulk_transfer(in.transfer, handle_, pipes_.in_endpoint, in.buffer.data(),
                                  static_cast<int>(in.buffer.size()), on_in, this, 0);
        listen(in);
    }
}

UsbLink::~UsbLink() {
    stall_clearer_.reset();
    (void)set_lines(false);
    is_closing_ = true;
    cancel_all();
    const std::int64_t end_ns = steady_now_ns() + static_cast<std::int64_t>(1e9 * longest_close_s);
    while (is_anything_under_way() && steady_now_ns() < end_ns) handle_events(0.01);
    // The system may still write to a transfer that it never gave back, so leak it rather than free
    // it.
    if (!is_sending_) libusb_free_transfer(out_);
    for (InTransfer& in : in_)
        if (!in.is_under_way) libusb_free_transfer(in.transfer);
    libusb_release_interface(handle_, pipes_.data_interface);
    libusb_release_interface(handle_, pipes_.control_interface);
    libusb_close(handle_);
    ::close(node_);
}

LinkStatus UsbLink::send(std::span<const std::uint8_t> command) {
    handle_events(0.0);
    if (is_gone_) return LinkStatus::gone;
    if (is_sending_) return LinkStatus::under_way;
    const std::size_t size = std::min(command.size(), out_buffer_.size());
    std::copy_n(command.begin(), size, out_buffer_.begin());
    libusb_fill_bulk_transfer(out_, handle_, pipes_.out_endpoint, out_buffer_.data(),
                              static_cast<int>(size), on_out, this, send_time_out_ms_);
    const LinkStatus status = status_of(libusb_submit_transfer(out_));
    is_sending_ = status == LinkStatus::done;
    is_gone_ = is_gone_ || status == LinkStatus::gone;
    return status;
}

Sent UsbLink::sent() {
    handle_events(0.0);
    if (is_sending_) return {LinkStatus::under_way, 0};
    return is_gone_ ? Sent{LinkStatus::gone, 0} : sent_;
}

Received UsbLink::receive() {
    handle_events(0.0);
    if (waiting_count_ == 0) return {is_gone_ ? LinkStatus::gone : LinkStatus::under_way, {}, 0};
    const Received received = waiting_[first_waiting_];
    first_waiting_ = (first_waiting_ + 1) % waiting_.size();
    --waiting_count_;
    return received;
}

LinkStatus UsbLink::set_lines(bool are_high) {
    // 115200 baud, one stop bit, no parity, eight bits.
    std::array<std::uint8_t, 7> coding{0x00, 0xc2, 0x01, 0x00, 0x00, 0x00, 0x08};
    const auto index = static_cast<std::uint16_t>(pipes_.control_interface);
    int result = libusb_control_transfer(handle_, to_interface, set_line_coding, 0, index,
                                         coding.data(), coding.size(), control_time_out_ms);
    if (result >= 0)
        result = libusb_control_transfer(handle_, to_interface, set_control_lines,
                                         are_high ? both_lines : 0, index, nullptr, 0,
                                         control_time_out_ms);
    is_gone_ = is_gone_ || result == LIBUSB_ERROR_NO_DEVICE;
    return status_of(result);
}

LinkStatus UsbLink::clear_stall() {
    const std::optional<int> error = stall_clearer_->step();
    if (!error) return LinkStatus::under_way;
    is_gone_ = is_gone_ || *error == LIBUSB_ERROR_NO_DEVICE;
    for (InTransfer& transfer : in_)
        if (!transfer.is_under_way) listen(transfer);
    return status_of(*error);
}

void UsbLink::cancel_send() {
    if (is_sending_) libusb_cancel_transfer(out_);
}

void UsbLink::rest(double span_s) {
    const std::int64_t end_ns = steady_now_ns() + static_cast<std::int64_t>(1e9 * span_s);
    for (std::int64_t left_ns = end_ns - steady_now_ns(); left_ns > 0;
         left_ns = end_ns - steady_now_ns())
        handle_events(1e-9 * static_cast<double>(left_ns));
}

void UsbLink::on_out(libusb_transfer* transfer) {
    auto& link = *static_cast<UsbLink*>(transfer->user_data);
    link.is_sending_ = false;
    link.sent_ = {status_of(transfer->status), static_cast<std::size_t>(transfer->actual_length)};
    link.is_gone_ = link.is_gone_ || transfer->status == LIBUSB_TRANSFER_NO_DEVICE;
}

void UsbLink::on_in(libusb_transfer* transfer) {
    auto& link = *static_cast<UsbLink*>(transfer->user_data);
    for (InTransfer& in : link.in_)
        if (in.transfer == transfer) link.end_in(in);
}

void UsbLink::end_in(InTransfer& in) {
    in.is_under_way = false;
    if (is_closing_ || in.transfer->status == LIBUSB_TRANSFER_CANCELLED) return;
    Received received;
    received.status = status_of(in.transfer->status);
    received.size =
        std::min(static_cast<std::size_t>(in.transfer->actual_length), received.data.size());
    std::copy_n(in.buffer.begin(), received.size, received.data.begin());
    is_gone_ = is_gone_ || received.status == LinkStatus::gone;
    if (is_gone_) return;
    keep(received);
    // A halted endpoint would halt the next one too: clear_stall() listens again.
    if (received.status != LinkStatus::stalled) listen(in);
}

void UsbLink::listen(InTransfer& in) {
    const int error = libusb_submit_transfer(in.transfer);
    in.is_under_way = error == 0;
    is_gone_ = is_gone_ || error == LIBUSB_ERROR_NO_DEVICE;
}

// A program that talks to a board never leaves this many unread; the oldest is dropped.
void UsbLink::keep(const Received& received) {
    if (waiting_count_ == waiting_.size()) {
        first_waiting_ = (first_waiting_ + 1) % waiting_.size();
        --waiting_count_;
    }
    waiting_[(first_waiting_ + waiting_count_++) % waiting_.size()] = received;
}

void UsbLink::handle_events(double longest_s) {
    const auto microseconds = static_cast<std::int64_t>(1e6 * longest_s);
    timeval span{microseconds / 1000000, microseconds % 1000000};
    libusb_handle_events_timeout_completed(context_.get(), &span, nullptr);
}

bool UsbLink::is_anything_under_way() const {
    return is_sending_ || std::ranges::any_of(in_, &InTransfer::is_under_way);
}

void UsbLink::cancel_all() {
    if (is_sending_) libusb_cancel_transfer(out_);
    for (InTransfer& in : in_)
        if (in.is_under_way) libusb_cancel_transfer(in.transfer);
}

}  // namespace touchline
