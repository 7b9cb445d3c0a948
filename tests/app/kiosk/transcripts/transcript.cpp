#include "tests/app/kiosk/transcripts/transcript.h"

#include "audio-cues/speech/speech_input.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr double soon_s = 10.0;
constexpr std::string_view margin = "         ";

std::string time_of(double at_s) {
    const int tenths = static_cast<int>(std::floor(10.0 * at_s + 0.5));
    return fmt::format("{:02}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

bool is_stop(char sign) {
    return sign == '.' || sign == '?' || sign == '!';
}

std::string without_stop(std::string text) {
    while (!text.empty() && is_stop(text.back())) text.pop_back();
    return text;
}

/// Returns the words between the placeholders of a text: "On: {0}." gives "On: " and ".".
std::vector<std::string> words_between_places(const std::string& text) {
    std::vector<std::string> words(1);
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_place = text[i] == '{' && i + 2 < text.size() && text[i + 2] == '}';
        if (!is_place) {
            words.back() += text[i];
            continue;
        }
        words.emplace_back();
        i += 2;
    }
    return words;
}

bool has_letters(const std::vector<std::string>& words) {
    for (const std::string& some : words)
        for (const char sign : some)
            if (std::isalpha(static_cast<unsigned char>(sign)) != 0) return true;
    return false;
}

/// Returns true if the sentence is the text with its placeholders filled.
bool is_filled(const std::string& sentence, const std::vector<std::string>& words) {
    if (!sentence.starts_with(words.front())) return false;
    if (words.size() == 1) return sentence == words.front();
    std::size_t at = words.front().size();
    for (std::size_t i = 1; i < words.size(); ++i) {
        const bool is_last = i + 1 == words.size();
        const std::size_t found = is_last ? sentence.rfind(words[i]) : sentence.find(words[i], at);
        if (found == std::string::npos || found < at) return false;
        at = found + words[i].size();
    }
    return at == sentence.size();
}

/// Returns the English texts that differ from every text the other language says.
std::vector<std::vector<std::string>> english_only(const PoFile& catalogue) {
    std::set<std::string> english;
    std::set<std::string> said;
    for (const auto& [key, entry] : catalogue) {
        for (const std::string& text : {key.second, entry.plural})
            if (!text.empty()) english.insert(without_stop(text));
        for (const std::string& text : entry.said) said.insert(without_stop(text));
    }
    std::vector<std::vector<std::string>> only;
    for (const std::string& text : english) {
        auto words = words_between_places(text);
        if (!said.contains(text) && has_letters(words)) only.push_back(std::move(words));
    }
    return only;
}

/// Returns the whole sentence, and its parts between commas: an item's name, value and place.
std::vector<std::string> parts_of(const std::string& sentence) {
    std::vector<std::string> parts{sentence};
    for (std::size_t at = 0; at < sentence.size();) {
        const std::size_t comma = std::min(sentence.find(", ", at), sentence.size());
        parts.push_back(sentence.substr(at, comma - at));
        at = comma + 2;
    }
    return parts;
}

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

std::vector<std::string> sentences_of(std::string_view text) {
    std::vector<std::string> sentences;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_end = i + 1 == text.size() || (is_stop(text[i]) && text[i + 1] == ' ');
        if (!is_end) continue;
        sentences.emplace_back(text.substr(begin, i + 1 - begin));
        begin = i + 2;
    }
    return sentences;
}

std::string text_of(const Transcript& transcript, std::string_view language) {
    std::string text;
    for (const TranscriptLine& line : transcript) {
        if (line.language.empty()) {
            text += fmt::format("{}[{}]\n", margin, line.text);
            continue;
        }
        std::string before = time_of(line.at_s) + "  ";
        if (line.language != language) before += '(' + line.language + ") ";
        for (const std::string& sentence : sentences_of(line.text))
            text += std::exchange(before, std::string(margin)) + sentence + '\n';
        if (line.is_cut) text.insert(text.size() - 1, " ...");
    }
    return text;
}

std::vector<std::string> said_twice(const Transcript& transcript) {
    std::vector<std::string> faults;
    std::map<std::pair<std::string, std::string>, double> ends_s;
    for (const TranscriptLine& line : transcript) {
        if (line.language.empty()) continue;
        std::vector<std::string> sentences = sentences_of(line.text);
        if (line.is_cut && !sentences.empty())
            sentences.pop_back();  // it may begin another text, and was not said
        for (const std::string& sentence : sentences) {
            const auto [said, is_new] =
                ends_s.try_emplace({line.language, without_stop(sentence)}, line.end_s);
            const bool is_soon = !is_new && line.at_s - said->second < soon_s;
            const bool is_of_line = said->second == line.end_s;
            if (is_soon && (is_of_line || !line.is_asked))
                faults.push_back(time_of(line.at_s) + ' ' + sentence);
            said->second = line.end_s;
        }
    }
    return faults;
}

std::vector<std::string> left_in_english(const Transcript& transcript, std::string_view language,
                                         const PoFile& catalogue) {
    const auto only = english_only(catalogue);
    const auto is_english = [&only](const std::string& part) {
        return std::ranges::any_of(only,
                                   [&part](const auto& words) { return is_filled(part, words); });
    };
    std::vector<std::string> faults;
    for (const TranscriptLine& line : transcript) {
        if (line.language != language) continue;
        for (const std::string& sentence : sentences_of(line.text))
            if (std::ranges::any_of(parts_of(without_stop(sentence)), is_english))
                faults.push_back(time_of(line.at_s) + ' ' + sentence);
    }
    return faults;
}

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
