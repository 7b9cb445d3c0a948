// An independent judge of the proxy: knows the segments of a scene as rendered and exact
// predicates, but neither the collision tree nor the contact machine.
#pragma once

#include "config/types/vec2.h"
#include "haptics/curve/curve_set.h"

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace touchline {

class Judge {
  public:
    /// Takes the segments of the curves as rendered at `level`, in cells of `cell_m`.
    Judge(const CurveSet& curves, double level, double cell_m);

    /// Whether the straight way from a to b meets no segment.
    [[nodiscard]] bool is_free(Position a, Position b) const;

    /// Whether every stretch of the path is free.
    [[nodiscard]] bool is_free(std::span<const Position> path) const;

    [[nodiscard]] double distance_m(Position p, double within_m) const;

    /// Returns the largest cut of |proxy - handle| found among small free motions of the proxy:
    /// towards the handle, along every segment within 1 mm and in 72 directions, 1e-8 to 1e-4 m
    /// long.
    [[nodiscard]] double possible_gain_m(Position proxy, Position handle) const;

  private:
    [[nodiscard]] std::vector<std::uint32_t> near(Position a, Position b, double reach_m) const;
    [[nodiscard]] std::int64_t key(Position p) const;

    std::vector<Segment> segments_;
    double cell_m_;
    std::unordered_map<std::int64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace touchline
