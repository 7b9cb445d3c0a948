// What a speech engine gets: a text without commands, respelled where the voice says it wrong, and
// a rate. Threads: constants and pure functions.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// The seven steps that a visitor chooses from: 50 to 200 % of the middle one.
inline constexpr std::array<double, 7> speech_rates_per_minute{65.0,  80.0,  100.0, 130.0,
                                                               165.0, 210.0, 260.0};

inline constexpr std::size_t default_speech_rate = 3;

/// The engine's settings. They never change the pitch.
struct EngineRate {
    int words_per_minute = 175;  // by its own count, 80 ... 450
    int word_gap = 0;            // pause between words, in the engine's units
};

/// Returns the setting for a step of speech_rates_per_minute (clamped) in a language of this pace
/// (Language::pace()). Measured: at the engine's slowest, English has 102 words a minute, so slower
/// speech uses pauses between words, which are also easier to follow than stretched vowels.
[[nodiscard]] EngineRate engine_rate(std::size_t step, double pace);

/// Longer texts are cut: a minute or so at the slowest rate.
inline constexpr std::size_t longest_speech_bytes = 4000;

/// Removes what an engine could take for commands: control characters become blanks, as do bytes
/// that are not UTF-8; cuts between two characters at longest_speech_bytes. Brackets stay, because
/// markup and phoneme input are switched off in the engine.
[[nodiscard]] std::string plain_text(std::string_view text);

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
