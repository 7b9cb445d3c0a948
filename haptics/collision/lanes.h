// Four numbers at a time, in the vector types of the compiler, which every processor has in some
// form; and points, taken relative to each other before they are rounded to single precision.
// Threads: pure functions.
#pragma once

#include "config/types/vec2.h"

#include <cstdint>

namespace touchline::lanes {

using Floats = float __attribute__((vector_size(16)));
using Masks = std::int32_t __attribute__((vector_size(16)));  // all bits or none
using Pair = double __attribute__((vector_size(16)));

[[nodiscard]] inline Floats larger(Floats a, Floats b) {
    return a > b ? a : b;
}

[[nodiscard]] inline Floats smaller(Floats a, Floats b) {
    return a < b ? a : b;
}

[[nodiscard]] inline Floats absolute(Floats a) {
    return larger(a, -a);
}

/// Four points, or the ways between them.
struct Points {
    Floats x, y;
};

[[nodiscard]] inline Floats dot(const Points& a, const Points& b) {
    return a.x * b.x + a.y * b.y;
}

[[nodiscard]] inline Floats cross(const Points& a, const Points& b) {
    return a.x * b.y - a.y * b.x;
}

/// Returns at least the lengths, at most 42 % more.
[[nodiscard]] inline Floats length_bounds(const Points& a) {
    return absolute(a.x) + absolute(a.y);
}

[[nodiscard]] inline Pair pair(Position p) {
    return Pair{p.x, p.y};
}

/// Rounds four differences of points and transposes them.
[[nodiscard]] inline Points rounded(Pair a, Pair b, Pair c, Pair d) {
    const auto small = [](Pair p, Pair q) {
        return __builtin_convertvector(__builtin_shufflevector(p, q, 0, 1, 2, 3), Floats);
    };
    const Floats ab = small(a, b);
    const Floats cd = small(c, d);
    return {__builtin_shufflevector(ab, cd, 0, 2, 4, 6),
            __builtin_shufflevector(ab, cd, 1, 3, 5, 7)};
}

/// Returns the bits set in any lane.
[[nodiscard]] inline unsigned gathered(Masks bits) {
    const Masks halves = bits | __builtin_shufflevector(bits, bits, 2, 3, 0, 1);
    const Masks whole = halves | __builtin_shufflevector(halves, halves, 1, 0, 3, 2);
    return static_cast<unsigned>(whole[0]);
}

/// Returns the last 4 - by of `four` and the first of `next`. In two steps, each of which most
/// processors do at once.
template <int by, class Four>
[[nodiscard]] Four moved_on(Four four, Four next) {
    static_assert(by >= 1 && by <= 3);
    if constexpr (by == 2) return __builtin_shufflevector(four, next, 2, 3, 4, 5);
    const Four joint = __builtin_shufflevector(four, next, 3, 3, 4, 4);
    return by == 1 ? __builtin_shufflevector(four, joint, 1, 2, 4, 6)
                   : __builtin_shufflevector(joint, next, 0, 2, 5, 6);
}

template <int by>
[[nodiscard]] Points moved_on(const Points& four, const Points& next) {
    return {moved_on<by>(four.x, next.x), moved_on<by>(four.y, next.y)};
}

}  // namespace touchline::lanes
