// Speech for the kiosk: texts go in, samples go out to the mixer.
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

/// How to speak a language (Language::voice(), pace() and respelling()).
struct SpokenLanguage {
    std::string voice = "en";
    double pace = 1.0;
    std::vector<Respelling> respellings{};
};

class Speaker {
  public:
    /// `languages` is keyed by language code. The mixer must outlive the speaker.
    Speaker(std::string program, std::map<std::string, SpokenLanguage> languages,
            RecordedPrompts prompts, Mixer& mixer);

    /// As SpeechQueue; `now_s` is of any clock that does not go back. These never wait.
    void say(const Utterance& utterance, double now_s);
    void stop(double now_s);
    void repeat(double now_s);
    void toggle_pause();

    /// Takes effect from the next utterance on; clamped to the valid steps.
    void set_rate(std::size_t step);

    [[nodiscard]] std::size_t rate() const { return rate_; }

    /// Moves samples on, and notices ends and deaths. Call it often, about 60 times a second.
    void step(double now_s);

    [[nodiscard]] const SpeechQueue& queue() const { return queue_; }

    [[nodiscard]] const VoiceProcess& voice() const { return voice_; }

    /// The session ended: forgets everything that was said.
    void forget();

  private:
    void carry_out(const SpeechOrder& order);

    SpeechQueue queue_;
    VoiceProcess voice_;
    std::map<std::string, SpokenLanguage> languages_;
    RecordedPrompts prompts_;
    Mixer& mixer_;
    std::vector<float> samples_;  // waiting for the mixer
    std::size_t written_ = 0;     // how many of them it has
    std::size_t rate_ = default_speech_rate;
};

}  // namespace touchline
