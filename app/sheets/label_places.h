// Where the braille labels of a drawing go, and the leader lines from them to what they name.
// Threads: pure functions.
#pragma once

#include "app/sheets/braille_lines.h"
#include "app/sheets/stroke_grid.h"
#include "app/sheets/tactile_sheet.h"

#include <vector>

namespace touchline {

struct WantedLabel {
    std::size_t part = 0;                           // the caller's number
    std::vector<PaperPoint> anchors;                // on the lines it names, or the one place
    bool is_place = false;                          // no line: it may lie upon the place
    std::vector<std::vector<BrailleCells>> shapes;  // label_shapes()
};

struct PlacedLabel {
    std::size_t part = 0;
    std::vector<BrailleRow> rows;
    std::vector<SheetStroke> leader;  // pieces, from what is named to the label; source is 0
};

struct LabelPlan {
    std::vector<PlacedLabel> placed;
    std::vector<std::size_t> without_room;  // parts
    int breaks = 0;                         // of all leaders, at lines that they cross
};

/// Dots of a label stay least_clear_mm from every line and leader, braille_label_mm from the dots
/// of another label, braille_beside_mm from one in the same rows, and within the zone. A leader is
/// straight and ends on its line, or in a dot at its place; it is broken where it crosses lines,
/// and meets no other leader. Each label takes the place with the shortest leader, where breaks,
/// nearness to lines, parts that lines close off and further rows count as a longer one. In such a
/// part lies no label whose leader crosses lines, unless the part is around what it names. `lines`
/// are as they are drawn, `shapes` as they would be without gaps. The labels are placed one after
/// the other; those that found no room, or the worst, go first in the next of four tries. At most 8
/// 000 leaders are judged at a try.
[[nodiscard]] LabelPlan placed_labels(const std::vector<WantedLabel>& wanted,
                                      const std::vector<SheetStroke>& lines,
                                      const std::vector<SheetStroke>& shapes, PaperSize page,
                                      const PaperBox& zone);

}  // namespace touchline
