// All outlines of a map as wavelet multiresolution curves: cut at their pins into pieces, with one
// polyline per level for each piece. Threads: immutable once built; any thread may read. The
// functions are pure.
#pragma once

#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "config/types/vec2.h"
#include "haptics/curve/segment.h"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace touchline {

// Pins are the vertices that coincide at every level, so that corners stay sharp and linked pieces
// never come apart. They are found once, when a map is built.

struct PinRule {
    double reach_m = 0.002;  // a turn is measured between chords of this length on both sides
    double turn_rad = 0.785398163397448;  // 45 degrees: weaker corners are not pinned
    double apart_m = 0.004;               // least distance along the outline between two corners
    double noise_m = 0.0;  // standard deviation per coordinate, taken out before turns are measured
};

/// Returns the pins of every outline of a map, as ascending vertex indices: the ends of open
/// outlines, vertices where the end of another outline lies (junctions), and corners, strongest
/// first. A closed outline may have none. O(N log N).
[[nodiscard]] std::vector<std::vector<std::size_t>> find_pins(const std::vector<Outline>& outlines,
                                                              const PinRule& rule);

/// A wanted pin: the vertex of an outline that is nearest to a place.
struct PinPlace {
    int outline = 0;  // index in the map
    Position place;
};

/// Adds the wanted pins to those of find_pins(), which stay ascending. O(N + pins N / 64).
void add_pins(const std::vector<Outline>& outlines, std::span<const PinPlace> wanted,
              std::vector<std::vector<std::size_t>>& pins);

struct CurveOptions {
    /// false: keeps every vertex of the map at level 0, and splits edges longer than the spacing
    /// into equal collinear parts. true: resamples each piece by arc length.
    bool resample = false;
    /// Spacing of level 0 (metres). 0 means the outline's median edge, at least 0.1 mm (not
    /// resampled), or the spacing that data, device and scene need (resampled; spacing.h).
    double spacing_m = 0.0;
    /// The smallest motion that the device can tell (metres, > 0): resampling goes no finer.
    double device_step_m = 1e-4;
    /// The share of the wavelet details to keep, largest first, 0 ... 1 (compression, paper section
    /// 5).
    double keep_details = 1.0;
    /// Standard deviation per coordinate of the noise on the map's points (metres). Details are
    /// shrunk on the levels that are mostly noise (denoising, paper section 5; wavelet.h). 0: none.
    double denoise_m = 0.0;
    /// Pins besides the map's corners, junctions and ends.
    std::vector<PinPlace> pins{};
};

/// A stretch of an outline between pins. Each piece has its own levels.
struct Piece {
    int outline = 0;                // index in the map
    bool is_closed = false;         // one periodic piece; otherwise its two ends are pins
    bool starts_at_corner = false;  // or at a junction or end; otherwise at a pin of CurveOptions
    int next = -1,
        previous = -1;  // pieces that share a pin with it along the outline; -1: open end
    double first_parameter = 0.0;  // outline parameter of its first point, in level-0 segments
    int coarsest = 0;              // L: levels 0 ... L exist
    std::size_t first_vertex = 0;  // of the outline without repeated points; `last_vertex` runs on
    std::size_t last_vertex = 0;   // past the end of a closed one
};

/// What was kept of one outline, and why, for `curve --json`.
struct OutlineReport {
    std::size_t points_in = 0;
    std::size_t points_kept = 0;  // at level 0
    double spacing_m = 0.0;
    std::string reason;
    // How far denoising moved the outline's data points and compression its level-0 points: the
    // root of the sum of both mean squares, and the largest move of either.
    double shrunk_rms_m = 0.0;
    double shrunk_max_m = 0.0;
};

/// Names a segment of the curve as rendered; its index depends on the level. piece -1: none.
struct SegmentRef {
    int piece = -1;
    int index = -1;

    friend auto operator<=>(const SegmentRef&, const SegmentRef&) = default;
};

