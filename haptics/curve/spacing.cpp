#include "haptics/curve/spacing.h"

#include "haptics/curve/segment.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

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

constexpr double least_read_spacing_m = 1e-4;  // for a map read as it is, on any device
constexpr double finest_spacing_m = 1e-6;      // whatever the device claims
constexpr double scan_step = 0.995;            // far below the quarter between two counts
constexpr double uniform_ratio = 1.01;         // of the longest edge to the shortest

bool is_uniform(std::span<const Position> line) {
    double shortest = std::numeric_limits<double>::infinity();
    double longest = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double edge = norm(line[i] - line[i - 1]);
        shortest = std::min(shortest, edge);
        longest = std::max(longest, edge);
    }
    return longest <= uniform_ratio * shortest;
}

/// What decides a line's count, the strongest last.
enum class Limit { picture, data, scene, device };

/// The counts that one line can take. Threads: one; it remembers what it tried.
class LineCounts {
  public:
    LineCounts(const SpacedLine& line, double device_step_m)
        : line_(line),
          length_m_(polyline_length_m(line.points)),
          most_(count_below(length_m_ / device_step_m, line.is_closed)) {}

    /// The lowest count near this spacing.
    [[nodiscard]] std::size_t least(double spacing_m) const {
        return count_below(length_m_ / spacing_m, line_.is_closed);
    }

    /// Returns the lower count next to length / spacing that stays near the data, or the finest one
    /// that the device can tell. Nothing if the spacing is too wide.
    std::optional<std::size_t> near(double spacing_m) {
        const std::size_t lower = least(spacing_m);
        if (lower >= most_ || fits(lower)) return lower;
        const std::size_t upper = count_above(length_m_ / spacing_m, line_.is_closed);
        if (upper >= most_) return most_;
        return fits(upper) ? std::optional(upper) : std::nullopt;
    }

    /// Returns why the line has this count.
    Limit limit(std::size_t count) {
        if (!fits(count)) return Limit::device;
        if (count + 1 == line_.points.size() && is_uniform(line_.points)) return Limit::data;
        const std::size_t fewer = count_below(static_cast<double>(count) - 0.5, line_.is_closed);
        return fewer < count && !fits(fewer) ? Limit::scene : Limit::picture;
    }

    [[nodiscard]] double deviation_m(std::size_t count) const {
        return touchline::deviation_m(line_.points, resample(line_.points, count));
    }

    [[nodiscard]] double length_m() const { return length_m_; }

    [[nodiscard]] int outline() const { return line_.outline; }

  private:
    struct Tried {
        std::size_t count;
        bool fits;
    };

    bool fits(std::size_t count) {
        const auto tried = std::ranges::find(tried_, count, &Tried::count);
        if (tried != tried_.end()) return tried->fits;
        const bool does_fit = touchline::deviation_m(line_.points, resample(line_.points, count),
                                                     scene_tolerance_m) <= scene_tolerance_m;
        tried_.push_back({count, does_fit});
        return does_fit;
    }

    SpacedLine line_;
    double length_m_;
    std::size_t most_;
    std::vector<Tried> tried_;  // four an octave at most
};

/// The counts of all lines at one spacing.
struct Counts {
    double spacing_m = 0.0;
    std::size_t total = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> segments;
};

std::size_t least_total(const std::vector<LineCounts>& lines, double spacing_m) {
    std::size_t total = 0;
    for (const LineCounts& line : lines) total += line.least(spacing_m);
    return total;
}

std::optional<Counts> counts_at(std::vector<LineCounts>& lines, double spacing_m) {
    Counts counts{spacing_m, 0, {}};
    for (LineCounts& line : lines) {
        const auto count = line.near(spacing_m);
        if (!count) return std::nullopt;
        counts.total += *count;
        counts.segments.push_back(*count);
    }
    return counts;
}

/// Tries every spacing from one segment a line to narrow ones, until no narrower one can take fewer
/// points. It must scan, since rounding to m 2^L makes the total go up and down, and a curve may
/// fit its data by luck at one spacing but not at a slightly narrower one. The device's step itself
/// always works.
Counts fewest_points(std::vector<LineCounts>& lines, double device_step_m) {
    Counts best;
    double widest_m = device_step_m;
    for (const LineCounts& line : lines) widest_m = std::max(widest_m, line.length_m());
    for (double spacing_m = widest_m;; spacing_m = std::max(spacing_m * scan_step, device_step_m)) {
        if (least_total(lines, spacing_m) >= best.total) break;
        auto counts = counts_at(lines, spacing_m);
        if (counts && counts->total < best.total) best = std::move(*counts);
        if (spacing_m <= device_step_m) break;
    }
    return best;
}

