// Where frames go: the one interface of sound, so that tests need no card.
// Threads: all calls from one; the source is called from the device's.
#pragma once

#include "audio-cues/synth/frames.h"
#include "config/types/result.h"

#include <functional>
#include <span>

namespace touchline {

/// Fills all the frames at once.
using FrameSource = std::function<void(std::span<StereoFrame>)>;

class SoundDevice {
  public:
    virtual ~SoundDevice() = default;
    SoundDevice() = default;
    SoundDevice(const SoundDevice&) = delete;
    SoundDevice(SoundDevice&&) = delete;
    SoundDevice& operator=(const SoundDevice&) = delete;
    SoundDevice& operator=(SoundDevice&&) = delete;

    /// The device must be closed before. From here on it asks `source` for frames, a block at a
    /// time. Fails with one line if there is no device or it is in use.
    [[nodiscard]] virtual Result<void> open(FrameSource source) = 0;

    /// Returns once the source is not being asked any more. The device may be closed already.
    virtual void close() = 0;

    /// True if it is open but unplugged, as the system reports.
    [[nodiscard]] virtual bool is_gone() const = 0;
};

}  // namespace touchline
