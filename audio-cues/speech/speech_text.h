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

}  // namespace touchline
