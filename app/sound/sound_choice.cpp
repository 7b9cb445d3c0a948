#include "app/sound/sound_choice.h"

#include "audio-cues/words/guidance_words.h"

#include <algorithm>

namespace touchline {
namespace {

/// "{text}" with the step and how many there are, both counted from 1.
std::string step_words(const Language& language, const char* text, std::size_t step,
                       std::size_t count) {
    return language.text("speech", text, {std::to_string(step + 1), std::to_string(count)});
}

SoundStep change_volume(SoundChoice choice, int change, const OutputProfile& profile,
                        const Language& language) {
    const VolumeChange changed = change_volume(profile, choice.volume, change);
    choice.volume = changed.step;
    if (changed.is_at_end) {
        return {choice, language.text("speech", change > 0 ? "This is the loudest."
                                                           : "This is the softest.")};
    }
    return {choice,
            step_words(language, "Volume {0} of {1}", choice.volume, volume_steps(profile))};
}

SoundStep change_rate(SoundChoice choice, int change, const Language& language) {
    const int last = static_cast<int>(speech_rates_per_minute.size()) - 1;
    const int wanted = static_cast<int>(choice.rate) + change;
    if (wanted < 0) return {choice, language.text("speech", "This is the slowest.")};
    if (wanted > last) return {choice, language.text("speech", "This is the fastest.")};
    choice.rate = static_cast<std::size_t>(wanted);
    return {choice, step_words(language, "Speech rate {0} of {1}", choice.rate,
                               speech_rates_per_minute.size())};
}

SoundStep next_sounds(SoundChoice choice, const Language& language) {
    choice.amount = next_amount(choice.amount);
    return {choice, words_of(choice.amount, language)};
}

/// Said while it still is on, or on again.
SoundStep toggle_speech(SoundChoice choice, const Language& language) {
    choice.is_speech_on = !choice.is_speech_on;
    return {choice,
            language.text("speech", choice.is_speech_on ? "Speech is on." : "Speech is off.")};
}

/// Each language is named in itself, by its own voice.
SoundStep next_language(SoundChoice choice, const Languages& languages) {
    choice.language = (choice.language + 1) % languages.size();
    return {choice, languages[choice.language].name()};
}

}  // namespace

SoundChoice first_choice(OutputKind output, const SoundSettings& settings) {
    SoundChoice choice;
    choice.output = output;
    choice.volume = default_volume(profile_of(output, settings));
    return choice;
}

SoundStep press_sound_key(const SoundChoice& choice, Action action, const SoundSettings& settings,
                          const Languages& languages) {
    const Language& language = languages[std::min(choice.language, languages.size() - 1)];
    const OutputProfile& profile = profile_of(choice.output, settings);
    switch (action) {
        case Action::next_sounds:
            return next_sounds(choice, language);
        case Action::toggle_speech:
            return toggle_speech(choice, language);
        case Action::repeat_speech:
            return {choice, {}, SpeechAct::repeat};
        case Action::stop_speech:
            return {choice, {}, SpeechAct::stop};
        case Action::pause_speech:
            return {choice, {}, SpeechAct::pause};
        case Action::slower_speech:
            return change_rate(choice, -1, language);
        case Action::faster_speech:
            return change_rate(choice, +1, language);
        case Action::softer_sound:
            return change_volume(choice, -1, profile, language);
        case Action::louder_sound:
            return change_volume(choice, +1, profile, language);
        case Action::next_language:
            return next_language(choice, languages);
        default:
            return {choice, {}};
    }
}

SoundStep change_output(const SoundChoice& choice, OutputKind output, const SoundSettings& settings,
                        const Languages& languages) {
    if (output == choice.output) return {choice, {}};
    SoundStep step{choice, {}, SpeechAct::stop};
    step.choice.output = output;
    step.choice.volume = default_volume(profile_of(output, settings));
    const Language& language = languages[std::min(choice.language, languages.size() - 1)];
    step.said = language.text("speech", output == OutputKind::headset ? "The headphones are in."
                                                                      : "The headphones are out.");
    return step;
}

}  // namespace touchline
