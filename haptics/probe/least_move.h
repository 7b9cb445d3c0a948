// Finds the move of a shape that leaves the least energy in the coupling, if contacts forbid some
// moves.
// Threads: pure functions, no allocation.
#pragma once

#include <array>
#include <cstddef>
#include <span>

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

}  // namespace touchline
