// Words in braille, broken into lines.
// Threads: pure functions, except for the tables of braille_of() (app/braille/translation.h).
#pragma once

#include "app/braille/translation.h"
#include "config/types/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

using BrailleCells = std::vector<std::uint8_t>;  // bit 0 is dot 1; 0 is a blank

/// How a sheet writes.
struct BrailleHand {
    std::string language = "en";
    BrailleGrade grade = BrailleGrade::uncontracted;
};

/// The cells of one line of text: no blanks at the ends, one between words. Fails as braille_of().
[[nodiscard]] Result<BrailleCells> cells_of(std::string_view text, const BrailleHand& hand);

/// Breaks at blanks, and inside a word only where it is wider than a line. The first line begins
/// with `first_indent` blanks, the others with `next_indent`; both are less than `width`. No line
/// ends in a blank. Empty for no cells. O(cells).
[[nodiscard]] std::vector<BrailleCells> wrapped(const BrailleCells& cells, std::size_t width,
                                                std::size_t first_indent = 0,
                                                std::size_t next_indent = 0);

/// The cells of the longest word.
[[nodiscard]] std::size_t longest_word(const BrailleCells& cells);

/// The ways to break a label: into one line, and into more down to its longest word, each as narrow
/// as its number of lines allows. `most_width` and `most_lines` bound them; may be empty.
[[nodiscard]] std::vector<std::vector<BrailleCells>> label_shapes(const BrailleCells& cells,
                                                                  std::size_t most_width,
                                                                  std::size_t most_lines);

}  // namespace touchline
