#include "tests/haptics/curve/uniform_points.h"

#include "haptics/curve/curve_set.h"
#include "haptics/curve/segment.h"
#include "haptics/curve/spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace touchline::uniform {
namespace {

double farthest_of(std::span<const Position> data, std::span<const Position> kept) {
    double farthest = 0.0;
    for (const Position p : data) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 1; i < kept.size(); ++i) {
            nearest = std::min(nearest, foot(p, {kept[i - 1], kept[i]}).distance_m);
        }
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

std::size_t count_of(const Line& line, double spacing_m) {
    const double wanted = std::ceil(polyline_length_m(line.points) / spacing_m * (1.0 - 1e-9));
    return static_cast<std::size_t>(std::max(wanted, 1.0));
}

constexpr double finest_m = 1e-5;

double longest_m(const std::vector<Line>& lines) {
    double longest = 0.0;
    for (const Line& line : lines) longest = std::max(longest, polyline_length_m(line.points));
    return longest;
}

std::size_t total_of(const std::vector<Line>& lines, double spacing_m) {
    std::size_t total = 0;
    for (const Line& line : lines) total += count_of(line, spacing_m);
    return total;
}

}  // namespace

std::vector<Line> lines_of(const TactileMap& map) {
    std::vector<Line> lines;
    const auto pins = find_pins(map.outlines, PinRule{});
    for (std::size_t i = 0; i < pins.size(); ++i) {
        const Outline& outline = map.outlines[i];
        const std::size_t count = outline.points.size();
        std::vector<std::size_t> ends = pins[i];
        const bool is_closed = ends.empty();
        if (is_closed) ends.push_back(0);
        if (outline.is_closed) ends.push_back(ends.front() + count);
        for (std::size_t k = 1; k < ends.size(); ++k) {
            Line line{{}, is_closed};
            for (std::size_t j = ends[k - 1]; j <= ends[k]; ++j) {
                line.points.push_back(outline.points[j % count]);
            }
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

bool is_near(const std::vector<Line>& lines, double spacing_m) {
    return std::all_of(lines.begin(), lines.end(), [&](const Line& line) {
        const auto kept = resample(line.points, count_of(line, spacing_m));
        return farthest_of(line.points, kept) <= scene_tolerance_m;
    });
}

std::size_t fewest_segments(const std::vector<Line>& lines) {
    double spacing_m = longest_m(lines);
    while (spacing_m > finest_m && !is_near(lines, spacing_m)) spacing_m *= 0.995;
    return total_of(lines, spacing_m);
}

std::size_t bisected_segments(const std::vector<Line>& lines) {
    double fine = finest_m;
    double coarse = longest_m(lines);
    if (is_near(lines, coarse)) return total_of(lines, coarse);
    while (coarse > 1.0001 * fine) {
        const double middle = std::sqrt(fine * coarse);
        (is_near(lines, middle) ? fine : coarse) = middle;
    }
    return total_of(lines, fine);
}

std::size_t segments_of(const CurveSet& curves) {
    std::size_t total = 0;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        total += static_cast<std::size_t>(curves.segment_count(piece, 0));
    }
    return total;
}

double farthest_m(const std::vector<Line>& lines, const CurveSet& curves) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto points = curves.points(static_cast<int>(i), 0);
        std::vector<Position> kept(points.begin(), points.end());
        if (lines[i].is_closed) kept.push_back(kept.front());
        farthest = std::max(farthest, farthest_of(lines[i].points, kept));
    }
    return farthest;
}

}  // namespace touchline::uniform
