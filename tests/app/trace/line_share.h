// How much of some lines lies along others, as a hand would have it. Millimetres from the upper
// left corner of the drawing area. Threads: values and pure functions.
#pragma once

#include "config/types/tactile_map.h"
#include "tests/app/trace/page_figures.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace touchline::testing {

inline constexpr double near_mm = 0.5;
inline constexpr double step_mm = 0.1;

inline double length_mm(const std::vector<PagePoint>& line) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        sum += std::hypot(line[i + 1].x - line[i].x, line[i + 1].y - line[i].y);
    return sum;
}

/// A point of a line, and the length that it stands for.
struct Sample {
    PagePoint at;
    double long_mm = 0.0;
};

inline std::vector<Sample> samples_of(const std::vector<PagePoint>& line) {
    std::vector<Sample> samples;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double long_mm = std::hypot(line[i + 1].x - line[i].x, line[i + 1].y - line[i].y);
        const int steps = std::max(1, static_cast<int>(std::ceil(long_mm / step_mm)));
        for (int k = 0; k < steps; ++k) {
            const double part = (k + 0.5) / steps;
            samples.push_back({{std::lerp(line[i].x, line[i + 1].x, part),
                                std::lerp(line[i].y, line[i + 1].y, part)},
                               long_mm / steps});
        }
    }
    return samples;
}

/// Points along lines, millimetres under the hand, found by where they are.
class Nearby {
  public:
    void add(const std::vector<Sample>& samples) {
        for (const auto& [p, length] : samples) cells_[key(cell(p.x), cell(p.y))].push_back(p);
    }

    [[nodiscard]] bool has_near(const PagePoint& p) const {
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y) {
                const auto found = cells_.find(key(cell(p.x) + x, cell(p.y) + y));
                if (found == cells_.end()) continue;
                for (const PagePoint& q : found->second)
                    if (std::hypot(p.x - q.x, p.y - q.y) <= near_mm) return true;
            }
        return false;
    }

  private:
    static int cell(double value) { return static_cast<int>(std::floor(value / near_mm)); }

    static int key(int x, int y) { return 10'000 * x + y; }

    std::unordered_map<int, std::vector<PagePoint>> cells_;
};

/// Millimetres from the upper left corner of the area.
inline std::vector<PagePoint> felt_line(const Outline& outline, const Area& area) {
    std::vector<PagePoint> line;
    for (const Position p : outline.points)
        line.push_back({1e3 * (p.x + area.width_m / 2.0), 1e3 * (area.height_m / 2.0 - p.y)});
    if (outline.is_closed && !line.empty()) line.push_back(line.front());
    return line;
}

struct Share {
    double part_mm = 0.0;
    double all_mm = 0.0;

    [[nodiscard]] double value() const { return all_mm > 0.0 ? part_mm / all_mm : 1.0; }

    void add(const std::vector<Sample>& samples, const Nearby& others) {
        for (const auto& [p, length] : samples) {
            all_mm += length;
            if (others.has_near(p)) part_mm += length;
        }
    }

    void add(const Share& other) {
        part_mm += other.part_mm;
        all_mm += other.all_mm;
    }
};

}  // namespace touchline::testing
