// Text as braille: the cells of a text in the braille code of its language, by liblouis and the
// tables of Debian's liblouis-data.
//
// Threads: any thread may call, also several at once. liblouis keeps its tables in state of the
// whole process that it does not guard, so these calls take a lock and go one after the other; no
// other code of the process may call liblouis.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

struct BrailleText {
    /// Bit 0 is dot 1 ... bit 7 is dot 8. Our tables use six dots; the other two are set only where
    /// the text itself has characters of Unicode's braille patterns.
    std::vector<std::uint8_t> cells;
    /// For each character (code point, or byte that is part of none) of the text its first cell. A
    /// character without cells of its own has the cell that comes next, which may be cells.size().
    /// Never falls.
    std::vector<int> first_cell;
    /// For each cell the character that it stands for; of a contraction the first one. Never falls.
    std::vector<int> character;
    /// The characters that are written as a question mark, for the table has nothing like them.
    std::size_t question_marks = 0;

    bool operator==(const BrailleText&) const = default;
};

enum class BrailleGrade : std::uint8_t { uncontracted, contracted };

/// Whether the language has a table: "en", "de", "fr", "es" or "it", also with a region ("de-AT",
/// "de_AT").
[[nodiscard]] bool has_braille(std::string_view language_tag);

/// Whether the language has a contracted table beside the other one. Italian has none.
[[nodiscard]] bool has_contractions(std::string_view language_tag);

/// Translates one text. A language with one grade is written in that one. No character is lost:
/// what the table lacks is written by its like (a straight apostrophe for a curved one, the bare
/// letter for one with a foreign accent), else as a question mark, as is each byte that is not
/// UTF-8. Blanks of any kind and control characters are blank cells; marks that nobody sees, such
/// as a soft hyphen, have no cells. An error says that the language has no table, or that the
/// tables are not installed. O(n), at most 5 us a character; the first call of a table reads it,
/// which takes up to 0.1 s (German, contracted).
[[nodiscard]] Result<BrailleText> braille_of(std::string_view text, const std::string& language_tag,
                                             BrailleGrade grade);

/// Returns the character of North American ASCII braille, as BRF files have it, for the six dots of
/// a cell; dots 7 and 8 are left out. Capital letters, and from ' ' to '_'.
[[nodiscard]] char braille_ascii(std::uint8_t cell);

}  // namespace touchline
