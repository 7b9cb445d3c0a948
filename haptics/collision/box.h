// A node's box as the queries see it: in the frame of its segment, in units of the segment's
// length, so that no test takes a root. Alone, and four neighbours against one way at once, in
// single precision: most boxes that a walk looks at are far from the motion, and four at a time
// cost little more than one; the exact test then judges those that may be near. Threads: pure
// functions, no allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/collision/lanes.h"
#include "haptics/curve/segment.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace touchline {

/// Returns the axis of a segment's frame: the segment itself, or 1 m to the right if it is so short
/// (1e-15 m) that its direction means nothing.
[[nodiscard]] inline Position frame_axis(const Segment& segment) {
    constexpr double least_square_m2 = 1e-30;
    const Position e = segment.b - segment.a;
    return dot(e, e) > least_square_m2 ? e : Position{1.0, 0.0};
}

/// A rectangle along and across an axis that starts at `origin`. Extents in axis lengths.
struct Box {
    Position origin;
    Position axis;
    double along_low = 0.0, along_high = 0.0, across_low = 0.0, across_high = 0.0;
};

/// The box of a segment that holds nothing beside itself.
[[nodiscard]] inline Box box_of(const Segment& s) {
    const Position axis = frame_axis(s);
    return {s.a, axis, 0.0, axis == s.b - s.a ? 1.0 : 0.0, 0.0, 0.0};
}

/// The extent of something along and across an axis, in axis lengths times metres.
struct Shadow {
    double along_low = 0.0, along_high = 0.0, across_low = 0.0, across_high = 0.0;

    /// Grows to hold another one along the same axis.
    void hold(const Shadow& other) {
        along_low = std::min(along_low, other.along_low);
        along_high = std::max(along_high, other.along_high);
        across_low = std::min(across_low, other.across_low);
        across_high = std::max(across_high, other.across_high);
    }
};

inline constexpr Shadow no_shadow{INFINITY, -INFINITY, INFINITY, -INFINITY};

/// The shadow of a box along an axis that starts at `origin`.
[[nodiscard]] inline Shadow shadow(const Box& box, Position origin, Position axis) {
    const Position w = box.origin - origin;
    const double s = dot(axis, w);
    const double n = cross(axis, w);
    const double c = dot(axis, box.axis);
    const double d = cross(axis, box.axis);
    const auto [uc_low, uc_high] = std::minmax({box.along_low * c, box.along_high * c});
    const auto [ud_low, ud_high] = std::minmax({box.along_low * d, box.along_high * d});
    const auto [vc_low, vc_high] = std::minmax({box.across_low * c, box.across_high * c});
    const auto [vd_low, vd_high] = std::minmax({box.across_low * d, box.across_high * d});
    return {s + uc_low - vd_high, s + uc_high - vd_low, n + ud_low + vc_low, n + ud_high + vc_high};
}

/// A straight way, and how near to it something matters.
struct Way {
    Position from;
    Position by;
    double reach_m = 0.0;
};

/// Returns at least the length of v, at most 42 % more, without a root.
[[nodiscard]] inline double length_bound(Position v) {
    return std::abs(v.x) + std::abs(v.y);
}

/// How a way lies relative to a box.
struct Approach {
    bool is_met = false;   // false only when no point of the way comes within its reach of the box
    double entry = 0.0;    // where met: share of the way, never later than the first point in reach
    double gap2_m2 = 0.0;  // else: the way stays at least this far (squared) out of reach
};

/// Tests by separating axes, with the reach up to 42 % too large, so that it needs no root. About
/// 40 operations, without calls.
[[nodiscard]] [[gnu::always_inline]] inline Approach approach(const Box& box, const Way& way) {
    const Position w = way.from - box.origin;
    const double square = dot(box.axis, box.axis);
    const double grow = way.reach_m * length_bound(box.axis);
    const double s = dot(box.axis, w);
    const double n = cross(box.axis, w);
    const double ds = dot(box.axis, way.by);
    const double dn = cross(box.axis, way.by);
    const double s_low = box.along_low * square - grow;
    const double s_high = box.along_high * square + grow;
    const double n_low = box.across_low * square - grow;
    const double n_high = box.across_high * square + grow;
    const double beside = std::max(s_low - std::max(s, s + ds), std::min(s, s + ds) - s_high);
    const double off = std::max(n_low - std::max(n, n + dn), std::min(n, n + dn) - n_high);
    const double gap = std::max(beside, off);
    if (gap > 0.0) return {false, 0.0, gap * gap / square};
    const double turn = ds * (n_low + n_high - 2.0 * n) - dn * (s_low + s_high - 2.0 * s);
    if (std::abs(turn) > std::abs(ds) * (n_high - n_low) + std::abs(dn) * (s_high - s_low)) {
        return {};
    }
    // Shares of the way at which it enters the two slabs. A way along a slab starts in it.
    double entry = 0.0;
    if (s < s_low || s > s_high) entry = ((s < s_low ? s_low : s_high) - s) / ds;
    if (n < n_low || n > n_high) entry = std::max(entry, ((n < n_low ? n_low : n_high) - n) / dn);
    return {true, std::min(entry, 1.0), 0.0};
}

/// The shares of a way between which it is inside a box; none if `enter` is not below `leave`.
struct Stay {
    double enter = 0.0;
    double leave = 0.0;
};

/// Returns where the way's line is inside the box grown by the way's reach.
[[nodiscard]] Stay stay_in(const Box& box, const Way& way);

