// An exact judge of ways against the curves as rendered at any level, also between whole levels.
// Knows the rendered segments and exact predicates, but neither the collision tree nor the contact
// machine. Threads: one (it builds what a level needs when first asked for that level).
#pragma once

#include "config/types/vec2.h"
#include "haptics/curve/curve_set.h"

#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

namespace touchline::bench {

class LevelJudge {
  public:
    /// `curves` must outlive the judge.
    explicit LevelJudge(const CurveSet& curves) : curves_(&curves) {}

    /// Whether no stretch of the way meets a segment of the curves rendered at `level` >= 0. The
    /// first question about a level costs O(N).
    [[nodiscard]] bool is_free(std::span<const Position> way, double level);

  private:
    /// Segments by the cells that they may pass at a whole level and in the blend to the next.
    struct Cells {
        double cell_m = 0.0;
        std::unordered_map<std::int64_t, std::vector<SegmentRef>> segments;
    };

    const Cells& cells_of(double level);
    [[nodiscard]] bool is_free(Position a, Position b, double level, const Cells& cells) const;

    const CurveSet* curves_;
    std::map<int, Cells> by_level_;
};

}  // namespace touchline::bench
