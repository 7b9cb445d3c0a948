// Where frames go: the one interface of sound, so that tests need no card.
// Threads: all calls from one; the source is called from the device's.
#pragma once

#include "audio-cues/synth/frames.h"
#include "config/types/result.h"

#include <functional>
#include <span>

namespace touchline {

/// Fills the frames, all of them, at once.
using FrameSource = std::function<void(std::span<StereoFrame>)>;

class SoundDevice {
  public:
    virtual ~SoundDevice() = default;
    SoundDevice() = default;
    SoundDevice(const SoundDevice&) = delete;
    SoundDevice(SoundDevice&&) = delete;
    SoundDevice& operator=(const SoundDevice&) = delete;
    SoundDevice& operator=(SoundDevice&&) = delete;

    /// Closed before. From here on the device asks `source`, a block at a time. One line where
    /// there is none, or it is in use.
    [[nodiscard]] virtual Result<void> open(FrameSource source) = 0;

    /// Returns once the source is not being asked any more. May be closed already.
    virtual void close() = 0;

    /// Open, but unplugged: the system said so.
    [[nodiscard]] virtual bool is_gone() const = 0;
};

}  // namespace touchline
