// Keeps lines apart, from one another and from themselves: lines already there stay, and later ones
// give way. Lengths in millimetres.
// Threads: pure functions; one object, one thread; queries change nothing.
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

/// A line that may be shown, or what is left of one. `goes_on`: there was more beyond that end.
struct Candidate {
    Chain line;
    bool front_goes_on = false;
    bool back_goes_on = false;
};

/// Where an end meets a line that is already there (or an earlier part of its own line).
struct LineFoot {
    cv::Point2d at;
    std::size_t line = 0;
    std::size_t index = 0;  // of the segment that it lies on
};

/// The longest part of a candidate that keeps its distance.
struct Fit {
    Chain line;                     // with its bridges to the feet
    std::optional<LineFoot> front;  // set: that end meets a line
    std::optional<LineFoot> back;
    int crossings_opened = 0;
    std::vector<Candidate> rest;  // before and after it; fit them again once this one is added
};

class SpacedLines {
  public:
    /// The lines' points are at most `step_mm` apart; gap_mm > step_mm.
    SpacedLines(cv::Size2d area_mm, double gap_mm, double step_mm);

    /// Returns the longest stretch of the line with at least a gap to every line added and to
    /// itself where more than four gaps lie between along it (two if it leads back beside itself);
    /// nothing if there is none. Rings beside one another, none within another, need only 3.2 mm.
    /// Where a line was cut, its end runs straight on to the nearest point of the line in the way
    /// and meets it there. But a line that crosses the other stops 2.5 mm short, so that the
    /// crossing is open over 5 mm, and one that ends by itself further than 4 mm from the other
    /// stays a gap away. The bridges lie within a gap of the foot and cross nothing: no line is
    /// nearer to any of their points. If the line in the way leads back along itself, a map's grid
    /// may move a foot on one strand beyond the other; then the end stops a micrometre short of it.
    /// O(points x points near).
    [[nodiscard]] std::optional<Fit> fit(const Candidate& candidate) const;

    void add(Fit fit);

    /// Lines added from here on keep this gap.
    void set_gap(double gap_mm) { scale_.gap_mm = gap_mm; }

    /// Returns whether a line comes nearer than `reach_mm` to a place.
    [[nodiscard]] bool has_near(cv::Point2d p, double reach_mm) const {
        return nearest(p, reach_mm).has_value();
    }

    [[nodiscard]] const SpacingScale& scale() const { return scale_; }

    /// Returns the lines in the order of adding; a foot is a fixed point of both lines, bit for
    /// bit.
    [[nodiscard]] std::vector<Chain> lines() const;

  private:
    struct Near {
        double distance_mm = 0.0;
        LineFoot foot;
    };

    [[nodiscard]] std::optional<Near> nearest(cv::Point2d p, double reach_mm) const;
    [[nodiscard]] bool stands_beside(const Chain& ring) const;
    [[nodiscard]] std::optional<Candidate> opened(const Chain& ring) const;
    [[nodiscard]] std::optional<OwnStretch> longest(const std::vector<EdgePoint>& points) const;
    [[nodiscard]] bool crosses_on(const std::vector<EdgePoint>& points, std::size_t from,
                                  int step) const;
    bool append(cv::Point2d to, std::vector<EdgePoint>& line) const;
    [[nodiscard]] std::vector<LineSegment> pieces(const LineSegment& segment, const Fit& fit) const;
    [[nodiscard]] bool crosses_in_map(const Fit& fit) const;
    void meet(const LineFoot& foot, cv::Point2d from, int step, Fit& fit) const;
    void bridge(const std::vector<EdgePoint>& points, std::size_t at, int step, bool goes_on,
                Fit& fit) const;

    SpacingScale scale_;
    SegmentGrid grid_;
    std::vector<Chain> lines_;
    std::vector<std::vector<LineFoot>> feet_;  // on each line
};

}  // namespace touchline
