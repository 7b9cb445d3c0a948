#include "haptics/curve/curve_set.h"

#include "haptics/curve/large_pages.h"
#include "haptics/curve/spacing.h"
#include "haptics/curve/wavelet.h"

#include <cmath>

#include <fmt/core.h>

namespace touchline {

Position RenderedPiece::blended_point(int i) const {
    const Position p = fine_[i];
    const bool is_open = segment_count_ < fine_count_;
    const bool is_unpaired_end = is_open && i + 1 == fine_count_;
    const int half = i / 2;
    Position q = coarse_[is_unpaired_end ? coarse_count_ - 1 : half];
    if (i % 2 != 0 && !is_unpaired_end) {
        q = 0.5 * (q + coarse_[half + 1 == coarse_count_ ? 0 : half + 1]);
    }
    return p + weight_ * (q - p);  // in this form a pin stays exactly where it is
}

RenderedPiece CurveSet::rendered(int piece, double level) const {
    const double at = rendered_level(piece, level);
    return blend(piece, static_cast<int>(at), at - static_cast<int>(at));
}

RenderedPiece CurveSet::blend(int piece, int finer, double weight) const {
    const int coarsest = pieces_[static_cast<std::size_t>(piece)].coarsest;
    finer = std::min(finer, coarsest);
    const Level& fine = level_of(piece, finer);
    RenderedPiece view;
    view.fine_ = points_.data() + fine.first;
    view.fine_count_ = static_cast<int>(fine.count);
    view.segment_count_ =
        view.fine_count_ - (pieces_[static_cast<std::size_t>(piece)].is_closed ? 0 : 1);
    view.weight_ = finer < coarsest ? weight : 0.0;
    if (view.weight_ > 0.0) {
        const Level& coarse = level_of(piece, finer + 1);
        view.coarse_ = points_.data() + coarse.first;
        view.coarse_count_ = static_cast<int>(coarse.count);
    }
    return view;
}

void CurveSet::limit_levels(std::span<const int> coarsest) {
    coarsest_ = 0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        pieces_[i].coarsest = std::min(pieces_[i].coarsest, coarsest[i]);
        coarsest_ = std::max(coarsest_, pieces_[i].coarsest);
    }
}

int CurveSet::rendered_count(int piece, double level) const {
    return segment_count(piece, static_cast<int>(rendered_level(piece, level)));
}

SegmentRef CurveSet::next(SegmentRef segment, double level) const {
    const Piece& piece = pieces_[static_cast<std::size_t>(segment.piece)];
    if (segment.index + 1 < rendered_count(segment.piece, level)) {
        return {segment.piece, segment.index + 1};
    }
    if (piece.is_closed) return {segment.piece, 0};
    return piece.next >= 0 ? SegmentRef{piece.next, 0} : SegmentRef{};
}

SegmentRef CurveSet::previous(SegmentRef segment, double level) const {
    const Piece& piece = pieces_[static_cast<std::size_t>(segment.piece)];
    if (segment.index > 0) return {segment.piece, segment.index - 1};
    if (piece.is_closed) return {segment.piece, rendered_count(segment.piece, level) - 1};
    if (piece.previous < 0) return {};
    return {piece.previous, rendered_count(piece.previous, level) - 1};
}

double CurveSet::outline_parameter(int piece, double level, int j, double t) const {
    const double stride = 1 << static_cast<int>(rendered_level(piece, level));
    const double length = segment_count(piece, 0);
    const double from = stride * j;
    const double to = std::min(from + stride, length);
    return pieces_[static_cast<std::size_t>(piece)].first_parameter + from + t * (to - from);
}

/// A stretch of outline that becomes a piece, including both its ends.
struct OutlineStretch {
    std::vector<Position> line;
    int outline = 0;
    std::size_t first_vertex = 0;
    std::size_t last_vertex = 0;
    bool is_closed = false;
    bool has_next = false;  // the following stretch shares its end
    bool starts_at_corner = false;
    std::size_t first_of_outline = 0;  // index of the outline's first stretch
};

