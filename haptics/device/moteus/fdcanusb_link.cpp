#include "haptics/device/moteus/fdcanusb_link.h"

#include <charconv>
#include <utility>

namespace touchline {
namespace {

constexpr std::string_view bus_on =
    "\ncan on\n";  // the first ends a line that another program left
constexpr std::string_view received = "rcv ";
constexpr std::uint32_t greatest_id = 0x1fffffff;
constexpr int hex = 16;

std::span<const std::uint8_t> bytes_of(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// Takes the first word off.
std::string_view word(std::string_view& text) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view first = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return first;
}

template <class Number>
bool is_hex(std::string_view digits, Number& into) {
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), into, hex);
    return error == std::errc{} && end == digits.data() + digits.size();
}

}  // namespace

FdcanusbLine::FdcanusbLine(const CanFrame& frame) {
    put("can send ");
    put_hex(frame.id, frame.id > 0xffff ? 8 : 4);
    put(" ");
    for (const std::uint8_t byte : frame.bytes()) put_hex(byte, 2);
    put("\n");
}

void FdcanusbLine::put(std::string_view text) {
    for (const char c : text) text_[size_++] = static_cast<std::uint8_t>(c);
}

void FdcanusbLine::put_hex(std::uint32_t value, int digits) {
    constexpr std::string_view digit = "0123456789abcdef";
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4)
        put(digit.substr(value >> static_cast<unsigned>(shift) & 0xfU, 1));
}

std::optional<CanFrame> frame_of(std::string_view line) {
    if (!line.starts_with(received)) return std::nullopt;
    line.remove_prefix(received.size());
    CanFrame frame;
    if (!is_hex(word(line), frame.id) || frame.id > greatest_id) return std::nullopt;
    const std::string_view data = word(line);
    if (data.size() % 2 != 0 || data.size() > 2 * frame.data.size()) return std::nullopt;
    for (std::size_t i = 0; i < data.size(); i += 2) {
        if (!is_hex(data.substr(i, 2), frame.data[frame.size++])) return std::nullopt;
    }
    return frame;
}

FdcanusbLink::FdcanusbLink(std::unique_ptr<ByteLink> port) : port_(std::move(port)) {
    (void)port_->write(bytes_of(bus_on));
}

bool FdcanusbLink::send(const CanFrame& frame) {
    return port_->write(FdcanusbLine(frame).bytes());
}

std::optional<CanFrame> FdcanusbLink::receive() {
    while (true) {
        while (const auto line = lines_.next(unread_)) {
            if (auto frame = frame_of(*line)) return frame;
        }
        unread_ = {read_.data(), port_->read(read_)};
        if (unread_.empty()) return std::nullopt;
    }
}

}  // namespace touchline
