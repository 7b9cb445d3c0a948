#include "audio-cues/speech/speech_text.h"

#include <algorithm>
#include <vector>

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

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool can_be_said(std::string_view part) {
    // Beyond ASCII every letter is taken for a vowel: the language's voice knows better.
    return part.find_first_of("aeiouyAEIOUY") != std::string_view::npos ||
           std::any_of(part.begin(), part.end(), is_following);
}

bool is_shouted(std::string_view part) {
    return part.size() <= 3 &&
           std::all_of(part.begin(), part.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
}

/// Letters and digits apart, split at all else but what is beyond ASCII.
std::vector<std::string> parts_of(std::string_view name) {
    std::vector<std::string> parts;
    char last = ' ';
    for (const char c : name) {
        const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                               static_cast<unsigned char>(c) >= 0x80U;
        if (is_letter || is_digit(c)) {
            const bool begins = last == ' ' || is_digit(last) != is_digit(c);
            if (begins) parts.emplace_back();
            parts.back() += c;
            last = c;
        } else {
            last = ' ';
        }
    }
    return parts;
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

std::string spelled(std::string_view word) {
    std::string letters;
    while (!word.empty()) {
        const std::size_t size = std::max<std::size_t>(character_bytes(word), 1);
        if (!letters.empty()) letters += ' ';
        letters += word.substr(0, size);
        word.remove_prefix(size);
    }
    return letters;
}

std::string speakable_name(std::string_view file_name) {
    const auto slash = file_name.find_last_of('/');
    if (slash != std::string_view::npos) file_name.remove_prefix(slash + 1);
    const auto point = file_name.find_last_of('.');
    if (point != std::string_view::npos && point > 0) file_name = file_name.substr(0, point);
    std::string said;
    for (const std::string& part : parts_of(file_name)) {
        if (!said.empty()) said += ' ';
        const bool is_word = !is_digit(part[0]) && can_be_said(part) && !is_shouted(part);
        const bool is_small_number = is_digit(part[0]) && part.size() <= 2;
        said += is_word || is_small_number ? part : spelled(part);
    }
    return said;
}

}  // namespace touchline
