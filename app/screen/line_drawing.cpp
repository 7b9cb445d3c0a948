#include "app/screen/line_drawing.h"

#include "app/screen/paint.h"

namespace touchline {
namespace {

std::vector<Position> points_of(const Outline& outline) {
    std::vector<Position> points = outline.points;
    if (outline.is_closed && !points.empty()) points.push_back(points.front());
    return points;
}

double length_of(const std::vector<Position>& points) {
    double length_m = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) length_m += norm(points[i] - points[i - 1]);
    return length_m;
}

/// Both ends, and of the points between them those that lie `step_m` from the last one kept.
std::vector<Position> thinned(const std::vector<Position>& points, double step_m) {
    std::vector<Position> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool is_end = i == 0 || i + 1 == points.size();
        if (is_end || norm(points[i] - kept.back()) >= step_m) kept.push_back(points[i]);
    }
    return kept;
}

}  // namespace

LineDrawing line_drawing(const TactileMap& map) {
    constexpr double most_points = 300.0;
    LineDrawing picture{map.area, {}};
    double length_m = 0.0;
    for (const Outline& outline : map.outlines) {
        picture.lines.push_back(points_of(outline));
        length_m += length_of(picture.lines.back());
    }
    for (std::vector<Position>& line : picture.lines) line = thinned(line, length_m / most_points);
    return picture;
}

void paint_line_drawing(cairo_t* cr, const Rect& rect, const LineDrawing& picture, double width_px,
                        Colour colour) {
    const View view = view_of(picture.area, rect);
    for (const std::vector<Position>& line : picture.lines)
        paint_path(cr, view, line, width_px, {colour});
}

}  // namespace touchline
