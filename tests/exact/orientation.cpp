#include "tests/exact/orientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <boost/multiprecision/cpp_int.hpp>

namespace touchline::exact {
namespace {

using Integer = boost::multiprecision::cpp_int;

struct Point {
    Integer x, y;
};

/// A finite double as mantissa x 2^exponent.
struct Binary {
    explicit Binary(double x) {
        constexpr int bits = std::numeric_limits<double>::digits;
        mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), bits));
        exponent = mantissa == 0 ? std::numeric_limits<int>::max() : exponent - bits;
    }

    std::int64_t mantissa = 0;
    int exponent = 0;
};

/// Returns coordinates as whole multiples of a common power of two. Signs of areas and quotients of
/// lengths do not depend on this unit.
template <std::size_t N>
std::array<Point, N> whole(const std::array<Position, N>& points) {
    int unit = std::numeric_limits<int>::max();
    for (const Position p : points) {
        unit = std::min({unit, Binary(p.x).exponent, Binary(p.y).exponent});
    }
    const auto in_units = [unit](double x) {
        const Binary binary(x);
        if (binary.mantissa == 0) return Integer(0);
        return Integer(Integer(binary.mantissa) << static_cast<unsigned>(binary.exponent - unit));
    };
    std::array<Point, N> out;
    for (std::size_t i = 0; i < N; ++i) out[i] = {in_units(points[i].x), in_units(points[i].y)};
    return out;
}

Integer area(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// numerator / denominator, 0 <= numerator <= denominator, rounded to nearest.
double quotient(const Integer& numerator, const Integer& denominator) {
    if (numerator == 0) return 0.0;
    // Keeps 62 or 63 bits; the last bit also stands for all that follow, so the conversion rounds
    // as it would for the exact number.
    const int shift = 62 + static_cast<int>(msb(denominator)) - static_cast<int>(msb(numerator));
    Integer whole;
    Integer rest;
    divide_qr(Integer(numerator << static_cast<unsigned>(shift)), denominator, whole, rest);
    if (rest != 0) whole |= 1U;
    return std::ldexp(static_cast<double>(static_cast<std::uint64_t>(whole)), -shift);
}

bool in_box(Position a, Position b, Position p) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

bool are_boxes_apart(Position a, Position b, Position c, Position d) {
    return std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
           std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y);
}

/// Requires that way and segment lie on one line, that their boxes meet, and that the way does not
/// start on the segment.
double collinear_meeting(Position from, Position to, const Segment& segment) {
    const auto [f, t, a, b] = whole(std::array{from, to, segment.a, segment.b});
    const bool is_wide = abs(t.x - f.x) >= abs(t.y - f.y);
    const auto along = [&, f = f](const Point& p) {
        return Integer(abs(is_wide ? p.x - f.x : p.y - f.y));
    };
    const bool has_a = in_box(from, to, segment.a);
    const bool has_b = in_box(from, to, segment.b);
    const Integer to_a = along(a);
    const Integer to_b = along(b);
    const bool is_a_first = has_a && (!has_b || to_a < to_b);
    return quotient(is_a_first ? to_a : to_b, along(t));
}

}  // namespace

int orientation(Position a, Position b, Position c) {
    using Wide = long double;
    const Wide left = (Wide{b.x} - a.x) * (Wide{c.y} - a.y);
    const Wide right = (Wide{b.y} - a.y) * (Wide{c.x} - a.x);
    const Wide fast = left - right;
    // Each product has three roundings of 2^-64, and the difference one more: 2^-61 is twice that.
    constexpr Wide bound = 0x1p-61L;
    static_assert(std::numeric_limits<Wide>::digits >= 64);
    if (std::abs(fast) > bound * (std::abs(left) + std::abs(right))) return fast > 0 ? 1 : -1;
    const auto [p, q, r] = whole(std::array{a, b, c});
    return area(p, q, r).sign();
}

bool meet(Position a, Position b, Position c, Position d) {
    if (are_boxes_apart(a, b, c, d)) return false;
    return orientation(a, b, c) * orientation(a, b, d) <= 0 &&
           orientation(c, d, a) * orientation(c, d, b) <= 0;
}

bool cross_inside(Position a, Position b, Position c, Position d) {
    return orientation(a, b, c) * orientation(a, b, d) < 0 &&
           orientation(c, d, a) * orientation(c, d, b) < 0;
}

std::optional<double> first_meeting(Position from, Position to, const Segment& segment) {
    const auto [a, b] = segment;
    if (!meet(from, to, a, b)) return {};
    const int side_of_from = orientation(a, b, from);
    if (side_of_from == 0 && in_box(a, b, from)) return 0.0;
    const int side_of_to = orientation(a, b, to);
    if (side_of_from == 0 && side_of_to == 0) return collinear_meeting(from, to, segment);
    const auto [f, t, p, q] = whole(std::array{from, to, a, b});
    const Integer start = abs(area(p, q, f));
    return quotient(start, start + abs(area(p, q, t)));
}

}  // namespace touchline::exact
