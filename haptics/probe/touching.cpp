#include "haptics/probe/touching.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double least_pivot = 1e-3;  // of the curved energy: below it has no clear least
constexpr Curvature plain{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

bool is_end(Position p, const Segment& s) {
    return p == s.a || p == s.b;
}

/// Finds the lower triangle with L L^T = m. Returns false if m is not clearly positive.
bool factor(Curvature& m) {
    for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t i = j; i < 3; ++i) {
            double left = m[i][j];
            for (std::size_t k = 0; k < j; ++k) left -= m[i][k] * m[j][k];
            if (i == j && !(left > least_pivot)) return false;
            m[i][j] = i == j ? std::sqrt(left) : left / m[j][j];
        }
    }
    return true;
}

/// Solves L x = b.
Coupled forward(const Curvature& l, const Coupled& b) {
    Coupled x{};
    for (std::size_t i = 0; i < 3; ++i) {
        double left = b[i];
        for (std::size_t k = 0; k < i; ++k) left -= l[i][k] * x[k];
        x[i] = left / l[i][i];
    }
    return x;
}

/// Solves L^T x = b.
Coupled backward(const Curvature& l, const Coupled& b) {
    Coupled x{};
    for (std::size_t i = 3; i-- > 0;) {
        double left = b[i];
        for (std::size_t k = i + 1; k < 3; ++k) left -= l[k][i] * x[k];
        x[i] = left / l[i][i];
    }
    return x;
}

}  // namespace

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

double Touching::bend_m(const Coupled& move) const {
    const double angle = move[2] / lever_m_;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const Position turned{c * arm_.x - s * arm_.y, s * arm_.x + c * arm_.y};
    const Position by = at_.on_first - at_.on_second + Position{move[0], move[1]} + turned - arm_;
    const double straight_m =
        at_.distance_m + row_[0] * move[0] + row_[1] * move[1] + row_[2] * move[2];
    Direction n = at_.normal;
    if (kind_ == Kind::end_on_end) return norm(by) - straight_m;
    if (kind_ == Kind::edge_on_end) n = {c * n.x - s * n.y, s * n.x + c * n.y};
    return dot(n, by) - straight_m;
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

Coupled CurvedEnergy::least(std::span<const Constraint> constraints, const Coupled& wanted,
                            std::vector<Constraint>& seen) const {
    seen.clear();
    for (const Constraint& c : constraints) seen.push_back({forward(factor_, c.row), c.gap_m});
    const LeastMove least = least_move(seen, forward(factor_, wanted));
    return backward(factor_, least.move);
}

}  // namespace touchline
