#include "app/process/places.h"
#include "app/sound/catalogues.h"
#include "app/sound/headphone_switch.h"
#include "app/sound/sound.h"
#include "audio-cues/output/jack_control.h"
#include "audio-cues/output/sdl_device.h"

namespace touchline {

SoundParts sound_parts() {
    SoundParts parts;
    parts.world = {std::make_unique<SdlDevice>(), std::make_unique<HeadphoneSwitch>(),
                   std::make_unique<JackControl>()};
    parts.settings = read_sound_settings(sound_file(), parts.problems);
    parts.languages = read_languages(words_folder(), parts.problems);
    parts.prompts = RecordedPrompts::read(prompts_folder().string(), parts.problems);
    parts.speak_program = companion("touchline-speak");
    return parts;
}

}  // namespace touchline