std::string words(Limit limit, double device_step_m, double deviation_m) {
    switch (limit) {
        case Limit::picture:
            return "scene: one spacing for the whole picture, which another outline sets";
        case Limit::data:
            return "data: its own points, which are evenly spaced and no more than are needed";
        case Limit::scene:
            return fmt::format("scene: the fewest points within {:.2f} mm of the data",
                               1e3 * scene_tolerance_m);
        case Limit::device:
            return fmt::format(
                "device: nothing finer than its step of {:.3f} mm can be told; the data lie up to "
                "{:.3f} mm off",
                1e3 * device_step_m, 1e3 * deviation_m);
    }
    return {};
}

SpacingChoice fewest(std::span<const SpacedLine> lines, std::size_t outlines,
                     double device_step_m) {
    std::vector<LineCounts> tried;
    tried.reserve(lines.size());
    for (const SpacedLine& line : lines) tried.emplace_back(line, device_step_m);
    Counts counts = fewest_points(tried, device_step_m);
    std::vector<Limit> limits(outlines, Limit::picture);
    std::vector<double> deviations_m(outlines, 0.0);
    for (std::size_t i = 0; i < tried.size(); ++i) {
        const auto outline = static_cast<std::size_t>(tried[i].outline());
        const Limit limit = tried[i].limit(counts.segments[i]);
        limits[outline] = std::max(limits[outline], limit);
        if (limit != Limit::device) continue;
        deviations_m[outline] =
            std::max(deviations_m[outline], tried[i].deviation_m(counts.segments[i]));
    }
    SpacingChoice choice;
    for (std::size_t i = 0; i < outlines; ++i) {
        choice.outlines.push_back(
            {counts.spacing_m, words(limits[i], device_step_m, deviations_m[i])});
    }
    choice.segments = std::move(counts.segments);
    return choice;
}

SpacingChoice as_asked(std::span<const SpacedLine> lines, std::size_t outlines, double spacing_m) {
    SpacingChoice choice;
    choice.outlines.assign(outlines, {spacing_m, "spacing as asked"});
    for (const SpacedLine& line : lines) {
        choice.segments.push_back(
            nearest_count(polyline_length_m(line.points) / spacing_m, line.is_closed));
    }
    return choice;
}

/// Returns the median edge, or the least spacing if that is longer: then counting is enough.
double read_spacing_m(std::span<const Position> line) {
    std::size_t shorter = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Position e = line[i] - line[i - 1];
        shorter += dot(e, e) < least_read_spacing_m * least_read_spacing_m ? 1U : 0U;
    }
    if (shorter > line.size() / 2) return least_read_spacing_m;
    return std::max(median_edge_m(line), least_read_spacing_m);
}

SpacingChoice as_read(std::span<const Outline> outlines, const CurveOptions& options) {
    SpacingChoice choice;
    for (const Outline& outline : outlines) {
        choice.outlines.push_back(
            {options.spacing_m > 0.0 ? options.spacing_m : read_spacing_m(outline.points),
             "every vertex of the map is kept"});
    }
    return choice;
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
    if (std::ranges::adjacent_find(line, is_long) == line.end()) return line;
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

double median(std::span<double> values) {
    if (values.empty()) return 0.0;
    std::size_t rank = values.size() / 2;
    constexpr std::size_t samples = 2048;  // whose median has a rank within 5 % of the whole's
    if (values.size() >= 8 * samples) {    // sort only the values near that
        std::vector<double> sample;
        const std::size_t stride = values.size() / samples;
        for (std::size_t i = 0; i < values.size(); i += stride) sample.push_back(values[i]);
        std::ranges::sort(sample);
        const double low = sample[sample.size() * 45 / 100];
        const double high = sample[sample.size() * 55 / 100];
        std::size_t below = 0;
        std::size_t up_to = 0;
        for (const double value : values) {
            below += value < low ? 1U : 0U;
            up_to += value <= high ? 1U : 0U;
        }
        if (rank >= below && rank < up_to) {
            std::size_t near = 0;
            for (const double value : values) {
                values[near] = value;
                near += value >= low && value <= high ? 1U : 0U;
            }
            values = values.first(near);
            rank -= below;
        }
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double median_edge_m(std::span<const Position> line) {
    std::vector<double> squares;
    squares.reserve(line.size());
    for (std::size_t i = 1; i < line.size(); ++i) {
        squares.push_back(dot(line[i] - line[i - 1], line[i] - line[i - 1]));
    }
    return std::sqrt(median(squares));
}

SpacingChoice choose_spacing(std::span<const SpacedLine> lines, std::span<const Outline> outlines,
                             const CurveOptions& options) {
    if (!options.resample) return as_read(outlines, options);
    if (options.spacing_m > 0.0) return as_asked(lines, outlines.size(), options.spacing_m);
    return fewest(lines, outlines.size(), std::max(options.device_step_m, finest_spacing_m));
}

}  // namespace touchline
