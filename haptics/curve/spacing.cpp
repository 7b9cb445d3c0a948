#include "haptics/curve/spacing.h"

#include "haptics/curve/sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/core.h>

namespace touchline {
namespace {

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
        for (const Tried& tried : tried_) {
            if (tried.count == count) return tried.fits;
        }
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

SpacingChoice choose_spacing(std::span<const SpacedLine> lines, std::span<const Outline> outlines,
                             const CurveOptions& options) {
    if (!options.resample) return as_read(outlines, options);
    if (options.spacing_m > 0.0) return as_asked(lines, outlines.size(), options.spacing_m);
    return fewest(lines, outlines.size(), std::max(options.device_step_m, finest_spacing_m));
}

}  // namespace touchline
