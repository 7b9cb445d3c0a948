// What a sheet says: title, description, parts and the notes of who made it, as paragraphs.
// Threads: pure functions.
#pragma once

#include "app/sheets/braille_lines.h"
#include "audio-cues/words/language.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <string>
#include <vector>

namespace touchline {

/// The map with its names in the language. What tracing names by kind and place has its kind alone,
/// the second of a kind with a number, for a hand feels where it is; a mere line has no name then,
/// which would only take its room. O(outlines).
[[nodiscard]] TactileMap named_for_paper(TactileMap map, const Language& language);

/// A part with a name: the outlines that are called so, or a place without a line.
struct NamedPart {
    std::string name;
    std::vector<std::size_t> outlines;
    Position place;  // the middle of its lines' box in W, or the label's place
};

/// In the order of the map; outlines come before places. Outlines of one name are one part, and a
/// text that says the name of an outline is none; two places of one name are two. None for a map
/// whose only name is that of its only part: its title says it. O((outlines + labels) * parts).
[[nodiscard]] std::vector<NamedPart> named_parts(const TactileMap& map);

/// More than these find no room on paper, and telling them would fill a book.
inline constexpr std::size_t most_sheet_parts = 200;

/// Fails with one line for a map of more parts. As named_parts().
[[nodiscard]] Result<void> check_parts(const TactileMap& map);

/// The signs of title, description and names that the braille of this language lacks and writes as
/// question marks. Fails as braille_of() does. O(texts).
[[nodiscard]] Result<std::size_t> signs_without_braille(const TactileMap& map,
                                                        const BrailleHand& hand);

/// What was changed on the way to paper, for the reader.
struct SheetChanges {
    double scale = 0.0;                   // paper per map; 0: the scale is not told
    std::vector<std::string> left_out;    // parts
    std::vector<std::string> unlabelled;  // parts
};

enum class ParagraphKind : std::uint8_t { title, text, item };

struct SheetParagraph {
    ParagraphKind kind = ParagraphKind::text;
    std::string words;
};

/// Title, description, the parts with their places, the notes.
[[nodiscard]] std::vector<SheetParagraph> paragraphs_of(const TactileMap& map,
                                                        const SheetChanges& changes,
                                                        const Language& language);

/// "2 cm are 1.3 cm at the kiosk." for paper that is `scale` times as large as the map.
[[nodiscard]] std::string scale_words(double scale, const Language& language);

/// "This side up."
[[nodiscard]] std::string up_words(const Language& language);

/// Lines of one width. The title is in the middle, a text begins in the third cell, and an item's
/// further lines do. A blank line follows the title.
[[nodiscard]] Result<std::vector<BrailleCells>> braille_lines(
    const std::vector<SheetParagraph>& paragraphs, std::size_t width, const BrailleHand& hand);

}  // namespace touchline
