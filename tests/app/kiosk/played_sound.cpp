#include "tests/app/kiosk/played_sound.h"

#include "app/isolation/process/places.h"
#include "tests/audio-cues/spectrum.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <poll.h>

namespace touchline {
namespace {

std::map<std::string, SpokenLanguage> spoken_languages() {
    std::map<std::string, SpokenLanguage> spoken;
    for (const Language& language : all_languages())
        spoken[language.code()] = {language.voice(), language.pace(), {}};
    return spoken;
}

}  // namespace

PlayedSound::PlayedSound(std::shared_ptr<Heard> heard, std::shared_ptr<Played> played)
    : heard_(std::move(heard)),
      played_(std::move(played)),
      told_(heard_),
      speaker_(companion("touchline-speak"), spoken_languages(), {}, mixer_) {}

void PlayedSound::say(const Utterance& utterance) {
    told_.say(utterance);
    played_->said_at.push_back(played_->left.size());
    speaker_.say(utterance, heard_->now_s);
}

void PlayedSound::hush() {
    told_.hush();
    played_->hushed_at.push_back(played_->left.size());
    speaker_.stop(heard_->now_s);
}

void PlayedSound::choose(const SoundWanted& wanted) {
    told_.choose(wanted);
    speaker_.set_rate(wanted.rate);
    const SetOutput output = output_of(settings_.headset, wanted.volume);
    mixer_.send({0, output});
    played_->gain = output.gain / std::numbers::sqrt2;
}

HeardOutput PlayedSound::output() const {
    const OutputProfile& profile = settings_.headset;
    return {OutputKind::headset, volume_steps(profile), default_volume(profile)};
}

void PlayedSound::wait_for_voice() {
    constexpr int most_ms = 20'000;
    for (int i = 0; i < most_ms && !speaker_.voice().is_done(); ++i) {
        (void)poll(nullptr, 0, 1);
        speaker_.step(heard_->now_s);
    }
}

void PlayedSound::step(const HandMoment& moment) {
    told_.step(moment);
    speaker_.step(heard_->now_s);
    wait_for_voice();
    const auto end = static_cast<std::size_t>(std::llround(heard_->now_s * frame_rate_Hz));
    if (end <= played_->left.size()) return;
    const auto sound = left_of_stereo(rendered(mixer_, end - played_->left.size()));
    played_->left.insert(played_->left.end(), sound.begin(), sound.end());
}

void PlayedSound::forget() {
    told_.forget();
    speaker_.forget();
}

}  // namespace touchline
