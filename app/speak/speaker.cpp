#include "app/speak/speaker.h"

#include <algorithm>
#include <span>
#include <utility>

namespace touchline {

Speaker::Speaker(std::string program, std::map<std::string, SpokenLanguage> languages,
                 RecordedPrompts prompts, Mixer& mixer)
    : voice_(std::move(program)),
      languages_(std::move(languages)),
      prompts_(std::move(prompts)),
      mixer_(mixer) {}

void Speaker::carry_out(const SpeechOrder& order) {
    if (order.stop) {
        mixer_.speech().cut();
        voice_.stop();
        samples_.clear();
        written_ = 0;
    }
    if (!order.begin) return;
    mixer_.send({0, PauseSpeech{false}});
    if (const auto* recorded = prompts_.of(*order.begin)) {
        samples_ = *recorded;
        return;
    }
    const auto found = languages_.find(order.begin->language);
    const SpokenLanguage spoken = found == languages_.end() ? SpokenLanguage{} : found->second;
    voice_.begin(spoken.voice, respelled(order.begin->text, spoken.respellings),
                 engine_rate(rate_, spoken.pace));
}

void Speaker::say(const Utterance& utterance, double now_s) {
    carry_out(queue_.say(utterance, now_s));
}

void Speaker::stop(double now_s) {
    carry_out(queue_.stop(now_s));
}

void Speaker::repeat(double now_s) {
    carry_out(queue_.repeat(now_s));
}

void Speaker::toggle_pause() {
    mixer_.send({0, PauseSpeech{queue_.toggle_pause()}});
}

void Speaker::set_rate(std::size_t step) {
    rate_ = std::min(step, speech_rates_per_minute.size() - 1);
}

void Speaker::step(double now_s) {
    voice_.receive(now_s, samples_);
    written_ += mixer_.speech().write(std::span<const float>(samples_).subspan(written_));
    if (written_ < samples_.size() || !voice_.is_done()) return;
    samples_.clear();
    written_ = 0;
    if (queue_.current() && mixer_.speech().waiting() == 0) carry_out(queue_.finished(now_s));
}

void Speaker::forget() {
    carry_out({.stop = true, .begin = std::nullopt});
    queue_.forget();
}

}  // namespace touchline
