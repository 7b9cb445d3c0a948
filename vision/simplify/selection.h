// Ranks lines by how much they matter, and fills one detail with them, the best first. Lengths in
// millimetres.
// Threads: pure functions; one object, one thread.
#pragma once

#include "vision/contour/chain.h"
#include "vision/simplify/detail_limits.h"
#include "vision/simplify/shaping.h"
#include "vision/simplify/spacing.h"

#include <cstddef>
#include <vector>

namespace touchline {

struct RankedLine {
    Chain line;
    double salience = 0.0;     // 0..1
    double outer_share = 0.0;  // 0..1, see surroundings.h
};

/// Salience = length x contrast x closure x place: length 1 - exp(-length / 150 mm); contrast r /
/// (1 + r), r = mean strength / high, never zero; closure 1 for a closed line, 2/3 for an open one
/// (a finger can lose it); place 1 outside ... 0.7 inside; never less than the least weight of a
/// map's outline. Sorted by falling salience; ties keep their order. `outer_shares`: one for each
/// line. O(n log n).
[[nodiscard]] std::vector<RankedLine> ranked(std::vector<Chain> lines,
                                             const std::vector<double>& outer_shares, double high);

/// An outline to be.
struct Stroke {
    std::size_t line = 0;  // number of the ranked line that it came from
    double length_mm = 0.0;
};

/// A value: a copy is another way to go on.
class Selection {
  public:
    Selection(const DetailLimits& limits, cv::Size2d area_mm);

    /// Returns whether it is full, by number or by length of line.
    [[nodiscard]] bool is_full() const;

    /// Adds whatever may be shown of a line. The first line is always kept: if it alone is longer
    /// than all lines may be, it is taken at coarser and coarser scales.
    void add(const RankedLine& ranked, std::size_t number);

    /// Lines added from here on keep to these limits: to the present lines and to themselves.
    void go_on_with(const DetailLimits& limits);

    /// The strokes in the order of adding, as in `lines`.
    [[nodiscard]] const std::vector<Stroke>& strokes() const { return strokes_; }

    [[nodiscard]] std::vector<Chain> lines() const { return spaced_.lines(); }

    [[nodiscard]] double line_mm() const { return line_mm_; }

    [[nodiscard]] int crossings_opened() const { return crossings_opened_; }

  private:
    [[nodiscard]] bool may_be_shown(const RankedLine& ranked) const;
    bool add_at(const ShapingScale& scale, const Chain& line, std::size_t number);
    bool add_ring(const ShapingScale& scale, const Chain& ring, std::size_t number);
    bool add_all(std::vector<Candidate> open, std::size_t number);
    static void add_parts(const Candidate& candidate, std::vector<Candidate>& open);
    bool add_longest(const Candidate& candidate, std::size_t number, std::vector<Candidate>& open);
    [[nodiscard]] double worth(const Selection& after, const Chain& line) const;

    DetailLimits limits_;
    cv::Size2d area_mm_;
    ShapingScale scale_;
    SpacedLines spaced_;
    std::vector<Stroke> strokes_;
    double line_mm_ = 0.0;
    int crossings_opened_ = 0;
};

/// Selects the lines of a detail from all, best first. Rings of a photograph's figures come first
/// and keep their limbs: they are smoothed no more than at detail 4, and keep 3.2 mm to themselves
/// at every detail. If nothing lies outside, lines inside count too; if none is long enough by
/// itself, the least length is halved until one is. Empty only if `order` is.
[[nodiscard]] Selection selected(const std::vector<RankedLine>& order, DetailLimits limits,
                                 cv::Size2d area_mm);

}  // namespace touchline
