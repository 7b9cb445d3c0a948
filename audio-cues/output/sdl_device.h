// A sound card through SDL2: PipeWire, PulseAudio or ALSA, whichever exists. Threads:
// sound_device.h.
#pragma once

#include "audio-cues/output/sound_device.h"

#include <cstdint>

namespace touchline {

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
