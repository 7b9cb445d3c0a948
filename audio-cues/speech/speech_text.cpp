#include "audio-cues/speech/speech_text.h"

#include <algorithm>

namespace touchline {
namespace {

bool is_following(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// Bytes of the character that begins `text`; 0 where none does.
std::size_t character_bytes(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    const std::size_t size = first < 0x80U                      ? 1
                             : first >= 0xC2U && first <= 0xDFU ? 2
                             : first >= 0xE0U && first <= 0xEFU ? 3
                             : first >= 0xF0U && first <= 0xF4U ? 4
                                                                : 0;
    if (size == 0 || size > text.size()) return 0;
    const auto rest = text.substr(1, size - 1);
    return std::all_of(rest.begin(), rest.end(), is_following) ? size : 0;
}

bool is_control(std::string_view character) {
    const auto first = static_cast<unsigned char>(character[0]);
    if (character.size() == 1) return first < 0x20U || first == 0x7FU;
    return character.size() == 2 && first == 0xC2U &&
           static_cast<unsigned char>(character[1]) < 0xA0U;
}

}  // namespace

std::string plain_text(std::string_view text) {
    std::string plain;
    while (!text.empty()) {
        const std::size_t size = character_bytes(text);
        const auto character = text.substr(0, std::max<std::size_t>(size, 1));
        const bool is_plain = size > 0 && !is_control(character);
        if (plain.size() + character.size() > longest_speech_bytes) break;
        plain += is_plain ? character : std::string_view(" ");
        text.remove_prefix(character.size());
    }
    return plain;
}

}  // namespace touchline
