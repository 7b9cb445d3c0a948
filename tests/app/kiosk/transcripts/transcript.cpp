#include "tests/app/kiosk/transcripts/transcript.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
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

}  // namespace touchline
