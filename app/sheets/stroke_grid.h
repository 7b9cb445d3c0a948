// How near the next line is, for many places of a page.
// Threads: one at a time while lines are added; then any may ask.
#pragma once

#include "app/sheets/tactile_sheet.h"

#include <limits>
#include <vector>

namespace touchline {

/// The nearest place of the lines.
struct NearStroke {
    double clear_mm = 0.0;   // to the line's edge, at most the grid's reach; negative inside it
    double centre_mm = 0.0;  // to its middle
    bool is_end = false;     // the nearest place is an end of an open line
    std::size_t source = 0;  // of the nearest stroke; meaningless beyond the reach
    std::size_t stroke = 0;  // its number in the order of adding; as meaningless
};

/// Squares as wide as the reach, so that every line within it crosses one of nine.
class StrokeGrid {
  public:
    /// `reach_mm` > 0: what lies further off is not looked for.
    StrokeGrid(PaperSize page, double reach_mm);

    /// Points beyond the page count to its rim's squares. O(points).
    void add(const SheetStroke& stroke);

    static constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();

    /// Without the strokes of source `without`. O(segments in nine squares).
    [[nodiscard]] NearStroke near(PaperPoint place, std::size_t without = nobody) const;

    /// The nearest place of every stroke whose edge is nearer than `within_mm`, at most the reach.
    /// O(segments in nine squares * strokes found).
    [[nodiscard]] std::vector<NearStroke> all_near(PaperPoint place, double within_mm) const;

  private:
    struct Segment {
        PaperPoint from;
        PaperPoint to;
        double half_mm;
        double length_mm;
        std::size_t source;
        std::size_t stroke;
        bool from_ends;
        bool to_ends;
    };

    /// Calls `visit` with every segment in the nine squares around the place.
    template <class Visit>
    void each_around(PaperPoint place, const Visit& visit) const;

    /// Most segments around a place are too far to matter, and this says so without a root or a
    /// division.
    [[nodiscard]] static bool may_be_within(const Segment& segment, PaperPoint place,
                                            double clear_mm);
    [[nodiscard]] static NearStroke nearness(const Segment& segment, PaperPoint place);
    [[nodiscard]] std::size_t column(double x_mm) const;
    [[nodiscard]] std::size_t row(double y_mm) const;
    void add(const Segment& segment);

    double reach_mm_;
    std::size_t columns_;
    std::size_t rows_;
    std::vector<std::vector<Segment>> squares_;
    std::size_t strokes_ = 0;
};

/// The distance of a point to a segment, and of two segments.
[[nodiscard]] double segment_distance_mm(PaperPoint from, PaperPoint to, PaperPoint place);
[[nodiscard]] double segments_distance_mm(PaperPoint a, PaperPoint b, PaperPoint c, PaperPoint d);

/// The distance of a segment to a box; 0 if they meet.
[[nodiscard]] double segment_distance_mm(PaperPoint from, PaperPoint to, const PaperBox& box);

/// The points of a stroke, at most `step_mm` apart; of a closed one the first comes last again.
[[nodiscard]] std::vector<PaperPoint> sampled(const SheetStroke& stroke, double step_mm);

[[nodiscard]] double length_mm(const SheetStroke& stroke);

}  // namespace touchline
