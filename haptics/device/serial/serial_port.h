// A serial port of the system as a ByteLink: raw bytes, nobody else's, and no call that waits.
#pragma once

#include "config/types/result.h"
#include "haptics/device/serial/byte_link.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace touchline {

/// Threads: as ByteLink.
class SerialPort final : public ByteLink {
  public:
    /// Takes over an open terminal, which must not block.
    explicit SerialPort(int descriptor) : descriptor_(descriptor) {}

    ~SerialPort() override;

    [[nodiscard]] bool write(std::span<const std::uint8_t> bytes) override;
    [[nodiscard]] std::size_t read(std::span<std::uint8_t> room) override;

    [[nodiscard]] bool is_gone() const override { return is_gone_; }

    void rest(double span_s) override;

  private:
    void send_on();
    [[nodiscard]] std::size_t sent_now(std::span<const std::uint8_t> bytes);

    static constexpr std::size_t most_unsent = 1024;

    int descriptor_;
    bool is_gone_ = false;
    std::array<std::uint8_t, most_unsent> unsent_{};  // what the system did not take at once
    std::size_t unsent_size_ = 0;
};

/// Opens the port at `path`, e.g. /dev/ttyACM0, with eight bits, no parity and 921600 baud, which a
/// port on the USB does not mind, and drops what had come before. Fails in one line if there is no
/// such port, it may not be opened, or another program has it. Waits for a moment.
[[nodiscard]] Result<std::unique_ptr<ByteLink>> open_serial_port(const std::string& path);

}  // namespace touchline
