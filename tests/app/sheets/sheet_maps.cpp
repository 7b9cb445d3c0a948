#include "tests/app/sheets/sheet_maps.h"

#include "app/sheets/stroke_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline {

Outline line_through(const std::vector<std::pair<double, double>>& places_mm, int detail,
                     const std::string& label) {
    Outline outline;
    for (const auto& [x, y] : places_mm) outline.points.push_back({x / 1000.0, y / 1000.0});
    outline.detail = detail;
    outline.label = label;
    return outline;
}

Outline ring_through(const std::vector<std::pair<double, double>>& places_mm, int detail,
                     const std::string& label) {
    Outline outline = line_through(places_mm, detail, label);
    outline.is_closed = true;
    return outline;
}

TactileMap map_of_lines(std::vector<Outline> outlines, const std::string& title) {
    TactileMap map;
    map.outlines = std::move(outlines);
    map.title = title;
    return map;
}

double gap_mm(const PaperBox& a, const PaperBox& b) {
    return std::hypot(std::max({a.left_mm - b.right_mm, b.left_mm - a.right_mm, 0.0}),
                      std::max({a.top_mm - b.bottom_mm, b.top_mm - a.bottom_mm, 0.0}));
}

std::vector<PaperPoint> too_near(const SheetStroke& a, const SheetStroke& b, double clear_mm,
                                 double reach_mm) {
    constexpr double step_mm = 0.5;
    constexpr double meeting_mm = 0.6;
    const std::vector<PaperPoint> of_a = sampled(a, step_mm);
    const std::vector<PaperPoint> of_b = sampled(b, step_mm);
    const double least_mm = clear_mm + (a.width_mm + b.width_mm) / 2.0;
    std::vector<PaperPoint> near;
    std::vector<PaperPoint> meetings;
    for (const PaperPoint& p : of_a) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i + 1 < of_b.size(); ++i)
            least = std::min(least, segment_distance_mm(of_b[i], of_b[i + 1], p));
        if (of_b.size() == 1) least = distance_mm(of_b[0], p);
        if (least < meeting_mm) meetings.push_back(p);
        if (least < least_mm) near.push_back(p);
    }
    std::erase_if(near, [&](const PaperPoint& p) {
        return std::ranges::any_of(meetings, [&](const PaperPoint& meeting) {
            return distance_mm(p, meeting) < reach_mm;
        });
    });
    return near;
}

}  // namespace touchline
