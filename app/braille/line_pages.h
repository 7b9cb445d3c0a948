// What stands on a braille line: texts, each paged at its blanks, and the place where the reader
// is.
//
// A reader sets the pace. A text that cuts what was said before is on the line at once, from its
// beginning; one that waits its turn comes when the reader has had the time to read the last page
// of what stands there, and never before the reader has paged that far. What stood there before can
// be paged back to, as far as texts are kept; after the last text comes what rests: the item that
// has the focus.
//
// Threads: values and pure functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace touchline {

using BrailleCells = std::vector<std::uint8_t>;

/// A part of a text: `count` cells from `first` on stand on the line.
struct LinePage {
    std::size_t first = 0;
    std::size_t count = 0;

    friend bool operator==(const LinePage&, const LinePage&) = default;
};

/// Parts the cells into pages of at most `width` cells (1 or more), at blanks where there is one; a
/// word that is wider than the line is cut. Each cell with a dot is on exactly one page, in order;
/// blanks at a page's end are on none. At least one page, which is empty for a text without dots.
/// O(cells).
[[nodiscard]] std::vector<LinePage> pages_of(std::span<const std::uint8_t> cells,
                                             std::size_t width);

enum class LineTurn : std::uint8_t { on, back, to_first, to_last };

/// now: cuts what is being read. after: waits its turn.
enum class LineUse : std::uint8_t { now, after };

/// As many texts as are kept to page back to.
inline constexpr std::size_t most_line_texts = 32;

/// How long somebody may need who reads slowly: a second to get there, and a quarter for a cell.
[[nodiscard]] constexpr double reading_s(std::size_t cells) {
    return 1.0 + 0.25 * static_cast<double>(cells);
}

/// The state of the line. Change it only by the functions below. Places: `at` is an index of
/// `texts`, or texts.size() for what rests; `cell` is the first cell of the page.
struct LineReading {
    std::deque<BrailleCells> texts;  // oldest first
    BrailleCells resting;            // empty: nothing rests
    std::size_t width = 0;           // 0: there is no line
    std::size_t at = 0;
    std::size_t cell = 0;
    double since_s = 0.0;  // when the page was put on the line

    friend bool operator==(const LineReading&, const LineReading&) = default;
};

/// What is to be read in cells; all blank if there is nothing. As wide as the line. O(cells).
[[nodiscard]] BrailleCells shown_on(const LineReading& reading);

/// Adds a text, and forgets the oldest if there are too many. One without a dot is left out; one
/// that is the last already is not there twice. While what rests is read, nothing is cut: every
/// text comes at once.
[[nodiscard]] LineReading with_text(LineReading reading, BrailleCells cells, LineUse use,
                                    double now_s);

/// Changes what comes after the last text. What is being read stays where it is, unless that is
/// what rests.
[[nodiscard]] LineReading with_resting(LineReading reading, BrailleCells cells, double now_s);

/// The line has another width now, or is gone (0). The page then has the cell that was the first.
[[nodiscard]] LineReading with_width(LineReading reading, std::size_t width, double now_s);

/// Turns a page; over the end of a text to the next one, over its beginning to the last page of the
/// one before. Returns nothing at an end: there is no such page.
[[nodiscard]] std::optional<LineReading> turned(LineReading reading, LineTurn turn, double now_s);

/// Goes on to a text that waits, once its time has come.
[[nodiscard]] LineReading passed(LineReading reading, double now_s);

/// When passed() will next do something; nothing: not by itself.
[[nodiscard]] std::optional<double> next_due_s(const LineReading& reading);

}  // namespace touchline
