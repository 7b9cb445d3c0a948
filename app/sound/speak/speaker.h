// Speech for the kiosk: texts go in, samples go out to the mixer. The voice is one process per
// text; it may die at any time, and nobody notices. Threads: one; the mixer renders in another. The
// process dies with the thread that starts it.
#pragma once

#include "app/isolation/process/child.h"
#include "app/sound/speak/messages.h"
#include "audio-cues/speech/recorded_prompts.h"
#include "audio-cues/speech/speech_input.h"
#include "audio-cues/speech/speech_queue.h"
#include "audio-cues/speech/spoken_text.h"
#include "audio-cues/synth/mixer.h"
#include "config/types/pinned.h"

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// The voice as the kiosk holds it.
class VoiceProcess : private Pinned {
  public:
    /// `program`: path of touchline-speak. It is started when there is something to say, and then
    /// in advance for the next text.
    explicit VoiceProcess(std::string program) : program_(std::move(program)) {}

    ~VoiceProcess() { end_process(); }

    /// From now on says only this, with the voice of that name. Never waits.
    void begin(const std::string& voice, const std::string& text, const EngineRate& rate);

    /// Nothing more of the text will come.
    void stop();

    /// Appends the samples that came (at frame_rate_Hz). Never waits. Restarts a process that died,
    /// or was silent for `patience_s` (twice that after every death, because the machine may be
    /// busy); it goes on where it was, because the same text gives the same samples. Also restarts
    /// one that died while it waited for the next text. After three deaths it gives the text up,
    /// and starts a waiting process at most every `patience_s`.
    void receive(double now_s, std::vector<float>& samples);

    /// True if nothing more will come, or nothing was begun.
    [[nodiscard]] bool is_done() const { return is_done_; }

    /// How many processes were started after a death.
    [[nodiscard]] int restarts() const { return restarts_; }

    /// How many texts were given up.
    [[nodiscard]] int given_up() const { return given_up_; }

    /// -1: none runs.
    [[nodiscard]] pid_t pid() const { return child_ ? child_->pid() : -1; }

    static constexpr double patience_s = 2.0;

  private:
    bool start_process();
    void end_process();
    void send_order(double now_s);
    bool take_pieces(double now_s, std::vector<float>& samples);
    void count_death();

    std::string program_;
    std::string voice_;  // of the running process
    std::optional<Child> child_;
    Descriptor socket_;
    std::string wanted_voice_;
    SpeakOrder order_;
    bool is_done_ = true;
    bool is_sent_ = false;      // the process has its order
    std::size_t received_ = 0;  // samples received for the order
    std::size_t again_ = 0;     // samples to skip after a death, because they came before
    double heard_s_ = 0.0;      // when the process was started or last sent anything
    int deaths_ = 0;            // during this order
    int restarts_ = 0;
    int given_up_ = 0;
};

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
    void toggle_pause();

    /// The silence before and after a recording that is a part of an utterance.
    static constexpr double pause_s = 0.25;

    /// Takes effect from the next utterance on, or from its next piece; clamped to the valid steps.
    /// Recordings are heard at the speed at which they were made.
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
    void begin_pieces();
    void play(const VoiceRecording& recording);

    SpeechQueue queue_;
    VoiceProcess voice_;
    std::map<std::string, SpokenLanguage> languages_;
    RecordedPrompts prompts_;
    Mixer& mixer_;
    std::deque<SpeechPiece> pieces_;  // of the current utterance, that are not begun
    SpokenLanguage language_;         // of the current utterance
    std::vector<float> samples_;      // waiting for the mixer
    std::size_t written_ = 0;         // how many of them it has
    std::size_t rate_ = default_speech_rate;
};

}  // namespace touchline
