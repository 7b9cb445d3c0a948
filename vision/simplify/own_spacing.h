// Measures how near a line comes to itself. Lengths in millimetres.
// Threads: pure functions.
#pragma once

#include "vision/contour/chain.h"
#include "vision/simplify/segment_grid.h"

#include <optional>
#include <vector>

namespace touchline {

struct SpacingScale {
    cv::Size2d area_mm;
    double gap_mm = 0.0;
    double step_mm = 0.0;  // between points, at most

    /// The clearance of the points, so that the line between them keeps the gap too.
    [[nodiscard]] double clearance_mm() const { return gap_mm + 0.5 * step_mm; }
};

/// Returns the number of segments, including the closing one of a ring.
[[nodiscard]] std::size_t segments_of(const Chain& line);

[[nodiscard]] LineSegment segment_of(const Chain& line, std::size_t i, std::size_t number);

/// The points first ... last of a line, which are clear of one another.
struct OwnStretch {
    struct Foot {
        cv::Point2d at;
        std::size_t index = 0;  // of the segment
    };

    std::size_t first = 0;
    std::size_t last = 0;
    double length_mm = 0.0;
    std::optional<Foot> foot;  // earlier place that stops it from going on
};

/// Returns the stretch from point `first` to at most `last` that keeps the gap to itself where more
/// than four gaps lie between along it, or two if it leads back beside itself (within 10 degrees).
/// The two straight sides of a corner may come as near as they do: whatever its angle, it is one
/// corner. O(points x points near).
[[nodiscard]] OwnStretch clear_of_itself(const std::vector<EdgePoint>& points, std::size_t first,
                                         std::size_t last, const SpacingScale& scale);

/// Returns the first point of a ring that is too near to another part of it, by the same rule.
[[nodiscard]] std::optional<std::size_t> too_near_itself(const Chain& ring,
                                                         const SpacingScale& scale);

}  // namespace touchline
