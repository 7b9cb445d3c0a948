// A CAN bus as one program has it, whatever adapter carries the frames.
#pragma once

#include "config/types/pinned.h"
#include "haptics/device/moteus/moteus_frames.h"

#include <optional>

namespace touchline {

/// Threads: one at a time. No call allocates, locks or logs; only rest() waits.
class FrameLink : public Interface {
  public:
    /// Returns false if there is no room for the frame now, or the adapter is gone.
    [[nodiscard]] virtual bool send(const CanFrame& frame) = 0;

    /// Returns the oldest frame not taken yet; nothing if there is none.
    [[nodiscard]] virtual std::optional<CanFrame> receive() = 0;

    /// True once the adapter was found to be unplugged, for ever.
    [[nodiscard]] virtual bool is_gone() const = 0;

    /// Waits for span_s.
    virtual void rest(double span_s) = 0;
};

}  // namespace touchline
