#include "vision/simplify/detail_limits.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline {
namespace {

constexpr double table_diagonal_m = 0.215;
constexpr int least_strokes = 2;  // of two things side by side, neither may be lost

constexpr std::array<DetailLimits, most_detail> table{{
    {2, 600.0, 60.0, 12.0, 2.0, 12.0, InnerLines::none},
    {5, 1000.0, 40.0, 8.0, 1.5, 10.0, InnerLines::large_regions},
    {9, 1500.0, 25.0, 6.0, 1.0, 8.0, InnerLines::all},
    {16, 2500.0, 15.0, 5.0, 0.7, 6.0, InnerLines::all},
    {40, 5000.0, 10.0, 3.2, 0.5, 4.0, InnerLines::all},
}};

}  // namespace

DetailLimits limits_for(int detail, const Area& area) {
    DetailLimits limits = table[static_cast<std::size_t>(std::clamp(detail, 1, most_detail)) - 1];
    const double scale = std::hypot(area.width_m, area.height_m) / table_diagonal_m;
    limits.strokes = std::max(least_strokes, static_cast<int>(limits.strokes * scale));
    limits.line_mm *= scale;
    limits.least_stroke_mm *= scale;
    return limits;
}

}  // namespace touchline
