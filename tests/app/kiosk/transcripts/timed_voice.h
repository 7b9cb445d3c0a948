// A sound on a virtual clock that is silent and takes as long as a voice: it cuts, delays and drops
// speech as a kiosk does (audio-cues/speech/speech_queue.h). Threads: one.
#pragma once

#include "app/sound/visitor_sound.h"
#include "tests/app/kiosk/transcripts/transcript.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// Outlives the voice, which the kiosk owns.
struct Hearing {
    double now_s = 0.0;
    double key_s = -1.0;  // of the last key
    Transcript transcript;
    int ended = 0;             // utterances that were said to their end
    bool is_speaking = false;  // or an utterance waits
};

class TimedVoice final : public VisitorSound {
  public:
    explicit TimedVoice(std::shared_ptr<Hearing> hearing) : hearing_(std::move(hearing)) {}

    void say(const Utterance& utterance) override;
    void hush() override;

    void toggle_pause() override {}

    void give(ScreenEvent /*event*/) override {}

    void play_side(bool is_left) override;

    void choose(const SoundWanted& wanted) override { rate_ = wanted.rate; }

    void set_levels(const SoundSettings& /*levels*/, double /*lower_dB*/) override {}

    void step(const HandMoment& moment) override;

    [[nodiscard]] HeardOutput output() const override { return {OutputKind::headset, 7, 3}; }

    [[nodiscard]] std::optional<bool> are_headphones_in() const override { return std::nullopt; }

    void tell_headphones(bool /*are_in*/) override {}

    [[nodiscard]] std::string problem() const override { return {}; }

    [[nodiscard]] std::optional<ContactEvent> last_event() const override { return std::nullopt; }

    void forget() override;

  private:
    [[nodiscard]] double signs_per_s() const;
    void carry_out(const SpeechOrder& order);
    void cut();

    std::shared_ptr<Hearing> hearing_;
    SpeechQueue queue_;
    std::size_t rate_ = 0;
    std::size_t line_ = 0;  // in the transcript: what is being said
    double begin_s_ = 0.0;
    double end_s_ = 0.0;
    std::vector<std::string> asked_;  // by the last key; may be said later
};

}  // namespace touchline
