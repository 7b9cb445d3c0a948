// Plane vectors, typed by quantity, so that adding a force to a position does not compile. Frames:
// W is the picture frame (origin in the centre of the drawing area, x right, y away from the user,
// metres). Names carry the frame only if more than one is in use: p_WH, p_DH.
#pragma once

#include <cmath>

namespace touchline {

template <class Quantity>
struct Vec2 {
    double x = 0.0;
    double y = 0.0;

    friend constexpr Vec2 operator+(Vec2 a, Vec2 b) noexcept { return {a.x + b.x, a.y + b.y}; }

    friend constexpr Vec2 operator-(Vec2 a, Vec2 b) noexcept { return {a.x - b.x, a.y - b.y}; }

    friend constexpr Vec2 operator-(Vec2 a) noexcept { return {-a.x, -a.y}; }

    friend constexpr Vec2 operator*(double s, Vec2 a) noexcept { return {s * a.x, s * a.y}; }

    friend constexpr bool operator==(Vec2 a, Vec2 b) noexcept = default;

    constexpr Vec2& operator+=(Vec2 b) noexcept { return *this = *this + b; }
};

using Position = Vec2<struct Metre>;            // m, also differences of positions
using Velocity = Vec2<struct MetrePerSecond>;   // m/s
using Force = Vec2<struct Newton>;              // N, on the hand
using Direction = Vec2<struct UnitVector>;      // length 1
using JointAngles = Vec2<struct Radian>;        // x: motor 1, y: motor 2
using JointTorques = Vec2<struct NewtonMetre>;  // x: motor 1, y: motor 2

template <class A, class B>
[[nodiscard]] constexpr double dot(Vec2<A> a, Vec2<B> b) noexcept {
    return a.x * b.x + a.y * b.y;
}

/// Positive if b lies to the left of a.
template <class A, class B>
[[nodiscard]] constexpr double cross(Vec2<A> a, Vec2<B> b) noexcept {
    return a.x * b.y - a.y * b.x;
}

/// For vectors between 1e-150 and 1e150, far beyond any length here. Does not scale as hypot does,
/// which would cost more than a whole slide along an edge.
template <class A>
[[nodiscard]] inline double norm(Vec2<A> a) noexcept {
    return std::sqrt(dot(a, a));
}

/// Returns a turned by +90 degrees.
template <class A>
[[nodiscard]] constexpr Vec2<A> left_of(Vec2<A> a) noexcept {
    return {-a.y, a.x};
}

/// Returns the direction of a; {1, 0} if a has no length.
template <class A>
[[nodiscard]] inline Direction direction_of(Vec2<A> a) noexcept {
    const double length = norm(a);
    return length > 0.0 ? Direction{a.x / length, a.y / length} : Direction{1.0, 0.0};
}

/// Returns a vector of another quantity along v, scaled: the only cast between quantities.
template <class Out, class In>
[[nodiscard]] constexpr Out along(Vec2<In> v, double scale) noexcept {
    return {scale * v.x, scale * v.y};
}

template <class A>
[[nodiscard]] inline bool is_finite(Vec2<A> a) noexcept {
    return std::isfinite(a.x) && std::isfinite(a.y);
}

}  // namespace touchline
