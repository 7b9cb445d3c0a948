// What a visitor chose to hear, and what the keys for it do: a pure step.
// Threads: values and pure functions.
#pragma once

#include "app/session/keys.h"
#include "audio-cues/cues/cue.h"
#include "audio-cues/output/headphones.h"
#include "audio-cues/output/profile.h"
#include "audio-cues/speech/speech_rate.h"
#include "audio-cues/words/language.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace touchline {

/// English first; the others by their catalogues.
using Languages = std::vector<Language>;

struct SoundChoice {
    CueAmount amount = CueAmount::cues;
    bool is_speech_on = true;
    std::size_t rate = default_speech_rate;
    std::size_t language = 0;  // in Languages
    OutputKind output = OutputKind::headset;
    std::size_t volume = 0;  // a step of the output's profile

    friend bool operator==(const SoundChoice&, const SoundChoice&) = default;
};

/// What every session begins with: VO-2.
[[nodiscard]] SoundChoice first_choice(OutputKind output, const SoundSettings& settings);

enum class SpeechAct : std::uint8_t { none, stop, repeat, pause };

struct SoundStep {
    SoundChoice choice;
    std::string said;  // in the chosen language; empty: nothing
    SpeechAct act = SpeechAct::none;
};

/// A key for sound or speech; any other action changes nothing. `languages` is not empty.
[[nodiscard]] SoundStep press_sound_key(const SoundChoice& choice, Action action,
                                        const SoundSettings& settings, const Languages& languages);

/// Another output is heard from now on: its own volume to begin with, and the visitor is told.
/// Whoever was listening in private must not be heard aloud: what was being said stops.
[[nodiscard]] SoundStep change_output(const SoundChoice& choice, OutputKind output,
                                      const SoundSettings& settings, const Languages& languages);

}  // namespace touchline
