#include "haptics/probe/least_move.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double tolerance_m = 1e-12;
constexpr double least_determinant = 1e-10;  // of rows about 1 long: below, they say the same
constexpr int most_candidates = 8;
constexpr int most_rounds = 16;

double dot3(const Coupled& a, const Coupled& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Finds pushes on k <= 3 rows so that each is just kept. Returns false if rows say the same.
bool solve(const std::array<const Constraint*, most_active>& rows, int k, const Coupled& wanted,
           std::array<double, most_active>& push) {
    std::array<double, 3> lack{};
    std::array<std::array<double, 3>, 3> g{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(k); ++i) {
        lack[i] = -rows[i]->gap_m - dot3(rows[i]->row, wanted);
        for (std::size_t j = 0; j < static_cast<std::size_t>(k); ++j) {
            g[i][j] = dot3(rows[i]->row, rows[j]->row);
        }
    }
    if (k == 1) {
        push[0] = lack[0] / g[0][0];
        return g[0][0] > 0.0;
    }
    if (k == 2) {
        const double size = g[0][0] * g[1][1] - g[0][1] * g[0][1];
        if (!(size > least_determinant * g[0][0] * g[1][1])) return false;
        push[0] = (lack[0] * g[1][1] - lack[1] * g[0][1]) / size;
        push[1] = (lack[1] * g[0][0] - lack[0] * g[0][1]) / size;
        return true;
    }
    const double c0 = g[1][1] * g[2][2] - g[1][2] * g[1][2];
    const double c1 = g[0][2] * g[1][2] - g[0][1] * g[2][2];
    const double c2 = g[0][1] * g[1][2] - g[0][2] * g[1][1];
    const double size = g[0][0] * c0 + g[0][1] * c1 + g[0][2] * c2;
    if (!(size > least_determinant * g[0][0] * g[1][1] * g[2][2])) return false;
    const double c11 = g[0][0] * g[2][2] - g[0][2] * g[0][2];
    const double c12 = g[0][1] * g[0][2] - g[0][0] * g[1][2];
    const double c22 = g[0][0] * g[1][1] - g[0][1] * g[0][1];
    push[0] = (c0 * lack[0] + c1 * lack[1] + c2 * lack[2]) / size;
    push[1] = (c1 * lack[0] + c11 * lack[1] + c12 * lack[2]) / size;
    push[2] = (c2 * lack[0] + c12 * lack[1] + c22 * lack[2]) / size;
    return true;
}

/// The candidates that count, and the best of their subsets.
class Candidates {
  public:
    Candidates(std::span<const Constraint> constraints, const Coupled& wanted)
        : constraints_(constraints), wanted_(wanted) {}

    [[nodiscard]] bool is_full() const { return count_ == most_candidates; }

    [[nodiscard]] bool has(int constraint) const {
        return std::find(index_.begin(), index_.begin() + count_, constraint) !=
               index_.begin() + count_;
    }

    void add(int constraint) { index_[static_cast<std::size_t>(count_++)] = constraint; }

    /// Finds the allowed move nearest to the wanted one; returns false if there is none. The newest
    /// candidate forbids the nearest move that the others allow, so it holds the next one back:
    /// only subsets with it can be right, and the first that pushes and breaks nothing is.
    bool best(LeastMove& out) {
        const int newest = count_ - 1;
        if (is_least({newest}, 1, out)) return true;
        for (int i = 0; i < newest; ++i) {
            if (is_least({newest, i}, 2, out)) return true;
        }
        for (int i = 0; i < newest; ++i) {
            for (int j = 0; j < i; ++j) {
                if (is_least({newest, i, j}, 3, out)) return true;
            }
        }
        return false;
    }

  private:
    bool is_least(const std::array<int, most_active>& subset, int k, LeastMove& out) const {
        LeastMove tried;
        std::array<const Constraint*, most_active> rows{};
        for (std::size_t i = 0; i < static_cast<std::size_t>(k); ++i) {
            tried.active[i] = index_[static_cast<std::size_t>(subset[i])];
            rows[i] = &constraints_[static_cast<std::size_t>(tried.active[i])];
        }
        tried.active_count = k;
        if (!solve(rows, k, wanted_, tried.push_m)) return false;
        for (std::size_t i = 0; i < static_cast<std::size_t>(k); ++i) {
            if (!(tried.push_m[i] >= 0.0)) return false;
        }
        tried.move = wanted_;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double push = 0.0;
            for (std::size_t i = 0; i < static_cast<std::size_t>(k); ++i) {
                push += tried.push_m[i] * rows[i]->row[axis];
            }
            tried.move[axis] += push;
        }
        for (int i = 0; i < count_; ++i) {
            const Constraint& c =
                constraints_[static_cast<std::size_t>(index_[static_cast<std::size_t>(i)])];
            if (dot3(c.row, tried.move) + c.gap_m < -tolerance_m) return false;
        }
        out = tried;
        return true;
    }

    std::span<const Constraint> constraints_;
    const Coupled& wanted_;
    std::array<int, most_candidates> index_{};
    int count_ = 0;
};

/// Returns -1 if none is broken by more than the tolerance.
int most_broken(std::span<const Constraint> constraints, const Coupled& move,
                const Candidates& candidates) {
    double least = -tolerance_m;
    int found = -1;
    for (std::size_t i = 0; i < constraints.size(); ++i) {
        const double left = dot3(constraints[i].row, move) + constraints[i].gap_m;
        if (left >= least || candidates.has(static_cast<int>(i))) continue;
        least = left;
        found = static_cast<int>(i);
    }
    return found;
}

}  // namespace

LeastMove least_move(std::span<const Constraint> constraints, const Coupled& wanted) {
    LeastMove out;
    out.move = wanted;
    Candidates candidates(constraints, wanted);
    for (int round = 0; round < most_rounds && !candidates.is_full(); ++round) {
        const int broken = most_broken(constraints, out.move, candidates);
        if (broken < 0) break;
        candidates.add(broken);
        if (!candidates.best(out)) break;
    }
    return out;
}

}  // namespace touchline
