#include "tests/app/kiosk/transcripts/timed_voice.h"

#include "audio-cues/speech/speech_rate.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace touchline {
namespace {

constexpr double signs_a_word = 6.0;  // with the space after it
constexpr double answer_s = 5.0;      // after a key, once its work is done
constexpr double least_heard_s = 0.25;

bool begins_sign(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

/// Returns this many UTF-8 characters, up to the end of the word that had begun.
std::string heard_of(const std::string& text, double signs) {
    std::size_t at = 0;
    for (double heard = 0.0; at < text.size() && heard < signs; ++at)
        if (begins_sign(text[at])) ++heard;
    return text.substr(0, text.find(' ', at));
}

}  // namespace

double TimedVoice::signs_per_s() const {
    return signs_a_word * speech_rates_per_minute.at(rate_) / 60.0;
}

void TimedVoice::carry_out(const SpeechOrder& order) {
    if (order.stop) cut();
    if (order.begin) {
        const std::string& text = order.begin->text;
        begin_s_ = hearing_->now_s;
        end_s_ = begin_s_ +
                 static_cast<double>(std::ranges::count_if(text, begins_sign)) / signs_per_s();
        line_ = hearing_->transcript.size();
        hearing_->transcript.push_back({begin_s_, end_s_, order.begin->language, text, false,
                                        std::ranges::find(asked_, text) != asked_.end()});
    }
    hearing_->is_speaking = queue_.current().has_value();
}

/// Speech that had hardly begun was not heard.
void TimedVoice::cut() {
    Transcript& transcript = hearing_->transcript;
    TranscriptLine& line = transcript.at(line_);
    const double heard_s = hearing_->now_s - begin_s_;
    if (heard_s < least_heard_s) {
        transcript.erase(transcript.begin() + static_cast<std::ptrdiff_t>(line_));
        return;
    }
    line.end_s = hearing_->now_s;
    const std::string heard = heard_of(line.text, heard_s * signs_per_s());
    line.is_cut = heard.size() < line.text.size();
    line.text = heard;
}

void TimedVoice::say(const Utterance& utterance) {
    const double since_key_s = hearing_->now_s - hearing_->key_s;
    const bool is_answer = utterance.priority != SpeechPriority::hint && since_key_s < answer_s;
    if (since_key_s > 0.0) asked_.clear();
    if (is_answer || since_key_s <= 0.0) asked_.push_back(utterance.text);
    carry_out(queue_.say(utterance, hearing_->now_s));
}

void TimedVoice::hush() {
    carry_out(queue_.stop(hearing_->now_s));
}

void TimedVoice::play_side(bool is_left) {
    const double now_s = hearing_->now_s;
    hearing_->transcript.push_back(
        {now_s, now_s, "", is_left ? "a tone on the left" : "a tone on the right", false, false});
}

void TimedVoice::step(const HandMoment& /*moment*/) {
    if (!queue_.current() || hearing_->now_s < end_s_) return;
    ++hearing_->ended;
    carry_out(queue_.finished(hearing_->now_s));
}

void TimedVoice::forget() {
    if (queue_.current()) cut();
    queue_.forget();
    hearing_->is_speaking = false;
}

}  // namespace touchline
