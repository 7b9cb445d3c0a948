#include "haptics/collision/box.h"

#include "haptics/collision/lanes.h"

#include <cstring>

namespace touchline {
namespace {

/// Returns true if `other` lies further than `reach_m` outside one side of the box.
bool separates(const Box& box, const Box& other, double reach_m) {
    const Shadow at = shadow(other, box.origin, box.axis);
    const double square = dot(box.axis, box.axis);
    const double grow = reach_m * length_bound(box.axis);
    return (at.along_low > box.along_high * square + grow) |
           (at.along_high < box.along_low * square - grow) |
           (at.across_low > box.across_high * square + grow) |
           (at.across_high < box.across_low * square - grow);
}

using namespace lanes;

using Halves = std::uint16_t __attribute__((vector_size(16)));

struct Extents {
    Floats along_low, along_high, across_low, across_high;
};

Floats upper_halves(Halves low_first) {
    Floats out;
    std::memcpy(&out, &low_first, sizeof out);
    return out;
}

/// Transposes four packed extents: a half is the upper part of a float.
Extents unpacked(const PackedExtents* four) {
    Halves first;
    Halves second;
    std::memcpy(&first, four, sizeof first);
    std::memcpy(&second, four + 2, sizeof second);
    constexpr Halves zero{};
    const Halves even = __builtin_shufflevector(first, second, 0, 8, 1, 9, 2, 10, 3, 11);
    const Halves odd = __builtin_shufflevector(first, second, 4, 12, 5, 13, 6, 14, 7, 15);
    const Halves along = __builtin_shufflevector(even, odd, 0, 8, 1, 9, 2, 10, 3, 11);
    const Halves across = __builtin_shufflevector(even, odd, 4, 12, 5, 13, 6, 14, 7, 15);
    const auto low = [&](Halves h) {
        return upper_halves(__builtin_shufflevector(zero, h, 0, 8, 1, 9, 2, 10, 3, 11));
    };
    const auto high = [&](Halves h) {
        return upper_halves(__builtin_shufflevector(zero, h, 4, 12, 5, 13, 6, 14, 7, 15));
    };
    return {low(along), high(along), low(across), high(across)};
}

/// Shares of the way at which it enters the slabs; 0 if it starts inside or never gets there.
Floats slab_entry(Floats start, Floats by, Floats low, Floats high) {
    const Floats border = start < low ? low : (start > high ? high : start);
    const Floats entry = (border - start) / by;
    const Masks is_share = (entry > 0.0F) & (entry <= 1.0F);
    return is_share ? entry : Floats{};
}

/// Four boxes in the frames of their segments; of bare segments the extents are not looked at.
struct Four {
    Points axis;
    Extents extents;
};

constexpr Extents bare_segments{{0, 0, 0, 0}, {1, 1, 1, 1}, {0, 0, 0, 0}, {0, 0, 0, 0}};

template <bool are_bare>
[[gnu::always_inline]] inline Four four_of(const Position* points, const PackedExtents* extents) {
    const Pair p1 = pair(points[1]);
    const Pair p2 = pair(points[2]);
    const Pair p3 = pair(points[3]);
    return {rounded(p1 - pair(points[0]), p2 - p1, p3 - p2, pair(points[4]) - p3),
            are_bare ? bare_segments : unpacked(extents)};
}

template <int by>
Four nodes_moved_on(const Four& four, const Four& next) {
    const Extents& e = four.extents;
    const Extents& f = next.extents;
    return {moved_on<by>(four.axis, next.axis),
            {moved_on<by>(e.along_low, f.along_low), moved_on<by>(e.along_high, f.along_high),
             moved_on<by>(e.across_low, f.across_low), moved_on<by>(e.across_high, f.across_high)}};
}

/// Returns at least how far the boxes go from their origins, in lengths of their axes.
template <bool are_bare>
[[gnu::always_inline]] inline Floats reaches(const Extents& e) {
    if constexpr (are_bare) return Floats{1, 1, 1, 1};
    return larger(absolute(e.along_low), absolute(e.along_high)) +
           larger(absolute(e.across_low), absolute(e.across_high));
}

struct Range {
    Floats low, high;
};

/// Returns the extents of boxes along other axes, from their origins on. `c` and `d` are the dot
/// and the cross products of those axes with their own.
template <bool are_bare>
[[gnu::always_inline]] inline Range along_axis(const Extents& e, Floats c, Floats d) {
    if constexpr (are_bare) return {smaller(c, Floats{}), larger(c, Floats{})};
    const Floats u[] = {e.along_low * c, e.along_high * c};
    const Floats v[] = {e.across_low * d, e.across_high * d};
    return {smaller(u[0], u[1]) - larger(v[0], v[1]), larger(u[0], u[1]) - smaller(v[0], v[1])};
}

/// The same across the other axes.
template <bool are_bare>
[[gnu::always_inline]] inline Range across_axis(const Extents& e, Floats c, Floats d) {
    if constexpr (are_bare) return {smaller(d, Floats{}), larger(d, Floats{})};
    const Floats u[] = {e.along_low * d, e.along_high * d};
    const Floats v[] = {e.across_low * c, e.across_high * c};
    return {smaller(u[0], u[1]) + smaller(v[0], v[1]), larger(u[0], u[1]) + larger(v[0], v[1])};
}

/// Returns the lanes where `other`, whose origin lies `by` away, lies further outside any one side
/// of `box` than `margin`: as separates().
template <bool are_bare>
Masks lies_outside(const Four& box, const Four& other, const Points& by, Floats margin) {
    const Points& a = box.axis;
    const Points& b = other.axis;
    const Extents& own = box.extents;
    const Floats square = a.x * a.x + a.y * a.y;
    const Floats s = a.x * by.x + a.y * by.y;
    const Floats n = a.x * by.y - a.y * by.x;
    const Floats c = a.x * b.x + a.y * b.y;
    const Floats d = a.x * b.y - a.y * b.x;
    const Range along = along_axis<are_bare>(other.extents, c, d);
    const Range across = across_axis<are_bare>(other.extents, c, d);
    const Floats beyond = s + along.low - own.along_high * square;
    const Floats before = own.along_low * square - s - along.high;
    const Floats left = n + across.low - own.across_high * square;
    const Floats right = own.across_low * square - n - across.high;
    return larger(larger(beyond, before), larger(left, right)) > margin;
}

/// Returns those of the wanted lanes where overlap() of the two is surely false. The origin of
/// `far` lies `by` away from that of `near`, over a way of length `way`.
template <bool are_bare>
[[gnu::always_inline]] inline unsigned lanes_apart(const Four& near, const Four& far,
                                                   const Points& by, Floats way, float reach,
                                                   unsigned wanted) {
    constexpr Masks bits{1, 2, 4, 8};
    const Points& a = near.axis;
    const Points& b = far.axis;
    const Floats length_a = length_bounds(a);
    const Floats length_b = length_bounds(b);
    const Floats size = way + reaches<are_bare>(near.extents) * length_a +
                        reaches<are_bare>(far.extents) * length_b;
    const Floats apart = reach + 4e-6F * size;
    const Floats square_a = a.x * a.x + a.y * a.y;
    const Floats square_b = b.x * b.x + b.y * b.y;
    // An axis too short for its square says nothing.
    const Masks is_known = (square_a > 1e-29F) & (square_b > 1e-29F) & bits;
    const Floats c = a.x * b.x + a.y * b.y;
    const Floats d = a.x * b.y - a.y * b.x;
    // Most neighbours begin beyond the end of one, or end before the begin of the other.
    const Floats begin = a.x * by.x + a.y * by.y + along_axis<are_bare>(far.extents, c, d).low;
    const Floats begin_at = are_bare ? square_a : near.extents.along_high * square_a;
    const Masks begins_beyond = begin - begin_at > apart * length_a;
    unsigned found = gathered(begins_beyond & is_known);
    if ((found & wanted) == wanted) return wanted;
    const Floats end = along_axis<are_bare>(near.extents, c, -d).high - b.x * by.x - b.y * by.y;
    const Floats end_at = are_bare ? Floats{} : far.extents.along_low * square_b;
    const Masks ends_before = end_at - end > apart * length_b;
    found |= gathered(ends_before & is_known);
    if ((found & wanted) == wanted) return wanted;
    const Points back{-by.x, -by.y};
    return gathered((lies_outside<are_bare>(near, far, by, apart * length_a) |
                     lies_outside<are_bare>(far, near, back, apart * length_b)) &
                    is_known) &
           wanted;
}

template <bool are_bare>
void sift_fours(const Position* points, const PackedExtents* extents, float reach,
                std::span<Apart> apart) {
    Four near = four_of<are_bare>(points, extents);
    for (Apart& out : apart) {
        points += Fan::width;
        if constexpr (!are_bare) extents += Fan::width;
        const Four far = four_of<are_bare>(points, extents);
        const Points second = moved_on<1>(near.axis, far.axis);
        const Four two = nodes_moved_on<2>(near, far);
        const Points by_two{near.axis.x + second.x, near.axis.y + second.y};
        const Points by_three{by_two.x + two.axis.x, by_two.y + two.axis.y};
        const Floats way = length_bounds(near.axis) + length_bounds(second);
        out = {lanes_apart<are_bare>(near, two, by_two, way, reach, 0b1111U),
               lanes_apart<are_bare>(near, nodes_moved_on<3>(near, far), by_three,
                                     way + length_bounds(two.axis), reach, 0b0101U)};
        near = far;
    }
}

float least(Floats a) {
    const Floats halves = smaller(a, __builtin_shufflevector(a, a, 2, 3, 0, 1));
    return smaller(halves, __builtin_shufflevector(halves, halves, 1, 0, 3, 2))[0];
}

FourBoxes boxes_of(const Fan& fan, Position place) {
    static_assert(sizeof(PackedExtents) == 8);
    const Extents e = fan.extents != nullptr ? unpacked(fan.extents) : bare_segments;
    const Pair from = pair(place);
    const Pair p0 = pair(fan.points[0]);
    const Pair p1 = pair(fan.points[1]);
    const Pair p2 = pair(fan.points[2]);
    const Pair p3 = pair(fan.points[3]);
    const Pair p4 = pair(fan.points[4]);
    const Points axis = rounded(p1 - p0, p2 - p1, p3 - p2, p4 - p3);
    const Points origin = rounded(p0 - from, p1 - from, p2 - from, p3 - from);
    const Floats square = axis.x * axis.x + axis.y * axis.y;
    return {axis,
            origin,
            square,
            e.along_low * square,
            e.along_high * square,
            e.across_low * square,
            e.across_high * square,
            fan.count};
}

/// `w`: the way's start, seen from the boxes' origins; `size_m`: what was rounded besides, at most.
[[gnu::always_inline]] inline Sifted sift_boxes(const FourBoxes& boxes, const Points& w,
                                                const Way& way, float size_m) {
    const Points& axis = boxes.axis;
    const auto by_x = static_cast<float>(way.by.x);
    const auto by_y = static_cast<float>(way.by.y);
    const auto reach = static_cast<float>(way.reach_m * (1.0 + 1e-6));
    const Floats distance = length_bounds(w) + (size_m + static_cast<float>(length_bound(way.by)));
    const Floats grow = (reach + 4e-6F * distance) * length_bounds(axis);
    const Floats s = dot(axis, w);
    const Floats n = cross(axis, w);
    const Floats ds = axis.x * by_x + axis.y * by_y;
    const Floats dn = axis.x * by_y - axis.y * by_x;
    const Floats s_low = boxes.along_low - grow;
    const Floats s_high = boxes.along_high + grow;
    const Floats n_low = boxes.across_low - grow;
    const Floats n_high = boxes.across_high + grow;
    const Floats beside = larger(s_low - larger(s, s + ds), smaller(s, s + ds) - s_high);
    const Floats off = larger(n_low - larger(n, n + dn), smaller(n, n + dn) - n_high);
    const Floats gap = larger(beside, off);
    const Floats turn = ds * (n_low + n_high - 2.0F * n) - dn * (s_low + s_high - 2.0F * s);
    const Floats room = absolute(ds) * (n_high - n_low) + absolute(dn) * (s_high - s_low);
    // An axis too short for its square says nothing, so such a box counts as near.
    const Masks is_known = boxes.square > 1e-30F;
    const Masks is_beside = (gap > 0.0F) & is_known;
    const Masks is_passed = (absolute(turn) > 1.000002F * room) & is_known;
    const Floats none = Floats{} + std::numeric_limits<float>::infinity();
    const Floats gap2 = is_beside ? gap * gap / boxes.square : (is_passed ? Floats{} : none);
    const Masks counted = Masks{0, 1, 2, 3} < boxes.count;
    const Masks near = ~(is_beside | is_passed) & counted & Masks{1, 2, 4, 8};
    Sifted out;
    out.near = gathered(near);
    out.gap2_m2 = least(counted ? gap2 : none);
    if (out.near == 0) return out;
    const Floats along = slab_entry(s, ds, s_low, s_high);
    const Floats across = slab_entry(n, dn, n_low, n_high);
    const Floats entry = is_known ? larger(along, across) : Floats{};
    std::memcpy(out.key.data(), &entry, sizeof entry);
    return out;
}

}  // namespace

Stay stay_in(const Box& box, const Way& way) {
    constexpr double far = std::numeric_limits<double>::infinity();
    const double square = dot(box.axis, box.axis);
    const double grow = way.reach_m * std::sqrt(square);
    const auto slab = [=](double start, double by, double low, double high) {
        const double before = low * square - grow - start;
        const double after = high * square + grow - start;
        if (by == 0.0) return before <= 0.0 && after >= 0.0 ? Stay{-far, far} : Stay{};
        return by > 0.0 ? Stay{before / by, after / by} : Stay{after / by, before / by};
    };
    const Position w = way.from - box.origin;
    const Stay along = slab(dot(box.axis, w), dot(box.axis, way.by), box.along_low, box.along_high);
    const Stay across =
        slab(cross(box.axis, w), cross(box.axis, way.by), box.across_low, box.across_high);
    return {std::max(along.enter, across.enter), std::min(along.leave, across.leave)};
}

double distance_m(const Box& box, Position p) {
    const double square = dot(box.axis, box.axis);
    const double s = dot(box.axis, p - box.origin);
    const double n = cross(box.axis, p - box.origin);
    const double beside = std::max({0.0, box.along_low * square - s, s - box.along_high * square});
    const double off = std::max({0.0, box.across_low * square - n, n - box.across_high * square});
    return std::sqrt((beside * beside + off * off) / square);
}

std::array<Position, 4> corners_of(const Box& box) {
    const auto at = [&box](double s, double n) {
        return box.origin + s * box.axis + n * left_of(box.axis);
    };
    return {at(box.along_low, box.across_low), at(box.along_high, box.across_low),
            at(box.along_high, box.across_high), at(box.along_low, box.across_high)};
}

bool overlap(const Box& a, const Box& b, double reach_m) {
    return !separates(a, b, reach_m) && !separates(b, a, reach_m);
}

Sifted sift(const Fan& fan, const Way& way) {
    const FourBoxes boxes = boxes_of(fan, way.from);
    return sift_boxes(boxes, {-boxes.origin.x, -boxes.origin.y}, way, 0.0F);
}

ReadyFan ready(const Fan& fan) {
    const Position place = fan.points[0];
    ReadyFan out{place, boxes_of(fan, place), 0.0F};
    for (std::size_t k = 1; k < static_cast<std::size_t>(fan.count); ++k) {
        const double away_m = length_bound(fan.points[k] - place);
        out.size_m = std::max(out.size_m, static_cast<float>(away_m));
    }
    return out;
}

Sifted sift(const ReadyFan& fan, const Way& way) {
    const Position from = way.from - fan.place;
    const auto x = static_cast<float>(from.x);
    const auto y = static_cast<float>(from.y);
    const Points w{x - fan.boxes.origin.x, y - fan.boxes.origin.y};
    return sift_boxes(fan.boxes, w, way, fan.size_m);
}

void sift_ahead(const Position* points, const PackedExtents* extents, double reach_m,
                std::span<Apart> apart) {
    const auto reach = static_cast<float>(reach_m);
    if (extents == nullptr) {
        sift_fours<true>(points, extents, reach, apart);
    } else {
        sift_fours<false>(points, extents, reach, apart);
    }
}

}  // namespace touchline
