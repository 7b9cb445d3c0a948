#include "audio-cues/output/sound_output.h"

#include <utility>

#define SDL_MAIN_HANDLED
#include <SDL2/SDL.h>
#include <alsa/asoundlib.h>

namespace touchline {
namespace {

/// ALSA prints a page for every missing card; SDL reports what matters.
void say_nothing(const char*, int, const char*, int, const char*, ...) {}

/// SDL's errors also tell what SDL prints.
void log_nothing(void*, int, SDL_LogPriority, const char*) {}

}  // namespace

void SdlDevice::fill(void* device, std::uint8_t* bytes, int count) {
    static_assert(sizeof(StereoFrame) == 2 * sizeof(float));
    auto* frames = reinterpret_cast<StereoFrame*>(bytes);
    static_cast<SdlDevice*>(device)->source_(
        {frames, static_cast<std::size_t>(count) / sizeof(StereoFrame)});
}

Result<void> SdlDevice::open(FrameSource source, int block) {
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    snd_lib_error_set_handler(&say_nothing);
    SDL_LogSetOutputFunction(&log_nothing, nullptr);
    // Initialized anew each time, so that it looks for a driver that came back.
    if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) {
        return failure(std::string("There is no sound: ") + SDL_GetError());
    }
    source_ = std::move(source);
    SDL_AudioSpec wanted{};
    wanted.freq = frame_rate_Hz;
    wanted.format = AUDIO_F32SYS;
    wanted.channels = 2;
    wanted.samples = static_cast<Uint16>(block);
    wanted.callback = &SdlDevice::fill;
    wanted.userdata = this;
    SDL_AudioSpec got{};
    id_ = SDL_OpenAudioDevice(nullptr, 0, &wanted, &got, 0);
    if (id_ == 0) {
        auto failed = failure(std::string("The sound device cannot be opened: ") + SDL_GetError());
        SDL_QuitSubSystem(SDL_INIT_AUDIO);
        return failed;
    }
    SDL_PauseAudioDevice(id_, 0);
    return {};
}

void SdlDevice::close() {
    if (id_ == 0) return;
    SDL_CloseAudioDevice(id_);
    id_ = 0;
    SDL_QuitSubSystem(SDL_INIT_AUDIO);
}

bool SdlDevice::is_gone() const {
    return id_ != 0 && SDL_GetAudioDeviceStatus(id_) == SDL_AUDIO_STOPPED;
}

}  // namespace touchline
