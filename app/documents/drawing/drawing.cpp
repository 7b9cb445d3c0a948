#include "app/documents/drawing/drawing.h"

#include "app/documents/drawing/touch_lines.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace touchline {
namespace {

using Refused = tl::unexpected<DrawingRefusal>;

double length_m(std::span<const Position> points) {
    double sum_m = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) sum_m += norm(points[i] - points[i - 1]);
    return sum_m;
}

/// The way of a pen; places that are not finite are none.
double way_m(std::span<const Position> stroke_W) {
    double sum_m = 0.0;
    const Position* last = nullptr;
    for (const Position& p : stroke_W) {
        if (!is_finite(p)) continue;
        if (last != nullptr) sum_m += norm(p - *last);
        last = &p;
    }
    return sum_m;
}

double length_m(const DrawnLine& line) {
    double sum_m = 0.0;
    for (const Outline& outline : line.outlines) {
        sum_m += length_m(outline.points);
        if (outline.is_closed) sum_m += norm(outline.points.front() - outline.points.back());
    }
    return sum_m;
}

double length_m(const std::vector<DrawnLinePtr>& lines) {
    double sum_m = 0.0;
    for (const DrawnLinePtr& line : lines) sum_m += length_m(*line);
    return sum_m;
}

std::vector<Outline> outlines_of(const std::vector<DrawnLinePtr>& lines) {
    std::vector<Outline> outlines;
    for (const DrawnLinePtr& line : lines)
        outlines.insert(outlines.end(), line->outlines.begin(), line->outlines.end());
    return outlines;
}

/// The vertices are too close together for the stretch between two of them to be any nearer.
double distance_m(const DrawnLine& line, Position place) {
    double least_m = std::numeric_limits<double>::infinity();
    for (const Outline& outline : line.outlines)
        for (const Position& p : outline.points) least_m = std::min(least_m, norm(p - place));
    return least_m;
}

bool has(const std::vector<DrawnLinePtr>& lines, const DrawnLinePtr& line) {
    return std::ranges::find(lines, line) != lines.end();
}

/// The first of `lines` that the others lack; null: none.
DrawnLinePtr lacking(const std::vector<DrawnLinePtr>& others,
                     const std::vector<DrawnLinePtr>& lines) {
    const auto found = std::ranges::find_if(
        lines, [&others](const DrawnLinePtr& line) { return !has(others, line); });
    return found == lines.end() ? nullptr : *found;
}

}  // namespace

Drawing Drawing::with(Lines lines) const {
    Drawing next = *this;
    next.steps_.resize(next.now_ + 1);
    next.steps_.push_back(std::move(lines));
    if (next.steps_.size() > most_undos + 1) next.steps_.erase(next.steps_.begin());
    next.now_ = next.steps_.size() - 1;
    return next;
}

Drawing::Or<Drawing> Drawing::with_stroke(std::span<const Position> stroke_W) const {
    if (stroke_W.size() > most_stroke_points || !(way_m(stroke_W) <= most_way_m))
        return Refused(DrawingRefusal::too_long);
    if (lines().size() >= most_lines) return Refused(DrawingRefusal::full);
    DrawnLine line;
    line.number = last_number_ + 1;
    auto outlines = touch_lines(stroke_W, outlines_of(lines()), area_);
    if (!outlines) return Refused(DrawingRefusal::scribbled);
    line.outlines = std::move(*outlines);
    if (line.outlines.empty()) return Refused(DrawingRefusal::too_short);
    const double line_m = length_m(line);
    if (!(line_m <= most_stroke_m)) return Refused(DrawingRefusal::too_long);
    if (!(length_m(lines()) + line_m <= most_drawn_m)) return Refused(DrawingRefusal::full);
    Lines lines_then = lines();
    lines_then.push_back(std::make_shared<const DrawnLine>(std::move(line)));
    Drawing next = with(std::move(lines_then));
    ++next.last_number_;
    return next;
}

Drawing::Or<Drawing> Drawing::without_line_near(Position place_W, double reach_m) const {
    const auto nearest = std::ranges::min_element(
        lines(), {}, [&](const DrawnLinePtr& line) { return distance_m(*line, place_W); });
    if (nearest == lines().end() || !(distance_m(**nearest, place_W) <= reach_m))
        return Refused(DrawingRefusal::nothing_near);
    Lines next = lines();
    std::erase(next, *nearest);
    return with(std::move(next));
}

Drawing::Or<Drawing> Drawing::undone() const {
    if (!can_undo()) return Refused(DrawingRefusal::nothing_to_undo);
    Drawing before = *this;
    --before.now_;
    return before;
}

Drawing::Or<Drawing> Drawing::redone() const {
    if (!can_redo()) return Refused(DrawingRefusal::nothing_to_redo);
    Drawing after = *this;
    ++after.now_;
    return after;
}

std::optional<LineChange> change_between(const Drawing& before, const Drawing& after) {
    if (const DrawnLinePtr added = lacking(before.lines(), after.lines()))
        return LineChange{added->number, true};
    if (const DrawnLinePtr gone = lacking(after.lines(), before.lines()))
        return LineChange{gone->number, false};
    return std::nullopt;
}

TactileMap map_of(const Drawing& drawing, std::string title,
                  const std::function<std::string(int number)>& name_of) {
    TactileMap map;
    map.area = drawing.area();
    map.title = std::move(title);
    map.drawing = drawing.id();
    for (const DrawnLinePtr& line : drawing.lines()) {
        const std::string id = "line-" + std::to_string(line->number);
        for (std::size_t i = 0; i < line->outlines.size(); ++i) {
            Outline outline = line->outlines[i];
            outline.id = i == 0 ? id : id + '-' + std::to_string(i + 1);
            outline.label = name_of(line->number);
            map.outlines.push_back(std::move(outline));
        }
    }
    return map;
}

}  // namespace touchline
