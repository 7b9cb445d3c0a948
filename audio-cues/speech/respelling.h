// Rewrites what a voice says wrong so that it says it right. Only the voice gets the result, never
// a screen or a caption. Threads: pure functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchline {

struct Respelling {
    std::string written;  // whole words; case does not matter
    std::string spoken;
    bool is_before_word = false;  // only if a number or a word of two or more letters follows
};

/// Parses the rows of a catalogue's text (Language::respelling()): "A … = A …; A = eh; 1:… = une
/// heure:…". "…" stands for the word that must follow. Skips rows without "=". O(length).
[[nodiscard]] std::vector<Respelling> respellings_of(std::string_view table);

/// Takes the first fitting row at each place; does not read its replacement again. O(length *
/// rows).
[[nodiscard]] std::string respelled(std::string_view text, const std::vector<Respelling>& rows);

}  // namespace touchline
