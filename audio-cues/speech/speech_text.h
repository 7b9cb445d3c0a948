// Makes text safe for a speech engine. Threads: pure functions.
#pragma once

#include <string>
#include <string_view>

namespace touchline {

/// Longer texts are cut: a minute or so at the slowest rate.
inline constexpr std::size_t longest_speech_bytes = 4000;

/// Removes what an engine could take for commands: control characters become blanks, as do bytes
/// that are not UTF-8; cuts between two characters at longest_speech_bytes. Brackets stay, because
/// markup and phoneme input are switched off in the engine.
[[nodiscard]] std::string plain_text(std::string_view text);

}  // namespace touchline
