// What one touching line allows a shape to do, to first and second order. Threads: pure functions.
#pragma once

#include "haptics/collision/capsule.h"
#include "haptics/probe/least_move.h"
#include "haptics/probe/probe_pose.h"

#include <array>
#include <cstdint>
#include <vector>

namespace touchline {

/// Symmetric, in the coordinates of a Coupled move; per metre.
using Curvature = std::array<std::array<double, 3>, 3>;

class Touching {
  public:
    Touching() = default;

    /// `edge` is in W, of a shape at `origin`; lever of the turning spring > 0.
    Touching(const Segment& edge, const Segment& line, const Separation& at, Position origin,
             double lever_m);

    /// The distance's first derivative.
    [[nodiscard]] const Coupled& row() const { return row_; }

    /// The distance's second derivative.
    [[nodiscard]] Curvature curvature() const;

    /// Returns how far the distance after a move differs from what row() says.
    [[nodiscard]] double bend_m(const Coupled& move) const;

  private:
    enum class Kind : std::uint8_t { end_on_line, edge_on_end, end_on_end };

    Kind kind_ = Kind::end_on_line;
    Separation at_;
    Position arm_;  // from the origin to the point that touches
    double lever_m_ = 1.0;
    Coupled row_{};
};

/// The coupling's energy along distances that curve, held back by the pushes of a least move; the
/// plain energy if the curved one has no clear least.
class CurvedEnergy {
  public:
    CurvedEnergy(std::span<const Touching> touching, const LeastMove& least);

    /// As least_move(), for this energy.
    [[nodiscard]] Coupled least(std::span<const Constraint> constraints, const Coupled& wanted,
                                std::vector<Constraint>& seen) const;

  private:
    Curvature factor_{};  // lower triangle L; the energy is L L^T
};

}  // namespace touchline
