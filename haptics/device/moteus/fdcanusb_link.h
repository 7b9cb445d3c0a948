// CAN frames as the lines of text of a fdcanusb adapter: "can send ID DATA" there, "rcv ID DATA
// flags" back, hexadecimal, and "OK" or "ERR why" for each line sent.
#pragma once

#include "haptics/device/moteus/frame_link.h"
#include "haptics/device/serial/byte_link.h"
#include "haptics/device/serial/line_reader.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace touchline {

/// A line with its new line. Threads: a pure function. No allocation.
class FdcanusbLine {
  public:
    explicit FdcanusbLine(const CanFrame& frame);

    [[nodiscard]] std::span<const std::uint8_t> bytes() const { return {text_.data(), size_}; }

  private:
    void put(std::string_view text);
    void put_hex(std::uint32_t value, int digits);

    std::array<std::uint8_t, 160> text_{};
    std::size_t size_ = 0;
};

/// Reads a "rcv" line. Nothing for any other line, and for one that is not whole: an odd number of
/// digits, more than 64 bytes, an id beyond 29 bits.
[[nodiscard]] std::optional<CanFrame> frame_of(std::string_view line);

/// Threads: as FrameLink.
class FdcanusbLink final : public FrameLink {
  public:
    /// Takes the adapter into its "Bus On" state, if it is not in it yet.
    explicit FdcanusbLink(std::unique_ptr<ByteLink> port);

    [[nodiscard]] bool send(const CanFrame& frame) override;
    [[nodiscard]] std::optional<CanFrame> receive() override;

    [[nodiscard]] bool is_gone() const override { return port_->is_gone(); }

    void rest(double span_s) override { port_->rest(span_s); }

  private:
    std::unique_ptr<ByteLink> port_;
    LineReader lines_;
    std::array<std::uint8_t, 512> read_{};
    std::span<const std::uint8_t> unread_;  // of read_
};

}  // namespace touchline
