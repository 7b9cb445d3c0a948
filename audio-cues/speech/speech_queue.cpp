#include "audio-cues/speech/speech_queue.h"

#include <algorithm>

namespace touchline {
namespace {

constexpr std::size_t longest_transcript = 200;
constexpr std::size_t most_waiting = 32;

bool is_no_safety(const Utterance& utterance) {
    return utterance.priority != SpeechPriority::safety;
}

}  // namespace

void SpeechQueue::end_current(bool was_interrupted) {
    if (!current_) return;
    transcript_.push_back({begin_s_, current_->language, current_->text, was_interrupted});
    if (transcript_.size() > longest_transcript) transcript_.pop_front();
    last_ = std::move(current_);
    current_.reset();
}

/// Begins the waiting utterance of highest priority, unless something is being said.
SpeechOrder SpeechQueue::begin_next(bool stop, double now_s) {
    if (current_ || waiting_.empty()) return {stop, std::nullopt};
    const auto next = std::max_element(
        waiting_.begin(), waiting_.end(),
        [](const Utterance& a, const Utterance& b) { return a.priority < b.priority; });
    current_ = *next;
    waiting_.erase(next);
    begin_s_ = now_s;
    is_paused_ = false;
    return {stop, current_};
}

template <class Condition>
bool SpeechQueue::drop(Condition is_replaced) {
    std::erase_if(waiting_, is_replaced);
    const bool stops = current_ && is_replaced(*current_);
    if (stops) end_current(true);
    return stops;
}

SpeechOrder SpeechQueue::say(const Utterance& utterance, double now_s) {
    if (utterance.text.empty()) return {};
    bool stops = false;
    if (utterance.priority != SpeechPriority::hint)
        stops = drop(is_no_safety);
    else if (utterance.is_of_hand)
        stops = drop([](const Utterance& said) { return said.is_of_hand; });
    if (waiting_.size() < most_waiting) waiting_.push_back(utterance);
    return begin_next(stops, now_s);
}

SpeechOrder SpeechQueue::stop(double now_s) {
    const bool stops = drop(is_no_safety);
    return begin_next(stops, now_s);
}

SpeechOrder SpeechQueue::finished(double now_s) {
    end_current(false);
    return begin_next(false, now_s);
}

SpeechOrder SpeechQueue::repeat(double now_s) {
    std::optional<Utterance> again = current_ ? current_ : last_;
    if (!again) return {};
    if (current_ && current_->priority == SpeechPriority::safety) return {};  // it is being said
    again->priority = SpeechPriority::text;
    return say(*again, now_s);
}

}  // namespace touchline
