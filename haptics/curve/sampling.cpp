#include "haptics/curve/sampling.h"

#include "haptics/curve/segment.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double rounding = 1e-9;  // of length / spacing
constexpr double most = 1e15;      // exact as a double, more than any memory holds

/// Returns 2^L with count / 2^L in 4 ... 7; 1 if count is below 4.
std::size_t stride_of(std::size_t count) {
    std::size_t stride = 1;
    while (count >= 8 * stride) stride *= 2;
    return stride;
}

}  // namespace

double polyline_length_m(std::span<const Position> line) {
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) length += norm(line[i] - line[i - 1]);
    return length;
}

std::vector<Position> split_edges(std::vector<Position> line, double spacing_m) {
    const auto is_long = [&](Position a, Position b) {
        return dot(b - a, b - a) > spacing_m * spacing_m;
    };
    if (std::adjacent_find(line.begin(), line.end(), is_long) == line.end()) return line;
    std::vector<Position> out{line.front()};
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Position e = line[i] - line[i - 1];
        // The tolerance keeps an edge of exactly one spacing whole.
        const auto parts = std::max(1L, std::lround(std::ceil(norm(e) / spacing_m * (1.0 - 1e-9))));
        for (long k = 1; k < parts; ++k) {
            out.push_back(line[i - 1] + (static_cast<double>(k) / static_cast<double>(parts)) * e);
        }
        out.push_back(line[i]);
    }
    return out;
}

std::vector<Position> resample(std::span<const Position> line, std::size_t segments) {
    const double step = polyline_length_m(line) / static_cast<double>(segments);
    std::vector<Position> out{line.front()};
    std::size_t edge = 1;
    double passed = 0.0;  // arc length at line[edge - 1]
    for (std::size_t k = 1; k < segments; ++k) {
        const double wanted = step * static_cast<double>(k);
        double length = norm(line[edge] - line[edge - 1]);
        while (edge + 1 < line.size() && passed + length < wanted) {
            passed += length;
            ++edge;
            length = norm(line[edge] - line[edge - 1]);
        }
        const double t = length > 0.0 ? std::clamp((wanted - passed) / length, 0.0, 1.0) : 0.0;
        out.push_back(line[edge - 1] + t * (line[edge] - line[edge - 1]));
    }
    out.push_back(line.back());
    return out;
}

std::size_t count_below(double wanted, bool is_closed) {
    const std::size_t least = is_closed ? 8 : 1;
    const auto count = static_cast<std::size_t>(std::clamp(wanted * (1.0 + rounding), 1.0, most));
    if (count <= least) return least;
    const std::size_t stride = stride_of(count);
    return count / stride * stride;
}

std::size_t count_above(double wanted, bool is_closed) {
    const std::size_t least = is_closed ? 8 : 1;
    const double whole = std::ceil(std::clamp(wanted * (1.0 - rounding), 1.0, most));
    const std::size_t count = std::max(static_cast<std::size_t>(whole), least);
    const std::size_t stride = stride_of(count);
    return (count + stride - 1) / stride * stride;
}

std::size_t nearest_count(double wanted, bool is_closed) {
    const std::size_t below = count_below(wanted, is_closed);
    const std::size_t above = count_above(wanted, is_closed);
    const double middle = 0.5 * static_cast<double>(below + above);
    return wanted <= middle ? below : above;
}

int halvings(std::size_t segments, bool is_closed) {
    const std::size_t least = is_closed ? 8 : 4;
    int levels = 0;
    for (std::size_t n = segments; n >= 2 * least; n = (n + 1) / 2) ++levels;
    return levels;
}

double deviation_m(std::span<const Position> line, std::span<const Position> kept,
                   double enough_m) {
    const double scale = static_cast<double>(kept.size() - 1) / polyline_length_m(line);
    double worst = 0.0;
    double arc = 0.0;
    for (std::size_t i = 0; i < line.size() && worst <= enough_m; ++i) {
        if (i > 0) arc += norm(line[i] - line[i - 1]);
        const auto at = static_cast<std::ptrdiff_t>(arc * scale);
        const auto last = static_cast<std::ptrdiff_t>(kept.size()) - 2;
        double nearest = norm(line[i] - kept.front()) + norm(line[i] - kept.back());
        for (auto j = std::max<std::ptrdiff_t>(0, at - 1); j <= std::min(last, at + 1); ++j) {
            const auto k = static_cast<std::size_t>(j);
            nearest = std::min(nearest, foot(line[i], {kept[k], kept[k + 1]}).distance_m);
        }
        worst = std::max(worst, nearest);
    }
    return worst;
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    auto rank = static_cast<std::ptrdiff_t>(values.size() / 2);
    constexpr std::size_t samples = 2048;  // whose median has a rank within 5 % of the whole's
    if (values.size() >= 8 * samples) {    // sort only the values near that
        std::vector<double> sample;
        const std::size_t stride = values.size() / samples;
        for (std::size_t i = 0; i < values.size(); i += stride) sample.push_back(values[i]);
        std::sort(sample.begin(), sample.end());
        const double low = sample[sample.size() * 45 / 100];
        const double high = sample[sample.size() * 55 / 100];
        const auto is_below = [low](double value) { return value < low; };
        const auto is_far = [low, high](double value) { return value < low || value > high; };
        const auto below = std::count_if(values.begin(), values.end(), is_below);
        const auto far = std::count_if(values.begin(), values.end(), is_far);
        if (rank >= below && rank < below + std::ssize(values) - far) {
            std::erase_if(values, is_far);
            rank -= below;
        }
    }
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
}

double median_edge_m(std::span<const Position> line) {
    std::vector<double> squares;
    squares.reserve(line.size());
    for (std::size_t i = 1; i < line.size(); ++i) {
        squares.push_back(dot(line[i] - line[i - 1], line[i] - line[i - 1]));
    }
    return std::sqrt(median(std::move(squares)));
}

}  // namespace touchline
