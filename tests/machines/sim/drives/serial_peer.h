// A device at the other end of a serial line, on the time that the caller passes in, and the line
// itself, with faults. Threads: one at a time.
#pragma once

#include "config/types/pinned.h"
#include "haptics/device/serial/byte_link.h"
#include "tests/machines/sim/board/emulated_link.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace touchline {

/// Bytes and when they left the device.
struct SentBytes {
    double at_s = 0.0;
    std::vector<std::uint8_t> bytes;
};

class SerialPeer : public Interface {
  public:
    /// Runs up to t_s; never goes back.
    virtual void advance_to(double t_s) = 0;

    virtual void take(std::span<const std::uint8_t> bytes) = 0;

    /// Gives what it sends, oldest first; nothing if there is nothing up to now.
    [[nodiscard]] virtual std::optional<SentBytes> leave() = 0;
};

/// What goes wrong on the line.
enum class LineFault : std::uint8_t {
    none,
    lost_write,     // the next write never gets there
    cut_write,      // only its first half does
    garbled_write,  // some of its bits flip
    full,           // the system takes nothing for a while
    late_reply,     // what comes back is held up for a while
    lost_reply,     // what comes back for a while is lost
    garbled_reply,  // some of its bits flip
    cut_reply,      // only the first half of the next piece comes
    unplugged
};

class EmulatedSerial final : public ByteLink {
  public:
    /// Both must outlive it.
    EmulatedSerial(SerialPeer& peer, VirtualTime& time) : peer_(peer), time_(time) {}

    [[nodiscard]] bool write(std::span<const std::uint8_t> bytes) override;
    [[nodiscard]] std::size_t read(std::span<std::uint8_t> room) override;

    [[nodiscard]] bool is_gone() const override { return is_gone_; }

    void rest(double span_s) override { time_.now_s += span_s; }

    /// From now on, for span_s if the fault lasts.
    void spoil(LineFault fault, double span_s = 0.0, std::uint64_t seed = 1);

    /// The same from the write with this number on, counted from 0.
    void spoil_write(std::size_t at, LineFault fault, double span_s = 0.0, std::uint64_t seed = 1) {
        planned_ = Planned{at, fault, span_s, seed};
    }

    /// For span_s, all that comes back comes this much later.
    void slow(double late_s, double span_s) {
        slow_s_ = late_s;
        slow_until_s_ = time_.now_s + span_s;
    }

    /// All that was written, as lines.
    [[nodiscard]] const std::vector<std::uint8_t>& written() const { return written_; }

  private:
    struct Planned {
        std::size_t at = 0;
        LineFault fault = LineFault::none;
        double span_s = 0.0;
        std::uint64_t seed = 1;
    };

    [[nodiscard]] bool is_spoilt(LineFault fault) const {
        return fault_ == fault && time_.now_s <= until_s_;
    }

    [[nodiscard]] bool takes_fault(LineFault fault);
    void listen();

    SerialPeer& peer_;
    VirtualTime& time_;
    bool is_gone_ = false;
    LineFault fault_ = LineFault::none;
    double until_s_ = 0.0;
    std::uint64_t seed_ = 1;
    double slow_s_ = 0.0, slow_until_s_ = 0.0;
    std::optional<Planned> planned_;
    std::size_t writes_ = 0;
    std::deque<SentBytes> coming_;
    std::vector<std::uint8_t> written_;
};

}  // namespace touchline
