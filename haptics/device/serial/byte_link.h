// Bytes to and from a device, whatever carries them: a serial port, or an emulated one. It knows
// nothing of what the bytes mean.
#pragma once

#include "config/types/pinned.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace touchline {

/// Threads: one at a time. No call allocates, locks or logs; only rest() waits. The destructor
/// gives the device back.
class ByteLink : public Interface {
  public:
    /// Takes all of the bytes, at most 1024, or none. Returns false if there is no room for them
    /// now or the device is gone.
    [[nodiscard]] virtual bool write(std::span<const std::uint8_t> bytes) = 0;

    /// Puts the bytes that have come at the front of `room`, and returns how many; 0: none yet.
    [[nodiscard]] virtual std::size_t read(std::span<std::uint8_t> room) = 0;

    /// True once the device was found to be unplugged, for ever.
    [[nodiscard]] virtual bool is_gone() const = 0;

    /// Waits for span_s.
    virtual void rest(double span_s) = 0;
};

}  // namespace touchline
