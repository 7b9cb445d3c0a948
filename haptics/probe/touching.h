// What touching lines allow a shape to do: the move that leaves the least energy in the coupling if
// contacts forbid some moves, and what one line allows to first and second order.
// Threads: pure functions, no allocation.
#pragma once

#include "haptics/probe/probe_shape.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace touchline {

/// A move as (x, y, angle times the lever of the turning spring), all in metres: in these
/// coordinates the coupling's energy is K_t / 2 times the square of the distance left.
using Coupled = std::array<double, 3>;

[[nodiscard]] inline double square(const Coupled& move) {
    return move[0] * move[0] + move[1] * move[1] + move[2] * move[2];
}

[[nodiscard]] inline Coupled operator*(double share, const Coupled& move) {
    return {share * move[0], share * move[1], share * move[2]};
}

/// A contact that allows moves with row . move + gap_m >= 0.
struct Constraint {
    Coupled row{};
    double gap_m = 0.0;
};

inline constexpr std::size_t most_constraints = 64;

inline constexpr int most_active = 3;  // contacts that can hold three freedoms

/// The allowed move nearest to the wanted one.
struct LeastMove {
    Coupled move{};
    std::array<int, most_active> active{-1, -1, -1};  // constraints that hold it back
    std::array<double, most_active> push_m{};         // each one's push, metres times its row, >= 0
    int active_count = 0;
};

/// Takes the most violated constraint first: the one that a move breaks most joins at most eight
/// candidates, of which the subsets of three or fewer that include the newest are tried (29 at
/// most). If it finds no allowed move, it returns one that breaks the constraints least late; the
/// caller's sweep stops that one.
[[nodiscard]] LeastMove least_move(std::span<const Constraint> constraints, const Coupled& wanted);

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