/// Returns 0 inside the box.
[[nodiscard]] double distance_m(const Box& box, Position p);

/// Returns false only if the boxes are further apart than `reach_m`.
[[nodiscard]] bool overlap(const Box& a, const Box& b, double reach_m);

/// Returns the corners counter-clockwise.
[[nodiscard]] std::array<Position, 4> corners_of(const Box& box);

/// The extents of a box in 8 bytes: shares of the segment's length as the upper halves of floats,
/// rounded outward by less than 1 %.
class PackedExtents {
  public:
    PackedExtents() = default;

    /// Holds [along_low, along_high] x [across_low, across_high], finite or not.
    PackedExtents(double along_low, double along_high, double across_low, double across_high)
        : halves_{below(along_low), above(along_high), below(across_low), above(across_high)} {}

    [[nodiscard]] double along_low() const { return value(halves_[0]); }

    [[nodiscard]] double along_high() const { return value(halves_[1]); }

    [[nodiscard]] double across_low() const { return value(halves_[2]); }

    [[nodiscard]] double across_high() const { return value(halves_[3]); }

  private:
    static double value(std::uint16_t half) {
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(half) << 16));
    }

    /// Returns the largest number of this format that is not above x.
    static std::uint16_t below(double x) {
        const auto sign = static_cast<std::uint16_t>(0x8000);
        return static_cast<std::uint16_t>(above(-x) ^ sign);
    }

    /// Returns the smallest number of this format that is not below x.
    static std::uint16_t above(double x) {
        constexpr std::uint16_t largest = 0x7f7f;
        if (x >= least_regular && x <= value(largest)) return cut_above(x);
        if (!(x <= static_cast<double>(std::numeric_limits<float>::max()))) return largest;
        auto half =
            static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(static_cast<float>(x)) >> 16);
        while (value(half) < x) half = next_up(half);
        return half;
    }

    static constexpr double least_regular = 0x1p-126;

    /// The same for regular numbers of this format: the upper bits of the double, with another
    /// bias of the exponent.
    static std::uint16_t cut_above(double x) {
        constexpr int cut = 52 - 7;
        constexpr std::uint64_t below = (std::uint64_t{1} << cut) - 1;
        constexpr std::uint64_t bias = (1023U - 127U) << 7U;
        return static_cast<std::uint16_t>(((std::bit_cast<std::uint64_t>(x) + below) >> cut) -
                                          bias);
    }

    /// Rounds away from zero for positive numbers, towards it for negative ones.
    static std::uint16_t next_up(std::uint16_t half) {
        const bool is_negative = (half & 0x8000U) != 0;
        if (half == 0x8000U) return 0x0001U;
        return static_cast<std::uint16_t>(is_negative ? half - 1 : half + 1);
    }

    std::array<std::uint16_t, 4> halves_{};
};

/// Returns the box of a node in its segment's frame, with what it holds beside the segment.
[[nodiscard]] inline Box box_of(const Segment& s, const PackedExtents& e) {
    return {s.a, frame_axis(s), e.along_low(), e.along_high(), e.across_low(), e.across_high()};
}

/// Neighbouring nodes of one level: node k lies between points k and k + 1.
struct Fan {
    static constexpr int width = 4;

    const Position* points = nullptr;        // width + 1 may be read
    const PackedExtents* extents = nullptr;  // of width nodes; null: the segments themselves
    int count = 0;                           // nodes, 1 ... width; values read beyond are ignored

    [[nodiscard]] Box box(std::size_t k) const {
        const Segment s{points[k], points[k + 1]};
        return extents == nullptr ? box_of(s) : box_of(s, extents[k]);
    }
};

/// The result of a sift.
struct Sifted {
    unsigned near = 0;                    // bit k: node k may matter
    std::array<float, Fan::width> key{};  // smaller is nearer: here the share of the way at which
                                          // the box is entered, never later than what it holds
    float gap2_m2 = 0.0F;  // the other boxes stay at least this far (squared) out of reach
};

/// Conservative: coordinates are taken relative to the way's start before they are rounded, and the
/// reach is widened by 4e-6 of the distance, which is more than all rounding.
[[nodiscard]] Sifted sift(const Fan& fan, const Way& way);

/// Four boxes in the frames of their segments, in single precision, relative to a place.
struct FourBoxes {
    lanes::Points axis;
    lanes::Points origin;
    lanes::Floats square;  // of the axis's length; extents are times this
    lanes::Floats along_low, along_high, across_low, across_high;
    int count = 0;  // boxes, 1 ... 4
};

/// A fan made ready for the ways of many queries.
struct ReadyFan {
    Position place;
    FourBoxes boxes;
    float size_m = 0.0F;  // no box begins further from the place
};

[[nodiscard]] ReadyFan ready(const Fan& fan);

/// The same as for the fan, with the reach widened by 4e-6 of the fan's size too.
[[nodiscard]] Sifted sift(const ReadyFan& fan, const Way& way);

/// Which boxes of four neighbouring nodes are surely apart from those further along the outline.
struct Apart {
    unsigned by_two = 0;    // bit k: node k from node k + 2
    unsigned by_three = 0;  // bit k, 0 or 2: node k from node k + 3
};

/// A bit says that overlap() is false. Looks at nodes from 0 on, four for each of `apart`, and at
/// the four after them: so many points, one more, and so many extents may be read. `extents` as in
/// Fan. Conservative as sift().
void sift_ahead(const Position* points, const PackedExtents* extents, double reach_m,
                std::span<Apart> apart);

}  // namespace touchline
