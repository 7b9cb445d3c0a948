// Where a map lies on its paper.
// Threads: values and pure functions.
#pragma once

#include "app/sheets/tactile_sheet.h"
#include "config/types/extent.h"

namespace touchline {

/// From the picture frame W to the page.
struct PaperPlace {
    PaperPoint middle;   // where the origin of W lies
    double scale = 1.0;  // millimetres on paper per millimetre of the map

    [[nodiscard]] PaperPoint operator()(Position p_W) const {
        return {middle.x_mm + 1000.0 * scale * p_W.x, middle.y_mm - 1000.0 * scale * p_W.y};
    }
};

/// The largest scale, at most `most`, at which `ink` fits into a room of this size. Not positive
/// for a room without width or height.
[[nodiscard]] double fitting_scale(const Extent& ink, PaperSize room, double most);

/// The middle of `ink` in the middle of the room.
[[nodiscard]] PaperPlace middle_place(const Extent& ink, const PaperBox& room, double scale);

}  // namespace touchline
