#include "app/sheets/stroke_grid.h"

#include <array>

namespace touchline {
namespace {

/// The share of the way at which the segment is nearest to the place.
double nearest_share(PaperPoint from, PaperPoint to, PaperPoint place) {
    const double x = to.x_mm - from.x_mm;
    const double y = to.y_mm - from.y_mm;
    const double square = x * x + y * y;
    if (square <= 0.0) return 0.0;
    const double share = ((place.x_mm - from.x_mm) * x + (place.y_mm - from.y_mm) * y) / square;
    return std::clamp(share, 0.0, 1.0);
}

/// Twice the area of a, b, c; its sign is the side on which c lies.
double turn(PaperPoint a, PaperPoint b, PaperPoint c) {
    return (b.x_mm - a.x_mm) * (c.y_mm - a.y_mm) - (b.y_mm - a.y_mm) * (c.x_mm - a.x_mm);
}

bool do_cross(PaperPoint a, PaperPoint b, PaperPoint c, PaperPoint d) {
    return turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0;
}

}  // namespace

PaperBox box_of(const BrailleBlock& block) {
    const double half_mm = braille_dot_mm / 2.0;
    const PaperPoint first = block.rows.front().first_dot;
    PaperBox box{first.x_mm, first.y_mm, first.x_mm, first.y_mm};
    for (const BrailleRow& row : block.rows) {
        const PaperPoint last = dot_place(row, std::max<std::size_t>(row.cells.size(), 1) - 1, 5);
        box.left_mm = std::min(box.left_mm, row.first_dot.x_mm);
        box.top_mm = std::min(box.top_mm, row.first_dot.y_mm);
        box.right_mm = std::max(box.right_mm, last.x_mm);
        box.bottom_mm = std::max(box.bottom_mm, last.y_mm);
    }
    return grown(box, half_mm);
}

double segment_distance_mm(PaperPoint from, PaperPoint to, PaperPoint place) {
    return distance_mm(between(from, to, nearest_share(from, to, place)), place);
}

double segments_distance_mm(PaperPoint a, PaperPoint b, PaperPoint c, PaperPoint d) {
    if (do_cross(a, b, c, d)) return 0.0;
    return std::min({segment_distance_mm(a, b, c), segment_distance_mm(a, b, d),
                     segment_distance_mm(c, d, a), segment_distance_mm(c, d, b)});
}

double segment_distance_mm(PaperPoint from, PaperPoint to, const PaperBox& box) {
    if (distance_mm(box, from) <= 0.0) return 0.0;
    const std::array<PaperPoint, 4> corners{PaperPoint{box.left_mm, box.top_mm},
                                            {box.right_mm, box.top_mm},
                                            {box.right_mm, box.bottom_mm},
                                            {box.left_mm, box.bottom_mm}};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners.size(); ++i)
        least = std::min(least, segments_distance_mm(from, to, corners[i], corners[(i + 1) % 4]));
    return least;
}

std::vector<PaperPoint> sampled(const SheetStroke& stroke, double step_mm) {
    std::vector<PaperPoint> points;
    const std::size_t n = stroke.points.size();
    for (std::size_t i = 0; i + (stroke.is_closed ? 0 : 1) < n; ++i) {
        const PaperPoint from = stroke.points[i];
        const PaperPoint to = stroke.points[(i + 1) % n];
        const int parts = std::max(1, static_cast<int>(std::ceil(distance_mm(from, to) / step_mm)));
        for (int k = 0; k < parts; ++k)
            points.push_back(between(from, to, static_cast<double>(k) / parts));
    }
    if (n > 0) points.push_back(stroke.is_closed ? stroke.points.front() : stroke.points.back());
    return points;
}

double length_mm(const SheetStroke& stroke) {
    double sum = 0.0;
    const std::size_t n = stroke.points.size();
    for (std::size_t i = 0; i + (stroke.is_closed ? 0 : 1) < n; ++i)
        sum += distance_mm(stroke.points[i], stroke.points[(i + 1) % n]);
    return sum;
}

