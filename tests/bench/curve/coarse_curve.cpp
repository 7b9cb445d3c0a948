#include "tests/bench/curve/coarse_curve.h"

#include "haptics/curve/sampling.h"
#include "tests/bench/curve/simplify.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline::bench {
namespace {

using Points = std::vector<Position>;

CoarseCurve filtered(Filter filter, Points points, int level) {
    for (int i = 0; i < level; ++i) points = analyze_closed(filter, points).points;
    CoarseCurve coarse{std::move(points), {}};
    for (std::size_t i = 0; i < coarse.points.size(); ++i) {
        coarse.parameters.push_back(first_parameter(filter, level) +
                                    std::exp2(level) * static_cast<double>(i));
    }
    return coarse;
}

CoarseCurve simplified(Method method, const Points& points, std::size_t count) {
    Points line = points;
    line.push_back(points.front());
    std::vector<std::size_t> kept = method == Method::visvalingam
                                        ? visvalingam(line, count + 1)
                                        : douglas_peucker(line, count + 1);
    kept.pop_back();
    CoarseCurve coarse;
    for (const std::size_t i : kept) {
        coarse.points.push_back(points[i]);
        coarse.parameters.push_back(static_cast<double>(i));
    }
    return coarse;
}

Position at(const Points& closed, double parameter) {
    const double whole = std::floor(parameter);
    const auto i = static_cast<std::size_t>(whole) % closed.size();
    return closed[i] + (parameter - whole) * (closed[(i + 1) % closed.size()] - closed[i]);
}

double distance_m(Position p, const Points& closed) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < closed.size(); ++i) {
        nearest =
            std::min(nearest, distance_to_segment_m(p, closed[i], closed[(i + 1) % closed.size()]));
    }
    return nearest;
}

double size_m(const Points& points) {
    Position low = points[0];
    Position high = points[0];
    for (const Position p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return norm(high - low);
}

/// The fine curve from one parameter to another, cut exactly there.
Points stretch(const Points& fine, double from, double to) {
    Points points{at(fine, from)};
    for (double i = std::floor(from) + 1.0; i < to; i += 1.0) points.push_back(at(fine, i));
    points.push_back(at(fine, to));
    return points;
}

/// Sums over the coarse segments.
struct Sums {
    double slope_squares = 0.0;
    double length_m = 0.0;
    double half_widths_m = 0.0;

    void add(const Points& data, Position a, Position b) {
        const Direction along = direction_of(b - a);
        double low = 0.0;
        double high = 0.0;
        for (std::size_t i = 0; i < data.size(); ++i) {
            const double across = cross(along, data[i] - a);
            low = std::min(low, across);
            high = std::max(high, across);
            if (i == 0) continue;
            const Position edge = data[i] - data[i - 1];
            const double angle = std::atan2(cross(along, edge), dot(along, edge));
            slope_squares += angle * angle * norm(edge);
            length_m += norm(edge);
        }
        half_widths_m += 0.5 * (high - low);
    }
};

}  // namespace

std::string_view name_of(Method method) {
    if (is_filter(method)) return name_of(filter_of(method));
    return method == Method::visvalingam ? "Visvalingam" : "Douglas-Peucker";
}

CoarseCurve coarse_curve(Method method, const Points& points, int level) {
    if (is_filter(method)) return filtered(filter_of(method), points, level);
    return simplified(method, points, points.size() >> static_cast<unsigned>(level));
}

CurveError curve_error(const Points& fine, const CoarseCurve& coarse) {
    const double size = size_m(fine);
    double squares = 0.0;
    double worst = 0.0;
    for (const Position p : fine) {
        const double distance = distance_m(p, coarse.points);
        squares += distance * distance;
        worst = std::max(worst, distance);
    }
    for (const Position p : coarse.points) worst = std::max(worst, distance_m(p, fine));
    Sums sums;
    const std::size_t count = coarse.points.size();
    for (std::size_t j = 0; j < count; ++j) {
        const std::size_t next = (j + 1) % count;
        const double turn = next == 0 ? static_cast<double>(fine.size()) : 0.0;
        sums.add(stretch(fine, coarse.parameters[j], coarse.parameters[next] + turn),
                 coarse.points[j], coarse.points[next]);
    }
    return {std::sqrt(squares / static_cast<double>(fine.size())) / size, worst / size,
            std::sqrt(sums.slope_squares / sums.length_m),
            sums.half_widths_m / static_cast<double>(count) / size};
}

}  // namespace touchline::bench
