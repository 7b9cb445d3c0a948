// Text as a speech engine may get it. Threads: pure functions.
#pragma once

#include <string>
#include <string_view>

namespace touchline {

/// Longer texts are cut: a minute or so at the slowest rate.
inline constexpr std::size_t longest_speech_bytes = 4000;

/// Without what an engine could take for orders: control characters become blanks, and bytes that
/// are no UTF-8 too; cut between two characters at longest_speech_bytes. Brackets stay: markup and
/// phoneme input are switched off in the engine.
[[nodiscard]] std::string plain_text(std::string_view text);

/// A name that nobody chose for its sound, as of a file: without folder and ending, parts apart,
/// and parts that cannot be said (no vowel, or digits) letter by letter: "scans/IMG_2041.jpg" is "I
/// M G 2 0 4 1", "garden-map.svg" is "garden map".
[[nodiscard]] std::string speakable_name(std::string_view file_name);

/// Letter by letter: "ab1" is "a b 1". Of UTF-8 whole characters.
[[nodiscard]] std::string spelled(std::string_view word);

}  // namespace touchline
