// A sheet for swell paper: from a map, as it is felt at the kiosk, to lines, labels and words.
// Threads: pure functions, except for the tables of braille_of() (app/braille/translation.h).
#pragma once

#include "app/sheets/braille_lines.h"
#include "app/sheets/tactile_sheet.h"
#include "audio-cues/words/language.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

namespace touchline {

struct SheetOrder {
    PaperKind paper = PaperKind::a4;
    BrailleHand hand;
};

/// The drawing as large as its labels allow, upright or on the side, then pages of words: the
/// description, the parts and what was changed. Everything is within the margins. Fails with one
/// line for a map without lines, of no size or of too many parts, and as braille_of() does.
/// Measured, as processor time: 40 ms for a picture of the gallery on average and 0.4 s at most,
/// 0.8 s for 40 parts with long names, 7 s for 200 parts (tests/app/sheets: print_gallery tells the
/// first two).
[[nodiscard]] Result<TactileSheet> tactile_sheet(const TactileMap& map, const SheetOrder& order,
                                                 const Language& language);

}  // namespace touchline
