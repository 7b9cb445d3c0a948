// Where frames go: the one interface of sound, so that tests need no card, and a sound card through
// SDL2.
// Threads: all calls from one; the source is called from the device's.
#pragma once

#include "audio-cues/synth/frames.h"
#include "config/types/pinned.h"
#include "config/types/result.h"

#include <cstdint>
#include <functional>
#include <span>

namespace touchline {

/// Fills all the frames at once.
using FrameSource = std::function<void(std::span<StereoFrame>)>;

class SoundDevice : public Interface {
  public:
    /// The device must be closed before. From here on it asks `source` for frames, a block at a
    /// time. Fails with one line if there is no device or it is in use.
    [[nodiscard]] virtual Result<void> open(FrameSource source) = 0;

    /// Returns once the source is not being asked any more. The device may be closed already.
    virtual void close() = 0;

    /// True if it is open but unplugged, as the system reports.
    [[nodiscard]] virtual bool is_gone() const = 0;
};

/// The environment's SDL_AUDIODRIVER chooses the driver (in tests `dummy` and `disk`). Installs no
/// signal handler and needs no window.
class SdlDevice final : public SoundDevice {
  public:
    ~SdlDevice() override { close(); }

    [[nodiscard]] Result<void> open(FrameSource source) override;
    void close() override;
    [[nodiscard]] bool is_gone() const override;

  private:
    static void fill(void* device, std::uint8_t* bytes, int count);

    FrameSource source_;
    std::uint32_t id_ = 0;  // 0: closed
};

}  // namespace touchline
