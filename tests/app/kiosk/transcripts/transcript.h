// What a visitor hears in a whole visit, as a text for people to review, the voice that says it,
// and what it must never contain. Threads: one; values and pure functions but for the voice.
#pragma once

#include "app/sound/visitor_sound.h"
#include "tests/audio-cues/words/po_file.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

struct TranscriptLine {
    double at_s = 0.0;
    double end_s = 0.0;    // end of the speech
    std::string language;  // code; empty: a stage direction
    std::string text;      // if the speech was cut: what was heard
    bool is_cut = false;
    bool is_asked = false;  // a key asked for these words
};

/// What was said and what the visitor did, in order.
using Transcript = std::vector<TranscriptLine>;

/// Returns each sentence, with the stop that ends it.
[[nodiscard]] std::vector<std::string> sentences_of(std::string_view text);

/// Returns one line for each sentence and each stage direction; the first line of each speech has
/// its time. Words in another language than `language` begin with its code.
[[nodiscard]] std::string text_of(const Transcript& transcript, std::string_view language);

/// Returns sentences that are said again within ten seconds though no key asked for them, or twice
/// in one speech, each with its time.
[[nodiscard]] std::vector<std::string> said_twice(const Transcript& transcript);

/// Returns English sentences where the visit's language has other words; `catalogue` is that
/// language's.
[[nodiscard]] std::vector<std::string> left_in_english(const Transcript& transcript,
                                                       std::string_view language,
                                                       const PoFile& catalogue);

/// Outlives the voice, which the kiosk owns.
struct Hearing {
    double now_s = 0.0;
    double key_s = -1.0;  // of the last key
    Transcript transcript;
    int ended = 0;             // utterances that were said to their end
    bool is_speaking = false;  // or an utterance waits
};

/// A sound on a virtual clock that is silent and takes as long as a voice: it cuts, delays and
/// drops speech as a kiosk does (audio-cues/speech/speech_queue.h).
class TimedVoice final : public VisitorSound {
  public:
    explicit TimedVoice(std::shared_ptr<Hearing> hearing) : hearing_(std::move(hearing)) {}

    void say(const Utterance& utterance) override;
    void hush() override;

    void toggle_pause() override {}

    [[nodiscard]] bool is_speaking() const override { return queue_.current().has_value(); }

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
