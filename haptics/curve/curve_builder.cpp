// Building a CurveSet: clean, cut at pins, place the level-0 points, transform.
#include "haptics/curve/curve_set.h"
#include "haptics/curve/pins.h"
#include "haptics/curve/sampling.h"
#include "haptics/curve/shrink.h"
#include "haptics/curve/spacing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>

namespace touchline {
namespace {

constexpr double repeated_point_m =
    1e-9;  // nearer points are one point: far below any device's step
constexpr double largest_coordinate_m = 1.0;
constexpr double most_points = 4e6;  // of a map: more than any picture gives, and within 1 GB

/// A stretch of outline that becomes a piece, both its ends included.
struct Stretch {
    std::vector<Position> line;
    int outline = 0;
    bool is_closed = false;
    bool has_next = false;             // the following stretch shares its end
    std::size_t first_of_outline = 0;  // index of the outline's first stretch
};

std::vector<Position> without_repeats(const Outline& outline) {
    std::vector<Position> kept;
    for (const Position p : outline.points) {
        if (kept.empty() || norm(p - kept.back()) > repeated_point_m) kept.push_back(p);
    }
    while (outline.is_closed && kept.size() > 1 &&
           norm(kept.front() - kept.back()) <= repeated_point_m) {
        kept.pop_back();
    }
    return kept;
}

Result<std::vector<Outline>> clean(const TactileMap& map) {
    std::vector<Outline> outlines;
    for (std::size_t i = 0; i < map.outlines.size(); ++i) {
        for (const Position p : map.outlines[i].points) {
            if (!(std::abs(p.x) <= largest_coordinate_m && std::abs(p.y) <= largest_coordinate_m)) {
                return failure(fmt::format(
                    "outline {} has a point that is not a number or lies more than 1 m from the "
                    "centre; check the map's viewBox and units (millimetres)",
                    i));
            }
        }
        Outline outline = map.outlines[i];
        outline.points = without_repeats(outline);
        if (outline.points.size() < 3) outline.is_closed = false;
        if (outline.points.size() < 2) outline.points.clear();  // keeps the outline's index
        outlines.push_back(std::move(outline));
    }
    return outlines;
}

/// The stretch from vertex a to vertex b > a, indices running on past the end of a closed outline.
std::vector<Position> line_between(const std::vector<Position>& points, std::size_t a,
                                   std::size_t b) {
    std::vector<Position> line;
    for (std::size_t i = a; i <= b; ++i) line.push_back(points[i % points.size()]);
    return line;
}

void cut(const Outline& outline, int index, const std::vector<std::size_t>& pins,
         std::vector<Stretch>& out) {
    const std::size_t count = outline.points.size();
    const std::size_t first = out.size();
    if (count < 2) return;
    if (pins.empty()) {
        out.push_back({line_between(outline.points, 0, count), index, true, false, first});
        return;
    }
    const std::size_t stretches = outline.is_closed ? pins.size() : pins.size() - 1;
    for (std::size_t k = 0; k < stretches; ++k) {
        const bool is_last = k + 1 == stretches;
        const std::size_t to = k + 1 < pins.size() ? pins[k + 1] : pins[0] + count;
        out.push_back({line_between(outline.points, pins[k], to), index, false,
                       !is_last || outline.is_closed, first});
    }
}

}  // namespace

class CurveSetBuilder {
  public:
    CurveSetBuilder(std::vector<Outline> outlines, const CurveOptions& options)
        : outlines_(std::move(outlines)), options_(options) {}

    Result<CurveSet> build() {
        const auto pins = find_pins(outlines_, PinRule{});
        for (std::size_t i = 0; i < outlines_.size(); ++i) {
            cut(outlines_[i], static_cast<int>(i), pins[i], stretches_);
        }
        std::vector<SpacedLine> lines;
        for (const Stretch& stretch : stretches_) {
            lines.push_back({stretch.line, stretch.outline, stretch.is_closed});
        }
        spacing_ = choose_spacing(lines, outlines_, options_);
        if (const double points = expected_points(); !(points <= most_points)) {
            return failure(
                fmt::format("the curves would have {:.3g} points, more than {:.0f}; choose a wider "
                            "spacing (--h0)",
                            points, most_points));
        }
        place_points();
        report();
        shrink();
        link();
        return std::move(set_);
    }

