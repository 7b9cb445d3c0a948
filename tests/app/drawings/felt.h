// What a hand feels of a drawing, by the kiosk's own path from the file, beside what can be seen of
// it. Threads: any, each call by itself.
#pragma once

#include "app/documents/decode/page.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "tests/app/drawings/paint.h"

#include <string>
#include <string_view>
#include <vector>

namespace touchline::testing {

/// A line this near to another one is felt as that one.
inline constexpr double usual_tolerance_mm = 0.5;

/// Millimetres of line by outcome, and the share of right ones.
struct Counted {
    double right_mm = 0.0;
    double wrong_mm = 0.0;
    double too_near_mm =
        0.0;  // another line lies within the detail's gap: the tactile rules choose one
    double too_short_mm = 0.0;  // the detail shows no line as short as this
    double too_many_mm = 0.0;   // the detail shows no further lines

    [[nodiscard]] double share() const {  // of what the rules leave
        return right_mm + wrong_mm > 0.0 ? right_mm / (right_mm + wrong_mm) : 1.0;
    }

    Counted& operator+=(const Counted& other);
};

struct Felt {
    Counted seen;          // what can be seen: felt or not
    Counted felt;          // what is felt: seen or not
    double seen_mm = 0.0;  // length of all lines that can be seen
    double felt_mm = 0.0;  // length of all lines that are felt
    TactileMap map;
    double milliseconds = 0.0;                     // file to map
    std::vector<std::vector<cv::Point2d>> missed;  // stretches of seen lines that are not felt, for
                                                   // viewing
};

/// Returns the picture's own pixels: 8-bit BGR.
[[nodiscard]] cv::Mat pixels_of(Picture& picture);

/// Returns a file's whole first page, painted as finely as it is felt.
[[nodiscard]] Result<Page> whole_page(std::string_view file);

/// A whole drawing: what is painted, and what is felt of it.
struct WholeView {
    Page page;
    TactileMap map;
    double milliseconds = 0.0;  // file to map
};

/// Returns a whole drawing at this detail, with at most so many pixels. Fails with one line if the
/// kiosk shows nothing of it.
[[nodiscard]] Result<WholeView> whole_view_of(const Drawing& drawing, int detail,
                                              double most_pixels);

/// Returns an outline's points in steps of at most sample_step_mm, on the sheet.
[[nodiscard]] std::vector<cv::Point2d> in_steps(const Outline& outline);

/// Judges the whole file at this detail, within `tolerance_mm` of what can be seen. Fails with one
/// line if the kiosk shows nothing of it.
[[nodiscard]] Result<Felt> felt_of(const Drawing& drawing, int detail, double tolerance_mm);

/// Judges a view that has at most so many pixels.
[[nodiscard]] Result<Felt> felt_of(const Drawing& drawing, int detail, double tolerance_mm,
                                   double most_pixels);

/// Judges what is felt by a map of this detail against what can be seen of the drawing; measures no
/// time.
[[nodiscard]] Felt felt_by(TactileMap map, const Drawing& drawing, int detail, double tolerance_mm);

/// Draws what is painted, what is seen (green if felt, red if not) and what is felt, side by side;
/// 8-bit BGR.
[[nodiscard]] cv::Mat sheet_of(const Drawing& drawing, const Felt& felt);

}  // namespace touchline::testing
