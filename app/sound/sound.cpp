#include "app/sound/sound.h"

#include "audio-cues/cues/cue_sounds.h"
#include "audio-cues/cues/guidance.h"
#include "config/types/steady_clock.h"

#include <array>
#include <limits>
#include <map>
#include <utility>

namespace touchline {
namespace {

double now_s() {
    return 1e-9 * static_cast<double>(steady_now_ns());
}

std::map<std::string, SpokenLanguage> spoken(const Languages& languages) {
    std::map<std::string, SpokenLanguage> all;
    for (const Language& language : languages)
        all[language.code()] = {language.voice(), language.pace()};
    return all;
}

CueArea area_of(const Scene& scene) {
    return {scene.area.width_m / 2.0, scene.area.height_m / 2.0};
}

/// From the proxy to the nearest line as it is felt; 0 on one, infinite where none is near enough
/// to be heard.
double distance_to_line_m(const SoundMoment& moment) {
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
      choice_(first_choice(output_kind(std::nullopt, settings_), settings_)),
      loop_(mixer_, std::move(parts.world), std::move(events)),
      speaker_(std::move(parts.speak_program), spoken(languages_), std::move(parts.prompts),
               mixer_) {
    mixer_.send({0, output_of(profile_of(choice_.output, settings_), choice_.volume)});
}

const Language& Sound::language() const {
    return languages_[choice_.language];
}

void Sound::give(ScreenEvent event) {
    screen_cues_.amount = choice_.amount;
    const CueStep step = cue_step(screen_cues_, event, now_s());
    screen_cues_ = step.state;
    if (step.cue) mixer_.send(sound_of(*step.cue, 0));
}

/// Speech that is off leaves what must be heard.
void Sound::say(const Utterance& utterance) {
    if (choice_.is_speech_on || utterance.priority == SpeechPriority::safety)
        speaker_.say(utterance, now_s());
}

void Sound::apply(const SoundStep& step) {
    const SoundChoice before = std::exchange(choice_, step.choice);
    if (before.output != choice_.output || before.volume != choice_.volume)
        mixer_.send({0, output_of(profile_of(choice_.output, settings_), choice_.volume)});
    speaker_.set_rate(choice_.rate);
    if (step.act == SpeechAct::stop) speaker_.stop(now_s());
    if (step.act == SpeechAct::repeat) speaker_.repeat(now_s());
    if (step.act == SpeechAct::pause) speaker_.toggle_pause();
    if (step.said.empty()) return;
    // That speech goes off is the last that is said.
    if (choice_.is_speech_on || before.is_speech_on)
        speaker_.say({language().code(), step.said, SpeechPriority::text}, now_s());
}

void Sound::key_down(std::optional<Action> action) {
    give(action ? ScreenEvent::key_taken : ScreenEvent::key_refused);
    if (action != Action::pause_speech) speaker_.stop(now_s());
}

void Sound::carry_out(Action action) {
    if (action == Action::headphones_in || action == Action::headphones_out)
        keypad_ = action == Action::headphones_in;
    apply(press_sound_key(choice_, action, settings_, languages_));
}

void Sound::follow_headphones() {
    HeadphoneReports reports = news_.headphones;
    reports[static_cast<std::size_t>(HeadphoneSource::keypad)] = keypad_;
    const OutputKind output = output_kind(are_headphones_in(reports), settings_);
    apply(change_output(choice_, output, settings_, languages_));
}

void Sound::follow_news(const SpokenState& now) {
    if (before_) {
        if (const auto event = screen_event(*before_, now)) give(*event);
        for (const Utterance& utterance : spoken_news(*before_, now, language())) say(utterance);
    }
    before_ = now;
}

void Sound::follow_hand(const SoundMoment& moment) {
    hand_cues_.amount = choice_.amount;
    hand_cues_.clock.told(moment.hand.time_s, steady_now_ns());
    if (moment.scene != nullptr) hand_cues_.area = area_of(*moment.scene);
    loop_.set(hand_cues_);
    const bool is_full = choice_.amount == CueAmount::full && moment.scene != nullptr;
    const ContinuousTone tone =
        is_full ? continuous_tone({choice_.amount, false, std::nullopt}, moment.hand.p_WP,
                                  distance_to_line_m(moment), hand_cues_.area)
                : ContinuousTone{};
    const bool is_on = tone.level > 0.0;
    if (is_on || is_tone_on_) mixer_.send({0, SetContinuous{tone}});
    is_tone_on_ = is_on;
}

void Sound::step(const SoundMoment& moment) {
    news_ = loop_.news();
    follow_headphones();
    follow_news(moment.spoken);
    follow_hand(moment);
    speaker_.step(now_s());
}

std::string Sound::words() const {
    if (!news_.is_working) return news_.problem.empty() ? "starting" : news_.problem;
    static constexpr std::array<std::string_view, 3> amounts{"none", "short ones", "all"};
    const OutputProfile& profile = profile_of(choice_.output, settings_);
    return std::string(amounts[static_cast<std::size_t>(choice_.amount)]) + ", volume " +
           std::to_string(choice_.volume + 1) + " of " + std::to_string(volume_steps(profile)) +
           (choice_.output == OutputKind::headset ? ", headset" : ", speaker") +
           (choice_.is_speech_on ? "" : ", speech off");
}

std::string Sound::problem() const {
    const bool is_silent = !news_.is_working && !news_.problem.empty();
    return is_silent ? language().text("speech", "There is no sound. Please call the staff.") : "";
}

}  // namespace touchline
