// What a hand feels of a drawing, by the kiosk's own way from the file, beside what can be seen of
// it. Threads: any, each call by itself.
#pragma once

#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "tests/app/drawings/paint.h"

#include <string>
#include <vector>

namespace touchline::testing {

/// Millimetres of line, and the share of them by what became of it.
struct Counted {
    double right_mm = 0.0;
    double wrong_mm = 0.0;
    double too_near_mm =
        0.0;  // another line lies within the detail's gap: the tactile rules choose one
    double too_short_mm = 0.0;  // the detail shows no line as short

    [[nodiscard]] double share() const {  // of what the rules leave
        return right_mm + wrong_mm > 0.0 ? right_mm / (right_mm + wrong_mm) : 1.0;
    }

    Counted& operator+=(const Counted& other);
};

struct Felt {
    Counted seen;  // of what can be seen: felt or not
    Counted felt;  // of what is felt: seen or not
    TactileMap map;
    double milliseconds = 0.0;                     // file to map
    std::vector<std::vector<cv::Point2d>> missed;  // stretches of the seen lines, for a look
};

/// The first view of the file at this detail, within `tolerance_mm` of what can be seen. Fails,
/// with one line, where the kiosk shows nothing of it.
[[nodiscard]] Result<Felt> felt_of(const Drawing& drawing, int detail, double tolerance_mm);

/// The same of a view that has at most so many pixels.
[[nodiscard]] Result<Felt> felt_of(const Drawing& drawing, int detail, double tolerance_mm,
                                   double most_pixels);

/// What is painted, what is seen (green where felt, red where not) and what is felt, beside each
/// other; 8-bit BGR.
[[nodiscard]] cv::Mat sheet_of(const Drawing& drawing, const Felt& felt);

}  // namespace touchline::testing
