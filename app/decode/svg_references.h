// Private to app/decode: counts how often an SVG has its parts drawn again, before anything is
// drawn.
// Threads: pure functions.
#pragma once

#include <cstddef>
#include <string_view>

namespace touchline::decode {

/// Maps repeat a sign some hundred times; this many take a tenth of a second.
constexpr std::size_t most_drawn_again = 20'000;

/// How many elements are drawn because another refers to them (use, pattern, marker, mask,
/// clip-path, filter), each time with everything they refer to in turn. most_drawn_again + 1 for
/// any more, and for chains of references deeper than in any drawing; 0 if it is no XML. A marker
/// counts once per path, though it is drawn at each corner. O(text).
[[nodiscard]] std::size_t drawn_again(std::string_view svg);

}  // namespace touchline::decode
