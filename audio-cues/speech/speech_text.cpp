#include "audio-cues/speech/speech_text.h"

#include "config/types/utf8.h"

#include <algorithm>

namespace touchline {
namespace {

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
        const std::size_t size = utf8_character_bytes(text);
        const auto character = text.substr(0, std::max<std::size_t>(size, 1));
        const bool is_plain = size > 0 && !is_control(character);
        if (plain.size() + character.size() > longest_speech_bytes) break;
        plain += is_plain ? character : std::string_view(" ");
        text.remove_prefix(character.size());
    }
    return plain;
}

}  // namespace touchline
