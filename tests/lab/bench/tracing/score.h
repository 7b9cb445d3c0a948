// How well a path follows a picture: distances both ways, in millimetres on the picture.
// Threads: pure functions and a plain value.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline::bench {

/// Returns places every half millimetre along all outlines.
[[nodiscard]] std::vector<Position> places_on(const TactileMap& map);

[[nodiscard]] double length_of(const TactileMap& map);

/// The distance from every place to the nearest of a set of places, capped at 10 mm.
class DistanceField {
  public:
    /// O(places * 400).
    explicit DistanceField(std::span<const Position> places);

    [[nodiscard]] double at(Position p) const;

  private:
    static constexpr double cell_m = 5e-4;
    static constexpr int half = 160;  // 80 mm to each side

    std::vector<float> cells_;
};

struct Score {
    double p90_m = 0.0;    // 90th percentile of the path's distance to the outlines; 1 m: no path
    double covered = 0.0;  // share of the outlines' length within 2 mm of the path
};

[[nodiscard]] Score score(const DistanceField& outlines, std::span<const Position> on_outlines,
                          std::span<const Position> path);

/// Returns which of the pictures the path is most like: the least mean distance, both ways, capped
/// at 10 mm each; -1 if there is no path.
[[nodiscard]] int most_like(std::span<const DistanceField> pictures,
                            std::span<const std::vector<Position>> on_outlines,
                            std::span<const Position> path);

}  // namespace touchline::bench
