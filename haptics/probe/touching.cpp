#include "haptics/probe/probe_proxy.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double tolerance_m = 1e-12;
constexpr double least_determinant = 1e-10;  // of rows about 1 long: below, they say the same
constexpr int most_candidates = 8;
constexpr int most_rounds = 16;

/// Finds pushes on k <= 3 rows so that each is just kept. Returns false if rows say the same.
[[gnu::always_inline]] inline bool solve(const std::array<const Constraint*, most_active>& rows,
                                         int k, const Coupled& wanted,
                                         std::array<double, most_active>& push) {
    std::array<double, 3> lack{};
    std::array<std::array<double, 3>, 3> g{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(k); ++i) {
        lack[i] = -rows[i]->gap_m - dot3(rows[i]->row, wanted);
        for (std::size_t j = i; j < static_cast<std::size_t>(k); ++j) {
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

/// Finds the move that the active constraints just allow, and their pushes. Returns false if one of
/// them pulls.
[[gnu::always_inline]] inline bool push(std::span<const Constraint> constraints,
                                        const Coupled& wanted, LeastMove& held) {
    const auto k = static_cast<std::size_t>(held.active_count);
    std::array<const Constraint*, most_active> rows{};
    for (std::size_t i = 0; i < k; ++i) {
        rows[i] = &constraints[static_cast<std::size_t>(held.active[i])];
    }
    if (!solve(rows, held.active_count, wanted, held.push_m)) return false;
    held.move = wanted;
    for (std::size_t i = 0; i < k; ++i) {
        if (!(held.push_m[i] >= 0.0)) return false;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            held.move[axis] += held.push_m[i] * rows[i]->row[axis];
        }
    }
    return true;
}

/// Returns whether the active constraints still hold the move back; if not, `held` says nothing.
[[gnu::always_inline]] inline bool is_still(std::span<const Constraint> constraints,
                                            const Coupled& wanted, LeastMove& held) {
    if (held.active_count == 0 || !push(constraints, wanted, held)) return false;
    return std::all_of(constraints.begin(), constraints.end(), [&held](const Constraint& c) {
        return dot3(c.row, held.move) + c.gap_m >= -tolerance_m;
    });
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
        tried.active_count = k;
        for (std::size_t i = 0; i < static_cast<std::size_t>(k); ++i) {
            tried.active[i] = index_[static_cast<std::size_t>(subset[i])];
        }
        if (!push(constraints_, wanted_, tried)) return false;
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

constexpr double least_pivot = 1e-3;  // of the curved energy: below it has no clear least
constexpr Curvature plain{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

bool is_end(Position p, const Segment& s) {
    return p == s.a || p == s.b;
}

/// Finds the lower triangle with L L^T = m, and on its diagonal 1 / L. Returns false if m is not
/// clearly positive.
bool factor(Curvature& m) {
    for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t i = j; i < 3; ++i) {
            double left = m[i][j];
            for (std::size_t k = 0; k < j; ++k) left -= m[i][k] * m[j][k];
            if (i == j && !(left > least_pivot)) return false;
            m[i][j] = i == j ? 1.0 / std::sqrt(left) : left * m[j][j];
        }
    }
    return true;
}

/// Solves L x = b.
Coupled forward(const Curvature& l, const Coupled& b) {
    const double x = b[0] * l[0][0];
    const double y = (b[1] - l[1][0] * x) * l[1][1];
    return {x, y, (b[2] - l[2][0] * x - l[2][1] * y) * l[2][2]};
}

/// Solves L^T x = b.
Coupled backward(const Curvature& l, const Coupled& b) {
    const double z = b[2] * l[2][2];
    const double y = (b[1] - l[2][1] * z) * l[1][1];
    return {(b[0] - l[1][0] * y - l[2][0] * z) * l[0][0], y, z};
}

}  // namespace

LeastMove least_move(std::span<const Constraint> constraints, const Coupled& wanted,
                     const LeastMove& like) {
    LeastMove out = like;
    if (is_still(constraints, wanted, out)) return out;
    out = {};
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

Touching::Touching(const Segment& edge, const Segment& line, const Separation& at, Position origin,
                   double lever_m)
    : at_(at), arm_(at.on_first - origin), lever_m_(lever_m) {
    const bool is_line_end = is_end(at.on_second, line);
    const bool is_edge_end = is_end(at.on_first, edge);
    if (is_line_end) kind_ = is_edge_end ? Kind::end_on_end : Kind::edge_on_end;
    row_ = {at.normal.x, at.normal.y, cross(arm_, at.normal) / lever_m};
}

Curvature Touching::curvature() const {
    const Direction n = at_.normal;
    Curvature out{};
    const double turn = -dot(n, arm_) / (lever_m_ * lever_m_);
    if (kind_ == Kind::edge_on_end) {
        // The normal turns with the edge.
        out[2][2] = -turn - at_.distance_m / (lever_m_ * lever_m_);
        out[0][2] = out[2][0] = -n.y / lever_m_;
        out[1][2] = out[2][1] = n.x / lever_m_;
        return out;
    }
    if (kind_ == Kind::end_on_end) {
        const Direction t = left_of(n);
        const Coupled beside{t.x, t.y, cross(arm_, t) / lever_m_};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) out[i][j] = beside[i] * beside[j] / at_.distance_m;
        }
    }
    out[2][2] += turn;
    return out;
}

double Touching::distance_m(const ProbePlacement& moved) const {
    const Position by = moved(arm_) - arm_ + (at_.on_first - at_.on_second);
    if (kind_ == Kind::end_on_end) return norm(by);
    return dot(at_.normal, kind_ == Kind::edge_on_end ? moved.seen_by_shape(by) : by);
}

double Touching::pivot_m(const ProbeMove& move) const {
    const Direction n = at_.normal;
    if (kind_ != Kind::edge_on_end) return dot(n, arm_);
    return at_.distance_m - dot(n, arm_) - 2.0 * dot(left_of(n), move.by) / move.turn_rad;
}

CurvedEnergy::CurvedEnergy(std::span<const Touching> touching, const LeastMove& least)
    : factor_(plain) {
    for (std::size_t a = 0; a < static_cast<std::size_t>(least.active_count); ++a) {
        const Curvature bend = touching[static_cast<std::size_t>(least.active[a])].curvature();
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) factor_[i][j] -= least.push_m[a] * bend[i][j];
        }
    }
    if (!factor(factor_)) factor_ = plain;
}

void CurvedEnergy::see(std::span<const Constraint> constraints,
                       std::vector<Constraint>& seen) const {
    seen.resize(constraints.size());
    for (std::size_t i = 0; i < seen.size(); ++i) {
        seen[i] = {forward(factor_, constraints[i].row), constraints[i].gap_m};
    }
}

Coupled CurvedEnergy::see(const Coupled& wanted) const {
    return forward(factor_, wanted);
}

Coupled CurvedEnergy::least(std::span<const Constraint> seen, const Coupled& wanted_seen,
                            LeastMove& held) const {
    if (!is_still(seen, wanted_seen, held)) held = least_move(seen, wanted_seen);
    return backward(factor_, held.move);
}

}  // namespace touchline