namespace {

constexpr double repeated_point_m =
    1e-9;  // nearer points count as one: far below any device's step
constexpr double largest_coordinate_m = 1.0;
constexpr double most_points = 4e6;  // per map: more than any picture gives, and within 1 GB

bool is_repeated(Position p, Position q) {
    return dot(p - q, p - q) <= repeated_point_m * repeated_point_m;
}

bool is_near_the_centre(Position p) {
    return std::abs(p.x) <= largest_coordinate_m && std::abs(p.y) <= largest_coordinate_m;
}

Result<void> check(const std::vector<Outline>& outlines) {
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        const auto& points = outlines[i].points;
        if (std::ranges::all_of(points, is_near_the_centre)) continue;
        return failure(fmt::format(
            "outline {} has a point that is not a number or lies more than 1 m from the "
            "centre; check the map's viewBox and units (millimetres)",
            i));
    }
    return {};
}

bool is_clean(const Outline& outline) {
    const auto& points = outline.points;
    if (points.size() < (outline.is_closed ? 3 : 2)) return false;
    if (outline.is_closed && is_repeated(points.front(), points.back())) return false;
    return std::ranges::adjacent_find(points, is_repeated) == points.end();
}

std::vector<Position> without_repeats(const Outline& outline) {
    std::vector<Position> kept;
    for (const Position p : outline.points) {
        if (kept.empty() || !is_repeated(p, kept.back())) kept.push_back(p);
    }
    while (outline.is_closed && kept.size() > 1 && is_repeated(kept.front(), kept.back())) {
        kept.pop_back();
    }
    return kept;
}

std::vector<Outline> cleaned(std::vector<Outline> outlines) {
    for (Outline& outline : outlines) {
        outline.points = without_repeats(outline);
        if (outline.points.size() < 3) outline.is_closed = false;
        if (outline.points.size() < 2) outline.points.clear();  // keeps the outline's index
    }
    return outlines;
}

/// Returns the stretch from vertex a to vertex b > a; indices run on past the end of a closed
/// outline.
std::vector<Position> line_between(const std::vector<Position>& points, std::size_t a,
                                   std::size_t b) {
    const auto from = points.begin() + static_cast<std::ptrdiff_t>(a);
    const std::size_t before_end = std::min(b + 1, points.size()) - a;
    const std::size_t count = b + 1 - a;
    std::vector<Position> line;
    reserve_in_large_pages(line, count);
    line.insert(line.end(), from, from + static_cast<std::ptrdiff_t>(before_end));
    line.insert(line.end(), points.begin(),
                points.begin() + static_cast<std::ptrdiff_t>(count - before_end));
    return line;
}

/// `corners` are the pins that were found in the outline itself. Both ascend.
void cut(const Outline& outline, int index, const std::vector<std::size_t>& pins,
         const std::vector<std::size_t>& corners, std::vector<OutlineStretch>& out) {
    const std::size_t count = outline.points.size();
    const std::size_t first = out.size();
    if (count < 2) return;
    if (pins.empty()) {
        out.push_back(
            {line_between(outline.points, 0, count), index, 0, count, true, false, false, first});
        return;
    }
    const std::size_t stretches = outline.is_closed ? pins.size() : pins.size() - 1;
    for (std::size_t k = 0; k < stretches; ++k) {
        const bool is_last = k + 1 == stretches;
        const std::size_t to = k + 1 < pins.size() ? pins[k + 1] : pins[0] + count;
        out.push_back({line_between(outline.points, pins[k], to), index, pins[k], to, false,
                       !is_last || outline.is_closed, std::ranges::binary_search(corners, pins[k]),
                       first});
    }
}

}  // namespace

/// Cuts the outlines at pins, places the level-0 points and transforms.
class CurveSetBuilder {
  public:
    /// The outlines must outlive the builder.
    CurveSetBuilder(const std::vector<Outline>& outlines, const CurveOptions& options)
        : outlines_(outlines), options_(options) {}

    /// `corners` are the pins found in the outlines themselves.
    Result<CurveSet> build(const std::vector<std::vector<std::size_t>>& corners,
                           std::span<const PinPlace> wanted) {
        auto pins = corners;
        add_pins(outlines_, wanted, pins);
        for (std::size_t i = 0; i < outlines_.size(); ++i) {
            cut(outlines_[i], static_cast<int>(i), pins[i], corners[i], stretches_);
        }
        set_.reports_.resize(outlines_.size());
        if (options_.denoise_m > 0.0) denoise_stretches();
        std::vector<SpacedLine> lines;
        for (const OutlineStretch& stretch : stretches_) {
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
        if (options_.keep_details < 1.0) compress();
        for (OutlineReport& report : set_.reports_) {
            report.shrunk_rms_m = std::sqrt(report.shrunk_rms_m);
        }
        link();
        return std::move(set_);
    }

  private:
    /// Returns at least as many as place_points() makes.
    [[nodiscard]] double expected_points() const {
        double points = 0.0;
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            const OutlineStretch& stretch = stretches_[i];
            points += options_.resample
                          ? static_cast<double>(spacing_.segments[i]) + 1.0
                          : 2.0 * polyline_length_m(stretch.line) / spacing_m(stretch) +
                                static_cast<double>(stretch.line.size());
        }
        return points;
    }

