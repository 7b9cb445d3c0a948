// Speech as the kiosk uses it: what to say in, samples to the mixer out.
// Threads: one; the mixer renders in another.
#pragma once

#include "app/speak/voice_process.h"
#include "audio-cues/speech/recorded_prompts.h"
#include "audio-cues/speech/respelling.h"
#include "audio-cues/speech/speech_queue.h"
#include "audio-cues/synth/mixer.h"

#include <map>
#include <string>
#include <vector>

namespace touchline {

/// How a language is spoken (Language::voice(), pace() and respelling()).
struct SpokenLanguage {
    std::string voice = "en";
    double pace = 1.0;
    std::vector<Respelling> respellings{};
};

class Speaker {
  public:
    /// By language code; the mixer must outlive the speaker.
    Speaker(std::string program, std::map<std::string, SpokenLanguage> languages,
            RecordedPrompts prompts, Mixer& mixer);

    /// As SpeechQueue; `now_s` is any clock that does not go back. Never wait.
    void say(const Utterance& utterance, double now_s);
    void stop(double now_s);
    void repeat(double now_s);
    void toggle_pause();

    /// From the next utterance on; clamped to the steps there are.
    void set_rate(std::size_t step);

    [[nodiscard]] std::size_t rate() const { return rate_; }

    /// Often, 60 times a second say: moves samples on, notices ends and deaths.
    void step(double now_s);

    [[nodiscard]] const SpeechQueue& queue() const { return queue_; }

    [[nodiscard]] const VoiceProcess& voice() const { return voice_; }

    /// The session ended: nothing that was said stays.
    void forget();

  private:
    void carry_out(const SpeechOrder& order);

    SpeechQueue queue_;
    VoiceProcess voice_;
    std::map<std::string, SpokenLanguage> languages_;
    RecordedPrompts prompts_;
    Mixer& mixer_;
    std::vector<float> samples_;  // on their way to the mixer
    std::size_t written_ = 0;     // of them
    std::size_t rate_ = default_speech_rate;
};

}  // namespace touchline
