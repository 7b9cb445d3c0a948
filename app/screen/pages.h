// Fills lines into pages of one size. Nothing scrolls and nothing is cut off: what does not fit
// goes to the next page. All places are relative to the upper left corner of the page.
// Threads: values and pure functions.
#pragma once

#include "app/screen/layout.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace touchline {

/// Marks of a phrase: the value of a toggle has a frame, that of a setting triangles while Up and
/// Down change it.
enum class PhraseMark : std::uint8_t { none, frame, triangles };

/// The room that a mark needs on either side of its text.
[[nodiscard]] double mark_room_px(PhraseMark mark, double cap_px);

/// A piece of text in a line.
struct Phrase {
    double x_px = 0.0;      // of the text itself, from the left edge of the block
    double width_px = 0.0;  // of the text
    std::string text;
    bool is_bold = false;
    PhraseMark mark = PhraseMark::none;
};

using PhraseRow = std::vector<Phrase>;

/// Rows that belong together.
struct RowBlock {
    std::vector<PhraseRow> rows;
    std::optional<std::size_t> item;  // of the screen
    /// Running text fills the rest of a page. Other rows are split only if they do not all fit on a
    /// page of their own.
    bool is_running = false;
};

struct PageMetrics {
    double height_px = 0.0;
    double row_px = 0.0;    // > 0
    double inset_px = 0.0;  // above and below the rows of each block, and left of them
    double gap_px = 0.0;    // between blocks
};

struct PlacedPhrase {
    PixelPoint at;  // upper left corner of its line's box
    Phrase phrase;
};

/// An item, or its part on this page.
struct PlacedItem {
    std::size_t item = 0;
    double top_px = 0.0;  // of its frame
    double height_px = 0.0;
};

struct SheetPage {
    std::vector<PlacedPhrase> phrases;
    std::vector<PlacedItem> items;
};

/// Returns at least one page. A page too low for a single row still holds one. The last item of a
/// list has another beside it where pages hold three. O(phrases).
[[nodiscard]] std::vector<SheetPage> pages_of(std::span<const RowBlock> blocks,
                                              const PageMetrics& metrics);

/// How long a page is shown when pages turn by themselves: enough for slow readers.
[[nodiscard]] std::int64_t reading_time_ns(const SheetPage& page);

/// Pages first ... first + count - 1.
struct PageRange {
    std::size_t first = 0;
    std::size_t count = 1;
};

/// The pages with parts of an item; the first page if it is on none.
[[nodiscard]] PageRange pages_with(std::span<const SheetPage> pages, std::size_t item);

/// The page of a range to show `elapsed_ns` (>= 0) after the range came: one after the other, then
/// from the first again.
[[nodiscard]] std::size_t page_at(std::span<const SheetPage> pages, PageRange range,
                                  std::int64_t elapsed_ns);

}  // namespace touchline
