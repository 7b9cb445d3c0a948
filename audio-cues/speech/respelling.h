// What a voice says wrong, written so that it says it right: the voice alone gets it, never a
// screen or a caption. Threads: pure functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchline {

struct Respelling {
    std::string written;  // whole words; letters count as they are, small or capital
    std::string spoken;
    bool is_before_word = false;  // only where a number or a word of two letters or more is next
};

/// The rows of a catalogue's text (Language::respelling()): "A … = A …; A = eh; 1:… = une heure:…".
/// "…" stands for the word that must follow. What has no "=" is passed over. O(length).
[[nodiscard]] std::vector<Respelling> respellings_of(std::string_view table);

/// At each place the first row that fits is taken; what it gives is not read again.
/// O(length * rows).
[[nodiscard]] std::string respelled(std::string_view text, const std::vector<Respelling>& rows);

}  // namespace touchline
