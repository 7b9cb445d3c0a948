// Segments of lines: how they cross, also on the nanometre grid of a map, and, in square cells,
// what is near. Lengths in millimetres.
// Threads: values and pure functions, O(1); queries change nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// A segment of a line, with the numbers of the line and of the segment's first point.
struct LineSegment {
    cv::Point2d a;
    cv::Point2d b;
    std::size_t line = 0;
    std::size_t index = 0;
};

/// Returns the point of segment a b nearest to p.
[[nodiscard]] inline cv::Point2d nearest_on(const LineSegment& s, cv::Point2d p) {
    const cv::Point2d along = s.b - s.a;
    const double squared = along.dot(along);
    const double t = squared > 0.0 ? std::clamp((p - s.a).dot(along) / squared, 0.0, 1.0) : 0.0;
    return s.a + t * along;
}

/// Returns where two segments cross, ends included; nothing for parallel ones.
[[nodiscard]] inline std::optional<cv::Point2d> crossing_of(const LineSegment& s,
                                                            const LineSegment& t) {
    const cv::Point2d u = s.b - s.a;
    const cv::Point2d v = t.b - t.a;
    const cv::Point2d w = t.a - s.a;
    const double area = u.cross(v);
    if (area == 0.0) return std::nullopt;
    const double along_s = w.cross(v) / area;
    const double along_t = w.cross(u) / area;
    if (along_s < 0.0 || along_s > 1.0 || along_t < 0.0 || along_t > 1.0) return std::nullopt;
    return s.a + along_s * u;
}

class SegmentGrid {
  public:
    /// Cells of `cell_mm` > 0 over 0 ... size; segments outside fall into the cells at the rim.
    SegmentGrid(cv::Size2d size_mm, double cell_mm)
        : cell_mm_(cell_mm),
          columns_(1 + static_cast<int>(size_mm.width / cell_mm)),
          rows_(1 + static_cast<int>(size_mm.height / cell_mm)),
          cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

    void add(const LineSegment& segment) {
        visit_cells(segment.a, segment.b, 0.0,
                    [&](std::size_t cell) { cells_[cell].push_back(segment); });
    }

    /// Visits all segments whose cells touch the box of a and b, grown by `reach_mm`: a superset of
    /// those within reach, some more than once.
    template <class Visit>
    void near(cv::Point2d a, cv::Point2d b, double reach_mm, Visit&& visit) const {
        visit_cells(a, b, reach_mm, [&](std::size_t cell) {
            for (const LineSegment& segment : cells_[cell]) visit(segment);
        });
    }

  private:
    template <class Visit>
    void visit_cells(cv::Point2d a, cv::Point2d b, double reach_mm, Visit&& visit) const {
        const int left = column(std::min(a.x, b.x) - reach_mm);
        const int right = column(std::max(a.x, b.x) + reach_mm);
        for (int r = row(std::min(a.y, b.y) - reach_mm); r <= row(std::max(a.y, b.y) + reach_mm);
             ++r) {
            for (int c = left; c <= right; ++c) visit(static_cast<std::size_t>(r * columns_ + c));
        }
    }

    int column(double x) const {
        return std::clamp(static_cast<int>(std::floor(x / cell_mm_)), 0, columns_ - 1);
    }

    int row(double y) const {
        return std::clamp(static_cast<int>(std::floor(y / cell_mm_)), 0, rows_ - 1);
    }

    double cell_mm_;
    int columns_;
    int rows_;
    std::vector<std::vector<LineSegment>> cells_;
};

/// A point where a map will have it: on its grid of nanometres, in whole numbers.
struct GridPoint {
    std::int64_t x = 0;
    std::int64_t y = 0;
};

[[nodiscard]] inline GridPoint on_map_grid(cv::Point2d p_mm) {
    constexpr double nanometres = 1e6;  // per millimetre
    return {std::llround(nanometres * p_mm.x), std::llround(nanometres * p_mm.y)};
}

/// Returns on which side of a b the point c lies; exact within an area of a metre.
[[nodiscard]] inline int side_of(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    const std::int64_t area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return area > 0 ? 1 : area < 0 ? -1 : 0;
}

/// Returns whether two segments cross once their points are on the grid; false if they only touch.
[[nodiscard]] inline bool cross_on_map_grid(const LineSegment& s, const LineSegment& t) {
    const GridPoint a = on_map_grid(s.a);
    const GridPoint b = on_map_grid(s.b);
    const GridPoint c = on_map_grid(t.a);
    const GridPoint d = on_map_grid(t.b);
    return side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
}

}  // namespace touchline