/// One piece as rendered at one level, looked up once for many segments. At a fraction w above
/// level k its points are (1 - w) p_k + w p_(k+1), where p_(k+1) is the coarser polyline with its
/// midpoints, so that a level blends into the next. A view: valid as long as its CurveSet.
class RenderedPiece {
  public:
    [[nodiscard]] int segment_count() const { return segment_count_; }

    /// Returns segment j, 0 <= j < segment_count(). O(1).
    [[nodiscard]] Segment segment(int j) const {
        const int end = j + 1 == fine_count_ ? 0 : j + 1;
        return {point(j), point(end)};
    }

    /// Returns point i; an open piece has segment_count() + 1 points. O(1).
    [[nodiscard]] Position point(int i) const {
        return weight_ > 0.0 ? blended_point(i) : fine_[i];
    }

  private:
    [[nodiscard]] Position blended_point(int i) const;

    const Position* fine_ = nullptr;
    const Position* coarse_ = nullptr;
    double weight_ = 0.0;
    int fine_count_ = 0;
    int coarse_count_ = 0;
    int segment_count_ = 0;

    friend class CurveSet;
};

class CurveSet {
  public:
    /// O(N). Drops repeated points (closer than 1 nm) and outlines left with fewer than two points.
    /// Fails if a point is not finite or lies further than 1 m from the origin.
    [[nodiscard]] static Result<CurveSet> build(const TactileMap& map, const CurveOptions& options);

    /// Limits each piece to levels up to its number here; a number at or above the piece's coarsest
    /// changes nothing. Call before the curves are shared.
    void limit_levels(std::span<const int> coarsest);

    [[nodiscard]] std::span<const Piece> pieces() const { return pieces_; }

    [[nodiscard]] const Piece& piece(int i) const { return pieces_[static_cast<std::size_t>(i)]; }

    [[nodiscard]] int piece_count() const { return static_cast<int>(pieces_.size()); }

    [[nodiscard]] std::span<const OutlineReport> reports() const { return reports_; }

    /// The coarsest level that any piece has.
    [[nodiscard]] int coarsest() const { return coarsest_; }

    /// Returns the points of one level of a piece, 0 <= level <= its coarsest. An open piece has
    /// one point more than segments; a closed one repeats no point.
    [[nodiscard]] std::span<const Position> points(int piece, int level) const {
        const Level& at = level_of(piece, level);
        return {points_.data() + at.first, at.count};
    }

    [[nodiscard]] int segment_count(int piece, int level) const {
        const auto count = static_cast<int>(level_of(piece, level).count);
        return pieces_[static_cast<std::size_t>(piece)].is_closed ? count : count - 1;
    }

    /// Where the points of a level lie among all points: level 0 of all pieces comes first. A tree
    /// over the curves keeps its nodes in the same order.
    [[nodiscard]] std::size_t first_point(int piece, int level) const {
        return level_of(piece, level).first;
    }

    [[nodiscard]] std::size_t point_count() const { return points_.size(); }

    /// The number of points at level 0 of all pieces.
    [[nodiscard]] std::size_t finest_count() const { return finest_count_; }

    /// The smallest median edge of any outline's stored level 0, from which the level rule counts.
    /// 1 m if there is no outline.
    [[nodiscard]] double finest_spacing_m() const { return finest_spacing_m_; }

    /// Returns a piece as rendered at `level` (fractional, >= 0). O(1).
    [[nodiscard]] RenderedPiece rendered(int piece, double level) const;

    /// Returns a piece as rendered at `finer` + `weight`, 0 <= weight <= 1, in segments of level
    /// `finer` even if the weight is 1: for a change of level within one octave. A piece without
    /// that octave stays at its coarsest level. O(1).
    [[nodiscard]] RenderedPiece blend(int piece, int finer, double weight) const;

    /// Returns the level at which a piece is rendered if `level` (fractional, >= 0) is wanted:
    /// min(level, L).
    [[nodiscard]] double rendered_level(int piece, double level) const {
        return std::min(level,
                        static_cast<double>(pieces_[static_cast<std::size_t>(piece)].coarsest));
    }