  private:
    /// At least as many as place_points() makes.
    [[nodiscard]] double expected_points() const {
        double points = 0.0;
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            points += options_.resample ? static_cast<double>(spacing_.segments[i]) + 1.0
                                        : expected_split(stretches_[i]);
        }
        return points;
    }

    [[nodiscard]] double expected_split(const Stretch& stretch) const {
        return 2.0 * polyline_length_m(stretch.line) / spacing_m(stretch) +
               static_cast<double>(stretch.line.size());
    }

    [[nodiscard]] double spacing_m(const Stretch& stretch) const {
        return spacing_.outlines[static_cast<std::size_t>(stretch.outline)].spacing_m;
    }

    void place_points() {
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            const Stretch& stretch = stretches_[i];
            std::vector<Position> points = options_.resample
                                               ? resample(stretch.line, spacing_.segments[i])
                                               : split_edges(stretch.line, spacing_m(stretch));
            if (stretch.is_closed) points.pop_back();
            const std::size_t segments = points.size() - (stretch.is_closed ? 0 : 1);
            const CurveShape shape{segments, 1, stretch.is_closed};
            firsts_.push_back(points);
            curves_.push_back(
                decompose(std::move(points), shape, halvings(segments, stretch.is_closed)));
        }
    }

    /// Level 0 is the stored points, not a reconstruction, unless details were taken away.
    void shrink() {
        const double threshold = detail_threshold(curves_, options_.keep_details);
        const bool is_changed = options_.denoise_m > 0.0 || options_.keep_details < 1.0;
        if (!is_changed) return;
        for (std::size_t i = 0; i < curves_.size(); ++i) {
            if (options_.denoise_m > 0.0) denoise(curves_[i], options_.denoise_m);
            if (options_.keep_details < 1.0) drop_details(curves_[i], threshold);
            std::vector<Position> shrunk = reconstruct(curves_[i]);
            add_error(static_cast<std::size_t>(stretches_[i].outline), firsts_[i], shrunk);
            firsts_[i] = std::move(shrunk);
        }
        for (OutlineReport& report : set_.reports_) {
            const auto count = static_cast<double>(std::max<std::size_t>(report.points_kept, 1));
            report.shrunk_rms_m = std::sqrt(report.shrunk_rms_m / count);
        }
    }

    /// Sums squares in shrunk_rms_m until all pieces of the outline are in.
    void add_error(std::size_t outline, const std::vector<Position>& from,
                   const std::vector<Position>& to) {
        OutlineReport& report = set_.reports_[outline];
        for (std::size_t k = 0; k < from.size(); ++k) {
            const double moved = norm(to[k] - from[k]);
            report.shrunk_rms_m += moved * moved;
            report.shrunk_max_m = std::max(report.shrunk_max_m, moved);
        }
    }

    /// Names every piece, stores its levels, and says who follows whom.
    void link() {
        store_points();
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            const Stretch& stretch = stretches_[i];
            Piece piece;
            piece.outline = stretch.outline;
            piece.is_closed = stretch.is_closed;
            piece.coarsest = static_cast<int>(curves_[i].details.size());
            const bool is_last = i + 1 == stretches_.size() ||
                                 stretches_[i + 1].first_of_outline != stretch.first_of_outline;
            if (stretch.has_next) {
                piece.next = static_cast<int>(is_last ? stretch.first_of_outline : i + 1);
            }
            if (i > stretch.first_of_outline) {
                const auto before = i - 1;
                piece.first_parameter = set_.pieces_[before].first_parameter +
                                        set_.segment_count(static_cast<int>(before), 0);
            }
            set_.coarsest_ = std::max(set_.coarsest_, piece.coarsest);
            set_.pieces_.push_back(piece);
        }
        measure_spacing();
        for (std::size_t i = 0; i < set_.pieces_.size(); ++i) {
            const int next = set_.pieces_[i].next;
            if (next >= 0)
                set_.pieces_[static_cast<std::size_t>(next)].previous = static_cast<int>(i);
        }
    }

    void measure_spacing() {
        std::vector<double> edges_m;
        for (std::size_t i = 0; i < set_.pieces_.size(); ++i) {
            const auto piece = static_cast<int>(i);
            const RenderedPiece level_0 = set_.rendered(piece, 0.0);
            for (int j = 0; j < level_0.segment_count(); ++j) {
                const Segment s = level_0.segment(j);
                edges_m.push_back(norm(s.b - s.a));
            }
            const bool is_last_of_outline = i + 1 == set_.pieces_.size() ||
                                            set_.pieces_[i + 1].outline != set_.pieces_[i].outline;
            if (!is_last_of_outline) continue;
            const auto middle = edges_m.begin() + static_cast<std::ptrdiff_t>(edges_m.size() / 2);
            std::nth_element(edges_m.begin(), middle, edges_m.end());
            set_.finest_spacing_m_ = std::min(set_.finest_spacing_m_, *middle);
            edges_m.clear();
        }
    }

    /// Level 0 of all pieces first, then each piece's coarser levels.
    void store_points() {
        std::size_t finest = 0;
        for (const auto& points : firsts_) finest += points.size();
        set_.finest_count_ = finest;
        set_.points_.reserve(2 * finest + 32 * firsts_.size());
        for (const auto& points : firsts_) {
            set_.points_.insert(set_.points_.end(), points.begin(), points.end());
        }
        std::uint32_t first = 0;
        for (std::size_t i = 0; i < firsts_.size(); ++i) {
            set_.first_level_.push_back(static_cast<std::uint32_t>(set_.levels_.size()));
            const auto count = static_cast<std::uint32_t>(firsts_[i].size());
            set_.levels_.push_back({first, count});
            first += count;
            store_coarser_levels(i);
        }
        set_.points_.shrink_to_fit();
    }

    void store_coarser_levels(std::size_t i) {
        std::vector<Position> points = std::move(firsts_[i]);
        CurveShape shape = curves_[i].shape;
        for (std::size_t level = 0; level < curves_[i].details.size(); ++level) {
            points = analyze(points, shape).points;
            shape.stride *= 2;
            set_.levels_.push_back({static_cast<std::uint32_t>(set_.points_.size()),
                                    static_cast<std::uint32_t>(points.size())});
            set_.points_.insert(set_.points_.end(), points.begin(), points.end());
        }
    }

    void report() {
        for (std::size_t i = 0; i < outlines_.size(); ++i) {
            OutlineReport line;
            line.points_in = outlines_[i].points.size();
            line.spacing_m = spacing_.outlines[i].spacing_m;
            line.reason = spacing_.outlines[i].reason;
            set_.reports_.push_back(line);
        }
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            set_.reports_[static_cast<std::size_t>(stretches_[i].outline)].points_kept +=
                firsts_[i].size() - (stretches_[i].has_next ? 1 : 0);
        }
    }

    std::vector<Outline> outlines_;
    CurveOptions options_;
    std::vector<Stretch> stretches_;
    SpacingChoice spacing_;
    std::vector<Decomposition> curves_;          // per stretch
    std::vector<std::vector<Position>> firsts_;  // per stretch: level 0
    CurveSet set_;
};

Result<CurveSet> CurveSet::build(const TactileMap& map, const CurveOptions& options) {
    auto outlines = clean(map);
    if (!outlines) return tl::unexpected(outlines.error());
    return CurveSetBuilder(std::move(*outlines), options).build();
}

}  // namespace touchline
