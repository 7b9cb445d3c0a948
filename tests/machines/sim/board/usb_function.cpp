#include "tests/machines/sim/board/usb_function.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <string_view>
#include <utility>

namespace touchline {
namespace {

constexpr std::uint8_t standard_in = 0x80, standard_in_interface = 0x81, standard_out = 0x00;
constexpr std::uint8_t class_out = 0x21, class_in = 0xa1;
constexpr std::uint8_t get_descriptor = 6, set_line_coding = 0x20, get_line_coding = 0x21,
                       set_control_lines = 0x22, send_break = 0x23;

std::uint16_t word(std::span<const std::uint8_t> bytes, std::size_t at) {
    return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8);
}

std::uint8_t low(std::uint16_t word) {
    return static_cast<std::uint8_t>(word & 0xff);
}

std::uint8_t high(std::uint16_t word) {
    return static_cast<std::uint8_t>(word >> 8);
}

PacketBytes string_descriptor(std::string_view text) {
    PacketBytes bytes{static_cast<std::uint8_t>(2 + 2 * text.size()), 3};
    for (const char c : text) {
        bytes.push_back(static_cast<std::uint8_t>(c));
        bytes.push_back(0);
    }
    return bytes;
}

std::optional<PacketBytes> descriptor(const BoardEmulator& board, std::uint16_t value) {
    const bool is_due = board.truth().type == BoardType::due;
    switch (value) {
        case 0x0100:
            return device_descriptor(board);
        case 0x0200:
            return configuration_descriptor(board);
        case 0x0300:
            return PacketBytes{4, 3, 0x09, 0x04};  // American English
        case 0x0301:
            return string_descriptor("Arduino LLC");
        case 0x0302:
            return string_descriptor(is_due ? "Arduino Due" : "Arduino Zero");
        case 0x0303:
            return string_descriptor(board.truth().serial);
        default:
            return std::nullopt;
    }
}

std::optional<PacketBytes> answer_class(BoardEmulator& board, const UsbRequest& request,
                                        std::span<const std::uint8_t> data) {
    if (request.type == class_in && request.request == get_line_coding)
        return PacketBytes{0x00, 0xc2, 0x01, 0x00, 0x00, 0x00, 0x08};
    if (request.type != class_out || board.is_boot_loader()) return std::nullopt;
    switch (request.request) {
        case set_line_coding:
            if (data.size() != 7) return std::nullopt;
            board.set_line_coding(word(data, 0) | static_cast<std::uint32_t>(word(data, 2)) << 16);
            return PacketBytes{};
        case set_control_lines:
            board.set_lines((request.value & 1) != 0, (request.value & 2) != 0);
            return PacketBytes{};
        case send_break:
            return PacketBytes{};
        default:
            return std::nullopt;
    }
}

constexpr std::size_t set_up_bytes = 8;
constexpr std::size_t short_bytes = 4;

bool take_one(int& left) {
    if (left <= 0) return false;
    --left;
    return true;
}

}  // namespace

UsbRequest request_of(std::span<const std::uint8_t> bytes) {
    return {bytes[0], bytes[1], word(bytes, 2), word(bytes, 4), word(bytes, 6)};
}

PacketBytes device_descriptor(const BoardEmulator& board) {
    const bool is_sam_ba = board.is_boot_loader() && board.truth().type == BoardType::due;
    const std::uint16_t vendor = is_sam_ba ? 0x03eb : 0x2341;
    return {0x12,
            0x01,
            0x00,
            0x02,
            0xef,
            0x02,
            0x01,
            0x40,
            low(vendor),
            high(vendor),
            low(board.product()),
            high(board.product()),
            0x00,
            0x01,
            0x01,
            0x02,
            0x03,
            0x01};
}

PacketBytes configuration_descriptor(const BoardEmulator& board) {
    const std::uint8_t iad_protocol = board.truth().type == BoardType::due ? 1 : 0;
    return {0x09,         0x02, 0x4b,
            0x00,         0x02, 0x01,
            0x00,         0xa0, 0xfa,  // 75 bytes in all
            0x08,         0x0b, 0x00,
            0x02,         0x02, 0x02,
            iad_protocol, 0x00,  // groups two interfaces
            0x09,         0x04, 0x00,
            0x00,         0x01, 0x02,
            0x02,         0x00, 0x00,  // CDC control, ACM
            0x05,         0x24, 0x00,
            0x10,         0x01, 0x04,
            0x24,         0x02, 0x06,  // header, ACM
            0x05,         0x24, 0x06,
            0x00,         0x01, 0x05,
            0x24,         0x01, 0x01,
            0x01,  // union, call management
            0x07,         0x05, 0x81,
            0x03,         0x10, 0x00,
            0x10,  // interrupt IN
            0x09,         0x04, 0x01,
            0x00,         0x02, 0x0a,
            0x00,         0x00, 0x00,  // CDC data
            0x07,         0x05, board_out_endpoint,
            0x02,         0x40, 0x00,
            0x00,  // bulk OUT, 64 bytes
            0x07,         0x05, board_in_endpoint,
            0x02,         0x40, 0x00,
            0x00};  // bulk IN, 64 bytes
}

std::optional<PacketBytes> answer(BoardEmulator& board, const UsbRequest& request,
                                  std::span<const std::uint8_t> data) {
    std::optional<PacketBytes> bytes;
    if (request.type == standard_in && request.request == get_descriptor) {
        bytes = descriptor(board, request.value);
    } else if ((request.type & 0x60) == 0x20) {
        bytes = answer_class(board, request, data);
    } else if (request.type <= 2 + standard_out) {
        bytes = PacketBytes{};  // set address, configuration, interface; clear a halt
    } else if (request.type == standard_in || request.type == standard_in_interface) {
        bytes = PacketBytes{1, 0};
    }
    if (bytes && bytes->size() > request.length) bytes->resize(request.length);
    return bytes;
}

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
