// Affine maps of the plane, as SVG and PDF write them. Threads: pure functions.
#pragma once

#include "config/types/angle.h"
#include "tests/vision/pictures/canvas.h"

#include <cmath>

namespace touchline::testing {

struct Matrix {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

    [[nodiscard]] cv::Point2d of(const cv::Point2d& p) const {
        return {a * p.x + c * p.y + e, b * p.x + d * p.y + f};
    }

    [[nodiscard]] Polyline of(Polyline line) const {
        for (cv::Point2d& p : line.points) p = of(p);
        return line;
    }

    /// Requires that areas do not vanish.
    [[nodiscard]] Matrix inverse() const {
        const double area = a * d - b * c;
        return {d / area,
                -b / area,
                -c / area,
                a / area,
                (c * f - d * e) / area,
                (b * e - a * f) / area};
    }
};

/// Applies `n` first, then `m`.
inline Matrix operator*(const Matrix& m, const Matrix& n) {
    return {m.a * n.a + m.c * n.b, m.b * n.a + m.d * n.b,       m.a * n.c + m.c * n.d,
            m.b * n.c + m.d * n.d, m.a * n.e + m.c * n.f + m.e, m.b * n.e + m.d * n.f + m.f};
}

inline Matrix turn_about(const cv::Point2d& c, double deg) {
    const double t = radians(deg);
    const double cs = std::cos(t);
    const double sn = std::sin(t);
    return {cs, sn, -sn, cs, c.x - cs * c.x + sn * c.y, c.y - sn * c.x - cs * c.y};
}

}  // namespace touchline::testing