    /// Counts the segments of the piece as rendered at `level`; at a fractional level they are
    /// those of the next finer whole level.
    [[nodiscard]] int rendered_count(int piece, double level) const;

    /// Returns a segment or a point of rendered(piece, level). O(1).
    [[nodiscard]] Segment rendered_segment(int piece, double level, int j) const {
        return rendered(piece, level).segment(j);
    }

    [[nodiscard]] Position rendered_point(int piece, double level, int i) const {
        return rendered(piece, level).point(i);
    }

    /// Returns the segment after (before) one along its outline, across pins; piece -1 at an open
    /// end. O(1).
    [[nodiscard]] SegmentRef next(SegmentRef segment, double level) const;
    [[nodiscard]] SegmentRef previous(SegmentRef segment, double level) const;

    /// Returns the outline parameter, in level-0 segments from the start of the outline's first
    /// piece, at share t of rendered segment j. It is the same at every level, so that a contact
    /// survives a change of level. O(1).
    [[nodiscard]] double outline_parameter(int piece, double level, int j, double t) const;

  private:
    struct Level {
        std::uint32_t first = 0;  // in points_
        std::uint32_t count = 0;
    };

    [[nodiscard]] const Level& level_of(int piece, int level) const {
        return levels_[first_level_[static_cast<std::size_t>(piece)] +
                       static_cast<std::uint32_t>(level)];
    }

    std::vector<Piece> pieces_;
    std::vector<std::uint32_t> first_level_;  // per piece, in levels_
    std::vector<Level> levels_;
    std::vector<Position> points_;  // level 0 of every piece, then each piece's coarser levels
    std::size_t finest_count_ = 0;
    double finest_spacing_m_ = 1.0;
    std::vector<OutlineReport> reports_;
    int coarsest_ = 0;

    friend class CurveSetBuilder;
};

/// A map made ready for curves: checked, without repeated points, its own pins found; for a scene
/// that is built again with more pins. The map must outlive it.
class CurveSource {
  public:
    /// Fails as CurveSet::build().
    [[nodiscard]] static Result<CurveSource> read(const TactileMap& map,
                                                  const CurveOptions& options);

    /// Builds as CurveSet::build(), with these pins besides the map's own.
    [[nodiscard]] Result<CurveSet> build(std::span<const PinPlace> pins) const;

  private:
    CurveSource(const TactileMap& map, const CurveOptions& options);

    [[nodiscard]] const std::vector<Outline>& outlines() const {
        return repaired_.empty() ? map_->outlines : repaired_;
    }

    const TactileMap* map_;
    CurveOptions options_;
    std::vector<Outline> repaired_;  // empty where the map's own have no repeated points
    std::vector<std::vector<std::size_t>> corners_;
};

// How far a level lies from level 0, and whether a finger can tell.

struct LevelError {
    double rms_m = 0.0;        // of the level-0 points from the level's polyline
    double hausdorff_m = 0.0;  // largest distance between the two, either way
    double slope_rms_rad =
        0.0;  // angle between the edges of level 0 and the segment that stands for them,
    double slope_max_rad = 0.0;  // weighted by length; what a finger notices first
    std::size_t points = 0;      // at this level
};

/// Measures all pieces of one outline rendered at a whole `level` (each at most at its coarsest).
/// O(N).
[[nodiscard]] LevelError level_error(const CurveSet& curves, int outline, int level);

/// Returns the least height of a bump that a finger detects, by the bump's width (metres): 8 mm at
/// 240 mm, falling with the power 1.3 (Louw, Kappers and Koenderink 2000).
[[nodiscard]] double detection_threshold_m(double width_m);

/// Returns l_percept: the coarsest level up to which no piece moves by more than half the threshold
/// for the level's shortest wavelength, 4 h0 2^l, nor turns an edge of level 0 by more than 5
/// degrees, half of what a hand with a tool can tell. A piece at its coarsest level does not change
/// any more. O(N) a level; ends at the first stretch that can be told from level 0.
[[nodiscard]] int percept_level(const CurveSet& curves);

}  // namespace touchline
