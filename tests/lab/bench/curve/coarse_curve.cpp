#include "tests/lab/bench/curve/coarse_curve.h"

#include "haptics/curve/segment.h"
#include "tests/lab/bench/curve/filters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline::bench {
namespace {

using Points = std::vector<Position>;

CoarseCurve filtered(Filter filter, Points line, int level) {
    const bool closed = is_closed(line);
    if (closed) line.pop_back();
    for (int i = 0; i < level; ++i) {
        line = closed ? analyze_closed(filter, line).points : coarser_open(filter, line);
    }
    if (closed) line.push_back(line.front());
    CoarseCurve coarse{std::move(line), {}};
    for (std::size_t i = 0; i < coarse.points.size(); ++i) {
        coarse.parameters.push_back(first_parameter(filter, level) +
                                    std::exp2(level) * static_cast<double>(i));
    }
    return coarse;
}

CoarseCurve simplified(Method method, const Points& line, int level) {
    const std::size_t count = ((line.size() - 1) >> static_cast<unsigned>(level)) + 1;
    CoarseCurve coarse;
    for (const std::size_t i :
         method == Method::visvalingam ? visvalingam(line, count) : douglas_peucker(line, count)) {
        coarse.points.push_back(line[i]);
        coarse.parameters.push_back(static_cast<double>(i));
    }
    return coarse;
}

/// A closed line runs on past its end.
Position at(const Points& line, double parameter) {
    const std::size_t segments = line.size() - 1;
    const double whole = std::floor(parameter);
    auto i = static_cast<std::size_t>(whole);
    if (i >= segments) {
        if (!is_closed(line)) return line.back();
        i -= segments;
    }
    return line[i] + (parameter - whole) * (line[i + 1] - line[i]);
}

double distance_m(Position p, const Points& line) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line.size(); ++i) {
        nearest = std::min(nearest, foot(p, {line[i - 1], line[i]}).distance_m);
    }
    return nearest;
}

/// Returns the fine curve from one parameter to another, cut exactly there.
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

bool is_closed(const Points& line) {
    return line.front() == line.back();
}

CoarseCurve coarse_curve(Method method, const Points& line, int level) {
    if (is_filter(method)) return filtered(filter_of(method), line, level);
    return simplified(method, line, level);
}

double diagonal_m(const Points& points) {
    Position low = points[0];
    Position high = points[0];
    for (const Position p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return norm(high - low);
}

CurveError curve_error(const Points& fine, const CoarseCurve& coarse) {
    const double size = diagonal_m(fine);
    double squares = 0.0;
    double worst = 0.0;
    for (const Position p : fine) {
        const double distance = distance_m(p, coarse.points);
        squares += distance * distance;
        worst = std::max(worst, distance);
    }
    for (const Position p : coarse.points) worst = std::max(worst, distance_m(p, fine));
    Sums sums;
    const std::size_t count = coarse.points.size() - 1;
    for (std::size_t j = 0; j < count; ++j) {
        sums.add(stretch(fine, coarse.parameters[j], coarse.parameters[j + 1]), coarse.points[j],
                 coarse.points[j + 1]);
    }
    return {std::sqrt(squares / static_cast<double>(fine.size())) / size, worst / size,
            std::sqrt(sums.slope_squares / sums.length_m),
            sums.half_widths_m / static_cast<double>(count) / size};
}

}  // namespace touchline::bench
