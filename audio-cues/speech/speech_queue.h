// What is being said, what waits, and what has been said: a pure state machine.
// Threads: plain values; one thread's.
#pragma once

#include "audio-cues/speech/spoken_text.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// hint: waits for its turn, and is dropped when anything else is said. text: cuts hints and older
/// text. safety: must be heard; cuts everything else and is cut by nothing; several wait for one
/// another.
enum class SpeechPriority : std::uint8_t { hint, text, safety };

struct Utterance {
    std::string language;  // code, as of Language
    std::string text;
    SpeechPriority priority = SpeechPriority::text;
    std::vector<RecordedSpan> recorded = {};  // of the text
    /// Tells what the hand is on: a newer one takes the place of one that is said or waits. A
    /// recording may last much longer than the hand stays.
    bool is_of_hand = false;
};

/// Something that was said, for captions and tests.
struct SpeechRecord {
    double begin_s = 0.0;
    std::string language;
    std::string text;
    bool was_interrupted = false;
};

/// What the voice must do: first stop, if asked to, then begin.
struct SpeechOrder {
    bool stop = false;
    std::optional<Utterance> begin;
};

/// Times never go back; `now_s` is from any clock. Every call is O(waiting).
class SpeechQueue {
  public:
    [[nodiscard]] SpeechOrder say(const Utterance& utterance, double now_s);

    /// A key was pressed: cuts and forgets everything except safety.
    [[nodiscard]] SpeechOrder stop(double now_s);

    /// The voice has finished what it was saying.
    [[nodiscard]] SpeechOrder finished(double now_s);

    /// Says the last utterance again (the current one, if any), as text.
    [[nodiscard]] SpeechOrder repeat(double now_s);

    /// Pauses; the next call resumes. Any new utterance ends a pause.
    bool toggle_pause() { return is_paused_ = !is_paused_ && current_.has_value(); }

    [[nodiscard]] bool is_paused() const { return is_paused_; }

    /// The current utterance, for the caption.
    [[nodiscard]] const std::optional<Utterance>& current() const { return current_; }

    /// The last 200 that ended, oldest first. None of it is ever written to a file.
    [[nodiscard]] const std::deque<SpeechRecord>& transcript() const { return transcript_; }

    /// Forgets everything about a visitor.
    void forget() { *this = SpeechQueue{}; }

  private:
    /// Forgets what waits and ends the current utterance if `is_replaced` holds for it. Returns
    /// whether it ended one.
    template <class Condition>
    bool drop(Condition is_replaced);
    SpeechOrder begin_next(bool stop, double now_s);
    void end_current(bool was_interrupted);

    std::optional<Utterance> current_;
    double begin_s_ = 0.0;
    std::vector<Utterance> waiting_;  // within a priority, first come, first said
    std::optional<Utterance> last_;
    std::deque<SpeechRecord> transcript_;
    bool is_paused_ = false;
};

}  // namespace touchline