    [[nodiscard]] double spacing_m(const OutlineStretch& stretch) const {
        return spacing_.outlines[static_cast<std::size_t>(stretch.outline)].spacing_m;
    }

    /// Turns the stretches' lines into their level 0.
    void place_points() {
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            OutlineStretch& stretch = stretches_[i];
            std::vector<Position> line = std::move(stretch.line);
            line = options_.resample ? resample(line, spacing_.segments[i])
                                     : split_edges(std::move(line), spacing_m(stretch));
            if (stretch.is_closed) line.pop_back();
            const std::size_t segments = line.size() - (stretch.is_closed ? 0 : 1);
            shapes_.push_back({segments, 1, stretch.is_closed});
            halvings_.push_back(halvings(segments, stretch.is_closed));
            firsts_.push_back(std::move(line));
        }
    }

    /// Noise is white on the data's own points, but not on split or resampled ones.
    void denoise_stretches() {
        for (OutlineStretch& stretch : stretches_) {
            std::vector<Position> points = stretch.line;
            if (stretch.is_closed) points.pop_back();
            const std::size_t segments = stretch.line.size() - 1;
            Decomposition curve = decompose(points, {segments, 1, stretch.is_closed},
                                            halvings(segments, stretch.is_closed));
            denoise(curve, options_.denoise_m);
            const std::vector<Position> smooth = reconstruct(curve);
            const auto outline = static_cast<std::size_t>(stretch.outline);
            add_moves(outline, points, smooth, outlines_[outline].points.size());
            std::ranges::copy(smooth, stretch.line.begin());
            if (stretch.is_closed) stretch.line.back() = stretch.line.front();
        }
    }

    /// Rebuilds level 0 from the remaining details.
    void compress() {
        std::vector<Decomposition> curves;
        for (std::size_t i = 0; i < firsts_.size(); ++i) {
            curves.push_back(decompose(firsts_[i], shapes_[i], halvings_[i]));
        }
        const double threshold = detail_threshold(curves, options_.keep_details);
        for (std::size_t i = 0; i < curves.size(); ++i) {
            drop_details(curves[i], threshold);
            std::vector<Position> small = reconstruct(curves[i]);
            const auto outline = static_cast<std::size_t>(stretches_[i].outline);
            add_moves(outline, firsts_[i], small, set_.reports_[outline].points_kept);
            firsts_[i] = std::move(small);
        }
    }

    /// Adds the moves of some of an outline's `count` points; shrunk_rms_m holds the mean square
    /// until all are in.
    void add_moves(std::size_t outline, const std::vector<Position>& from,
                   const std::vector<Position>& to, std::size_t count) {
        OutlineReport& report = set_.reports_[outline];
        for (std::size_t k = 0; k < from.size(); ++k) {
            const double moved = norm(to[k] - from[k]);
            report.shrunk_rms_m += moved * moved / static_cast<double>(count);
            report.shrunk_max_m = std::max(report.shrunk_max_m, moved);
        }
    }

    /// Names every piece, stores its levels, and links it to its neighbours.
    void link() {
        store_points();
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            const OutlineStretch& stretch = stretches_[i];
            Piece piece;
            piece.outline = stretch.outline;
            piece.is_closed = stretch.is_closed;
            piece.starts_at_corner = stretch.starts_at_corner;
            piece.coarsest = halvings_[i];
            piece.first_vertex = stretch.first_vertex;
            piece.last_vertex = stretch.last_vertex;
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
        std::vector<double> squares;
        reserve_in_large_pages(squares, set_.finest_count_);
        for (std::size_t i = 0; i < set_.pieces_.size(); ++i) {
            const auto points = set_.points(static_cast<int>(i), 0);
            for (std::size_t j = 1; j < points.size(); ++j) {
                squares.push_back(dot(points[j] - points[j - 1], points[j] - points[j - 1]));
            }
            if (set_.pieces_[i].is_closed) {
                const Position e = points.front() - points.back();
                squares.push_back(dot(e, e));
            }
            const bool is_last_of_outline = i + 1 == set_.pieces_.size() ||
                                            set_.pieces_[i + 1].outline != set_.pieces_[i].outline;
            if (!is_last_of_outline) continue;
            set_.finest_spacing_m_ = std::min(set_.finest_spacing_m_, std::sqrt(median(squares)));
            squares.clear();
        }
    }

    /// Stores level 0 of all pieces first, then each piece's coarser levels.
    void store_points() {
        const std::size_t points = place_levels();
        reserve_in_large_pages(set_.points_, points);
        std::size_t most_segments = 0;
        for (std::size_t i = 0; i < firsts_.size(); ++i) {
            set_.points_.insert(set_.points_.end(), firsts_[i].begin(), firsts_[i].end());
            firsts_[i] = std::vector<Position>();  // an empty list would keep the memory
            most_segments = std::max(most_segments, shapes_[i].finest_segments);
        }
        set_.points_.resize(points);
        std::vector<Position> details(most_segments / 2);
        for (std::size_t i = 0; i < firsts_.size(); ++i) {
            const auto piece = static_cast<int>(i);
            CurveShape shape = shapes_[i];
            for (int level = 0; level < halvings_[i]; ++level) {
                analyze(points_of(piece, level), shape, points_of(piece, level + 1), details);
                shape.stride *= 2;
            }
        }
    }

    /// Returns how many points there are on all levels.
    std::size_t place_levels() {
        std::size_t first = 0;  // of level 0 of the next piece
        for (const auto& points : firsts_) first += points.size();
        set_.finest_count_ = first;
        std::size_t coarser = first;
        first = 0;
        for (std::size_t i = 0; i < firsts_.size(); ++i) {
            set_.first_level_.push_back(static_cast<std::uint32_t>(set_.levels_.size()));
            add_level(first, firsts_[i].size());
            const std::size_t end = shapes_[i].is_closed ? 0 : 1;
            std::size_t segments = shapes_[i].finest_segments;
            for (int level = 0; level < halvings_[i]; ++level) {
                segments = coarser_count(segments);
                add_level(coarser, segments + end);
            }
        }
        return coarser;
    }

    void add_level(std::size_t& first, std::size_t count) {
        set_.levels_.push_back(
            {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)});
        first += count;
    }

    [[nodiscard]] std::span<Position> points_of(int piece, int level) {
        return {set_.points_.data() + set_.first_point(piece, level),
                set_.points(piece, level).size()};
    }

    void report() {
        for (std::size_t i = 0; i < outlines_.size(); ++i) {
            OutlineReport& line = set_.reports_[i];
            line.points_in = outlines_[i].points.size();
            line.spacing_m = spacing_.outlines[i].spacing_m;
            line.reason = spacing_.outlines[i].reason;
        }
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            set_.reports_[static_cast<std::size_t>(stretches_[i].outline)].points_kept +=
                firsts_[i].size() - (stretches_[i].has_next ? 1 : 0);
        }
    }

    const std::vector<Outline>& outlines_;
    const CurveOptions& options_;
    std::vector<OutlineStretch> stretches_;
    SpacingChoice spacing_;
    std::vector<CurveShape> shapes_;             // per stretch
    std::vector<int> halvings_;                  // per stretch
    std::vector<std::vector<Position>> firsts_;  // per stretch: level 0
    CurveSet set_;
};

CurveSource::CurveSource(const TactileMap& map, const CurveOptions& options)
    : map_(&map), options_(options) {
    if (!std::ranges::all_of(map.outlines, is_clean)) repaired_ = cleaned(map.outlines);
    PinRule rule;
    rule.noise_m = options.denoise_m;
    corners_ = find_pins(outlines(), rule);
}

Result<CurveSource> CurveSource::read(const TactileMap& map, const CurveOptions& options) {
    if (const auto checked = check(map.outlines); !checked) return tl::unexpected(checked.error());
    return CurveSource(map, options);
}

Result<CurveSet> CurveSource::build(std::span<const PinPlace> pins) const {
    return CurveSetBuilder(outlines(), options_).build(corners_, pins);
}

Result<CurveSet> CurveSet::build(const TactileMap& map, const CurveOptions& options) {
    const auto source = CurveSource::read(map, options);
    if (!source) return tl::unexpected(source.error());
    return source->build(options.pins);
}

}  // namespace touchline