StrokeGrid::StrokeGrid(PaperSize page, double reach_mm)
    : reach_mm_(reach_mm),
      columns_(1 + static_cast<std::size_t>(page.width_mm / reach_mm)),
      rows_(1 + static_cast<std::size_t>(page.height_mm / reach_mm)),
      squares_(columns_ * rows_) {}

std::size_t StrokeGrid::column(double x_mm) const {
    return static_cast<std::size_t>(
        std::clamp(x_mm / reach_mm_, 0.0, static_cast<double>(columns_ - 1)));
}

std::size_t StrokeGrid::row(double y_mm) const {
    return static_cast<std::size_t>(
        std::clamp(y_mm / reach_mm_, 0.0, static_cast<double>(rows_ - 1)));
}

void StrokeGrid::add(const Segment& segment) {
    const auto [left, right] = std::minmax({column(segment.from.x_mm), column(segment.to.x_mm)});
    const auto [top, bottom] = std::minmax({row(segment.from.y_mm), row(segment.to.y_mm)});
    for (std::size_t y = top; y <= bottom; ++y)
        for (std::size_t x = left; x <= right; ++x) squares_[y * columns_ + x].push_back(segment);
}

void StrokeGrid::add(const SheetStroke& stroke) {
    // Short pieces, so that a long segment does not fill the squares of its whole box.
    const std::vector<PaperPoint> points = sampled(stroke, reach_mm_);
    const double half_mm = stroke.width_mm / 2.0;
    if (points.size() == 1) {
        add({points[0], points[0], half_mm, 0.0, stroke.source, strokes_, true, true});
    } else {
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            add({points[i], points[i + 1], half_mm, distance_mm(points[i], points[i + 1]),
                 stroke.source, strokes_, !stroke.is_closed && i == 0,
                 !stroke.is_closed && i + 2 == points.size()});
    }
    ++strokes_;
}

template <class Visit>
void StrokeGrid::each_around(PaperPoint place, const Visit& visit) const {
    const std::size_t x = column(place.x_mm);
    const std::size_t y = row(place.y_mm);
    for (std::size_t v = y - (y > 0 ? 1 : 0); v <= std::min(y + 1, rows_ - 1); ++v)
        for (std::size_t u = x - (x > 0 ? 1 : 0); u <= std::min(x + 1, columns_ - 1); ++u)
            for (const Segment& segment : squares_[v * columns_ + u]) visit(segment);
}

bool StrokeGrid::may_be_within(const Segment& segment, PaperPoint place, double clear_mm) {
    const double x = segment.from.x_mm - place.x_mm;
    const double y = segment.from.y_mm - place.y_mm;
    const double far = clear_mm + segment.half_mm + segment.length_mm;
    return far >= 0.0 && x * x + y * y <= far * far;
}

NearStroke StrokeGrid::nearness(const Segment& segment, PaperPoint place) {
    const double share = nearest_share(segment.from, segment.to, place);
    const double centre = distance_mm(between(segment.from, segment.to, share), place);
    return {centre - segment.half_mm, centre,
            (share <= 0.0 && segment.from_ends) || (share >= 1.0 && segment.to_ends),
            segment.source, segment.stroke};
}

NearStroke StrokeGrid::near(PaperPoint place, std::size_t without) const {
    NearStroke found{reach_mm_, reach_mm_, false, 0, 0};
    each_around(place, [&](const Segment& segment) {
        if (segment.source == without) return;
        if (!may_be_within(segment, place, found.clear_mm)) return;
        const NearStroke other = nearness(segment, place);
        if (other.clear_mm < found.clear_mm) found = other;
    });
    return found;
}

std::vector<NearStroke> StrokeGrid::all_near(PaperPoint place, double within_mm) const {
    std::vector<NearStroke> found;
    each_around(place, [&](const Segment& segment) {
        if (!may_be_within(segment, place, within_mm)) return;
        const NearStroke other = nearness(segment, place);
        if (!(other.clear_mm < std::min(within_mm, reach_mm_))) return;
        const auto known = std::ranges::find(found, other.stroke, &NearStroke::stroke);
        if (known == found.end()) {
            found.push_back(other);
        } else if (other.clear_mm < known->clear_mm) {
            *known = other;
        }
    });
    return found;
}

}  // namespace touchline
