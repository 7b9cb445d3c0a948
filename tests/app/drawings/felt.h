// What a hand feels of a drawing, by the kiosk's own way from the file, beside what can be seen of
// it. Threads: any, each call by itself.
#pragma once

#include "app/decode/page.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "tests/app/drawings/paint.h"

#include <string>
#include <string_view>
#include <vector>

namespace touchline::testing {

/// A line as near as this to another is felt as that one.
inline constexpr double kTolerance_mm = 0.5;

/// Millimetres of line, and the share of them by what became of it.
struct Counted {
    double right_mm = 0.0;
    double wrong_mm = 0.0;
    double too_near_mm =
        0.0;  // another line lies within the detail's gap: the tactile rules choose one
    double too_short_mm = 0.0;  // the detail shows no line as short
    double too_many_mm = 0.0;   // the detail shows no more lines than those that are felt

    [[nodiscard]] double share() const {  // of what the rules leave
        return right_mm + wrong_mm > 0.0 ? right_mm / (right_mm + wrong_mm) : 1.0;
    }

    Counted& operator+=(const Counted& other);
};

struct Felt {
    Counted seen;          // of what can be seen: felt or not
    Counted felt;          // of what is felt: seen or not
    double seen_mm = 0.0;  // length of all lines that can be seen
    double felt_mm = 0.0;  // and of all that are felt
    TactileMap map;
    double milliseconds = 0.0;                     // file to map
    std::vector<std::vector<cv::Point2d>> missed;  // stretches of the seen lines, for a look
};

/// The picture's own pixels: 8-bit BGR.
[[nodiscard]] cv::Mat pixels_of(Picture& picture);

/// All of a file's first page, painted as finely as it is felt.
[[nodiscard]] Result<Page> whole_page(std::string_view file);

/// The whole of a drawing: what is painted, and what is felt of it.
struct WholeView {
    Page page;
    TactileMap map;
    double milliseconds = 0.0;  // file to map
};

/// The whole of a drawing at this detail, of at most so many pixels. Fails, with one line, where
/// the kiosk shows nothing of it.
[[nodiscard]] Result<WholeView> whole_view_of(const Drawing& drawing, int detail,
                                              double most_pixels);

/// Points of an outline in steps of at most kStep_mm, on the sheet.
[[nodiscard]] std::vector<cv::Point2d> in_steps(const Outline& outline);

/// The whole of the file at this detail, within `tolerance_mm` of what can be seen. Fails,
/// with one line, where the kiosk shows nothing of it.
[[nodiscard]] Result<Felt> felt_of(const Drawing& drawing, int detail, double tolerance_mm);

/// The same of a view that has at most so many pixels.
[[nodiscard]] Result<Felt> felt_of(const Drawing& drawing, int detail, double tolerance_mm,
                                   double most_pixels);

/// What is felt by a map of that detail, beside what can be seen of the drawing; no milliseconds.
[[nodiscard]] Felt felt_by(TactileMap map, const Drawing& drawing, int detail, double tolerance_mm);

/// What is painted, what is seen (green where felt, red where not) and what is felt, beside each
/// other; 8-bit BGR.
[[nodiscard]] cv::Mat sheet_of(const Drawing& drawing, const Felt& felt);

}  // namespace touchline::testing
