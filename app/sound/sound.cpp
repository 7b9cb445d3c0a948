#include "app/sound/sound.h"

#include "app/isolation/process/places.h"
#include "app/sound/headphone_switch.h"
#include "audio-cues/cues/guidance.h"
#include "audio-cues/output/sound_output.h"
#include "audio-cues/synth/voices.h"
#include "config/types/steady_clock.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace touchline {
namespace {

constexpr double side_Hz = 880.0;  // of the tone on one ear
constexpr double side_s = 0.2;

double now_s() {
    return 1e-9 * static_cast<double>(steady_now_ns());
}

std::map<std::string, SpokenLanguage> spoken(const Languages& languages) {
    std::map<std::string, SpokenLanguage> all;
    for (const Language& language : languages)
        all[language.code()] = {language.voice(), language.pace(),
                                respellings_of(language.respelling())};
    return all;
}

CueArea area_of(const Scene& scene) {
    return {scene.area.width_m / 2.0, scene.area.height_m / 2.0};
}

/// From the proxy to the nearest line as it is felt; 0 on a line, infinite if none is near enough
/// to be heard.
double distance_to_line_m(const HandMoment& moment) {
    if (moment.hand.state != ContactState::free) return 0.0;
    const Scene& scene = *moment.scene;
    const Closest closest =
        scene.tree.closest_point(scene.curves, moment.hand.p_WP, moment.hand.level, far_m);
    return closest.segment.piece < 0 ? std::numeric_limits<double>::infinity() : closest.distance_m;
}

}  // namespace

Sound::Sound(SoundParts parts, EventSource events)
    : settings_(parts.settings),
      languages_(std::move(parts.languages)),
      output_(output_kind(std::nullopt, settings_)),
      loop_(mixer_, std::move(parts.world), std::move(events)),
      speaker_(std::move(parts.speak_program), spoken(languages_), std::move(parts.prompts),
               mixer_) {
    wanted_.volume = default_volume(profile_of(output_, settings_));
    send_output();
}

void Sound::send_output() {
    const OutputProfile& profile = profile_of(output_, settings_);
    const std::size_t step = std::min(wanted_.volume, volume_steps(profile) - 1);
    SetOutput output = output_of(profile, step);
    output.gain *= std::pow(10.0, -lower_dB_ / 20.0);
    output.is_mono = output.is_mono || wanted_.is_mono;
    mixer_.send({0, output});
}

void Sound::give(ScreenEvent event) {
    screen_cues_.amount = wanted_.amount;
    const CueStep step = cue_step(screen_cues_, event, now_s());
    screen_cues_ = step.state;
    if (step.cue) mixer_.send(sound_of(*step.cue, 0));
}

/// With speech off, only what must be heard is said.
void Sound::say(const Utterance& utterance) {
    if (wanted_.is_speech_on || utterance.priority == SpeechPriority::safety)
        speaker_.say(utterance, now_s());
}

void Sound::hush() {
    speaker_.stop(now_s());
}

void Sound::toggle_pause() {
    speaker_.toggle_pause();
}

void Sound::play_side(bool is_left) {
    Earcon tone;
    tone.notes[0] = {side_Hz, side_Hz, side_s, 1.0, 0.0, Timbre::pure};
    tone.note_count = 1;
    mixer_.send({0, PlayEarcon{tone, 1.0, is_left ? -1.0 : 1.0, true}});
}

void Sound::choose(const SoundWanted& wanted) {
    wanted_ = wanted;
    speaker_.set_rate(wanted.rate);
    send_output();
}

void Sound::set_levels(const SoundSettings& levels, double lower_dB) {
    settings_ = levels;
    lower_dB_ = lower_dB;
    send_output();
}

HeardOutput Sound::output() const {
    const OutputProfile& profile = profile_of(output_, settings_);
    return {output_, volume_steps(profile), default_volume(profile)};
}

std::optional<bool> Sound::are_headphones_in() const {
    HeadphoneReports reports = news_.headphones;
    reports[static_cast<std::size_t>(HeadphoneSource::keypad)] = keypad_;
    return touchline::are_headphones_in(reports);
}

void Sound::follow_headphones() {
    const OutputKind output = output_kind(are_headphones_in(), settings_);
    if (output == std::exchange(output_, output)) return;
    wanted_.volume = default_volume(profile_of(output_, settings_));
    send_output();
}

void Sound::follow_hand(const HandMoment& moment) {
    hand_cues_.amount = wanted_.amount;
    hand_cues_.clock.told(moment.hand.time_s, steady_now_ns());
    if (moment.scene != nullptr) hand_cues_.area = area_of(*moment.scene);
    hand_cues_.is_nobody_here = moment.is_nobody_here;
    loop_.set(hand_cues_);
    const bool is_wanted =
        moment.scene != nullptr && (wanted_.amount == CueAmount::full || moment.target ||
                                    moment.hand.shape != HeldShape::none);
    const ContinuousChoice choice{wanted_.amount, false, moment.target, moment.hand.torque_Nm};
    const ContinuousTone tone =
        is_wanted
            ? continuous_tone(choice, moment.hand.p_WP, distance_to_line_m(moment), hand_cues_.area)
            : ContinuousTone{};
    const bool is_on = tone.level > 0.0;
    if (is_on || is_tone_on_) mixer_.send({0, SetContinuous{tone}});
    is_tone_on_ = is_on;
}

void Sound::step(const HandMoment& moment) {
    news_ = loop_.news();
    follow_headphones();
    follow_hand(moment);
    speaker_.step(now_s());
}

std::string Sound::problem() const {
    const bool is_silent = !news_.is_working && !news_.problem.empty();
    return is_silent ? languages_[std::min(wanted_.language, languages_.size() - 1)].text(
                           "speech", "There is no sound. Please call the staff.")
                     : "";
}

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
