// A sound card by SDL2: PipeWire, PulseAudio or ALSA, whichever there is. Threads: sound_device.h.
#pragma once

#include "audio-cues/output/sound_device.h"

#include <cstdint>

namespace touchline {

/// SDL_AUDIODRIVER of the environment chooses the driver (in tests `dummy` and `disk`). No signal
/// handler is installed, and no window is needed.
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
