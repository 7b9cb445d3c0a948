#include "vision/simplify/zoom.h"

#include <cmath>
#include <string>
#include <utility>

namespace touchline {
namespace {

constexpr double least_part_mm = 1.0;

/// Converts millimetres of the whole picture to millimetres of the enlargement.
class Enlargement {
  public:
    Enlargement(const Area& area, const Zoom& zoom)
        : size_mm_(1000.0 * area.width_m, 1000.0 * area.height_m),
          centre_mm_(0.5 * size_mm_.width + 1000.0 * zoom.centre.x,
                     0.5 * size_mm_.height - 1000.0 * zoom.centre.y),
          factor_(zoom.factor) {}

    cv::Point2d operator()(cv::Point2d p) const {
        if (factor_ == 1.0) return p;
        return (p - centre_mm_) * factor_ +
               cv::Point2d(0.5 * size_mm_.width, 0.5 * size_mm_.height);
    }

    cv::Size2d size_mm() const { return size_mm_; }

  private:
    cv::Size2d size_mm_;
    cv::Point2d centre_mm_;
    double factor_;
};

bool is_inside(cv::Point2d p, cv::Size2d size) {
    return p.x >= 0.0 && p.y >= 0.0 && p.x <= size.width && p.y <= size.height;
}

/// Returns the part of a segment inside the rectangle 0 ... size, as shares of it (Liang and Barsky
/// 1984). Empty: first > second.
std::pair<double, double> inside_part(cv::Point2d a, cv::Point2d b, cv::Size2d size) {
    double from = 0.0;
    double to = 1.0;
    const auto cut = [&](double step, double room) {  // step x t <= room
        if (step > 0.0) {
            to = std::min(to, room / step);
        } else if (step < 0.0) {
            from = std::max(from, room / step);
        } else if (room < 0.0) {
            from = 2.0;
        }
    };
    const cv::Point2d d = b - a;
    cut(-d.x, a.x);
    cut(d.x, size.width - a.x);
    cut(-d.y, a.y);
    cut(d.y, size.height - a.y);
    return {from, to};
}

void clip(const Chain& line, cv::Size2d size, std::vector<Chain>& parts) {
    std::vector<EdgePoint> points = line.points;
    if (line.is_closed) {  // begin outside, so that no part is cut in two
        std::ranges::rotate(points, std::ranges::find_if(points, [&](const EdgePoint& p) {
                                return !is_inside(p.at, size);
                            }));
        points.push_back(points.front());
    }
    Chain part{{}, false, line.width_px, line.of};
    const auto finish = [&] {
        if (part.points.size() > 1) parts.push_back(part);
        part.points.clear();
    };
    for (std::size_t i = 1; i < points.size(); ++i) {
        const EdgePoint& a = points[i - 1];
        const EdgePoint& b = points[i];
        const auto [from, to] = inside_part(a.at, b.at, size);
        if (from > to) {
            finish();
            continue;
        }
        if (part.points.empty()) {
            part.points.push_back(
                from > 0.0 ? EdgePoint{a.at + from * (b.at - a.at), a.strength, true} : a);
        }
        part.points.push_back(to < 1.0 ? EdgePoint{a.at + to * (b.at - a.at), b.strength, true}
                                       : b);
        if (to < 1.0) finish();
    }
    finish();
}

std::vector<Chain> clipped(const Chain& line, cv::Size2d size) {
    std::vector<Chain> parts;
    const bool is_whole =
        std::ranges::all_of(line.points, [&](const EdgePoint& p) { return is_inside(p.at, size); });
    if (is_whole)
        parts.push_back(line);
    else
        clip(line, size, parts);
    return parts;
}

Chain in_mm(const Outline& outline, const Area& area, const Enlargement& enlargement) {
    Chain line;
    line.is_closed = outline.is_closed;
    for (const Position& p : outline.points) {
        const ViewBoxPoint at = to_view_box(p, view_box_of(area));
        line.points.push_back({enlargement({at.u_mm, at.v_mm}), 1.0, false});
    }
    return line;
}

void add_enlarged(const Outline& outline, const Area& area, const Zoom& zoom, TactileMap& map) {
    const Enlargement enlargement(area, zoom);
    int number = 0;
    for (const Chain& part : clipped(in_mm(outline, area, enlargement), enlargement.size_mm())) {
        if (length_of({part.points, false}) < least_part_mm) continue;
        Outline shown = outline;
        shown.is_closed = part.is_closed;
        shown.points.clear();
        for (const EdgePoint& p : part.points)
            shown.points.push_back(canonical_point(p.at.x, p.at.y, area));
        if (++number > 1 && !shown.id.empty()) shown.id += "-" + std::to_string(number);
        map.outlines.push_back(std::move(shown));
    }
}

}  // namespace

Chain within(Chain line, cv::Size2d area_mm) {
    constexpr double half_nanometre_mm = 5e-7;  // less is on the rim in a map
    const auto inside = [](double at_mm, double most_mm) {
        const double within_mm = std::clamp(at_mm, 0.0, most_mm);
        return std::abs(at_mm - within_mm) < half_nanometre_mm ? at_mm : within_mm;
    };
    for (EdgePoint& p : line.points) {
        p.at = {inside(p.at.x, area_mm.width), inside(p.at.y, area_mm.height)};
    }
    return line;
}

std::vector<Chain> in_zoom(const std::vector<Chain>& lines, const Placement& placement,
                           const Area& area, const Zoom& zoom) {
    const Enlargement enlarged(area, zoom);
    std::vector<Chain> result;
    for (const Chain& line : lines) {
        Chain mm = line;
        mm.width_px *= 1000.0 * placement.metres_per_working_pixel() * zoom.factor;
        for (EdgePoint& p : mm.points) p.at = enlarged(placement.in_mm(p.at));
        if (zoom.factor == 1.0) {
            result.push_back(within(std::move(mm), enlarged.size_mm()));
            continue;
        }
        for (Chain& part : clipped(mm, enlarged.size_mm())) result.push_back(std::move(part));
    }
    return result;
}

cv::Rect2d picture_in_zoom(const Placement& placement, cv::Size working, const Area& area,
                           const Zoom& zoom) {
    const Enlargement enlarged(area, zoom);
    return {enlarged(placement.in_mm({-0.5, -0.5})),
            enlarged(placement.in_mm({working.width - 0.5, working.height - 0.5}))};
}

std::vector<Label> enlarged(const std::vector<Label>& labels, const Area& area, const Zoom& zoom) {
    std::vector<Label> shown;
    for (const Label& label : labels) {
        const Position place = zoom.factor * (label.place - zoom.centre);
        const bool is_shown =
            2.0 * std::abs(place.x) <= area.width_m && 2.0 * std::abs(place.y) <= area.height_m;
        if (is_shown) shown.push_back({label.text, place});
    }
    return shown;
}

TactileMap enlarged(const TactileMap& map, const Zoom& zoom) {
    if (zoom.factor == 1.0) return map;
    TactileMap result = map;
    result.outlines.clear();
    for (const Outline& outline : map.outlines) add_enlarged(outline, map.area, zoom, result);
    result.labels = enlarged(map.labels, map.area, zoom);
    return result;
}

}  // namespace touchline
