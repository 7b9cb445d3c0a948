// Maps for the tests of sheets, and what must hold of two strokes.
// Threads: values and pure functions.
#pragma once

#include "app/sheets/tactile_sheet.h"
#include "config/types/tactile_map.h"

#include <string>
#include <utility>
#include <vector>

namespace touchline {

/// A line through these places, in millimetres of W.
[[nodiscard]] Outline line_through(const std::vector<std::pair<double, double>>& places_mm,
                                   int detail = 1, const std::string& label = {});

[[nodiscard]] Outline ring_through(const std::vector<std::pair<double, double>>& places_mm,
                                   int detail = 1, const std::string& label = {});

/// The map of lines in the usual area.
[[nodiscard]] TactileMap map_of_lines(std::vector<Outline> outlines,
                                      const std::string& title = "Lines");

/// The way across between two boxes; 0 if they meet.
[[nodiscard]] double gap_mm(const PaperBox& a, const PaperBox& b);

/// Every place of `a` that is nearer to `b` than the rule allows and not within `reach_mm` of a
/// place where both meet. Tries all places against all; knows nothing of how the lines were made.
[[nodiscard]] std::vector<PaperPoint> too_near(const SheetStroke& a, const SheetStroke& b,
                                               double clear_mm, double reach_mm);

}  // namespace touchline
