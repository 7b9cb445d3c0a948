#include "audio-cues/speech/spoken_text.h"

#include <algorithm>
#include <string_view>

namespace touchline {
namespace {

bool is_heard(char c) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    return is_letter || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80U;
}

void add_words(std::string_view words, std::vector<SpeechPiece>& pieces) {
    constexpr std::string_view between = " ,.;:!?";
    words.remove_prefix(std::min(words.find_first_not_of(between), words.size()));
    if (std::ranges::any_of(words, is_heard)) pieces.push_back({std::string(words), nullptr});
}

}  // namespace

std::vector<SpeechPiece> pieces_of(const SpokenText& text) {
    if (text.recorded.empty()) return {{text.words, nullptr}};
    const std::string_view words = text.words;
    std::vector<SpeechPiece> pieces;
    std::size_t at = 0;
    for (const RecordedSpan& span : text.recorded) {
        const bool is_sound = span.begin >= at && span.begin < span.end &&
                              span.end <= words.size() && span.recording &&
                              !span.recording->samples.empty();
        if (!is_sound) continue;
        add_words(words.substr(at, span.begin - at), pieces);
        pieces.push_back(
            {std::string(words.substr(span.begin, span.end - span.begin)), span.recording});
        at = span.end;
    }
    add_words(words.substr(at), pieces);
    return pieces;
}

}  // namespace touchline
