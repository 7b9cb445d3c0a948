// Tests up to four neighbouring boxes against one way at once, in single precision: most boxes that
// a walk looks at are far from the motion, and four at a time cost little more than one. The exact
// test then judges those that may be near. Threads: pure functions, no allocation.
#pragma once

#include "haptics/collision/box.h"
#include "haptics/collision/packed_extents.h"

#include <array>
#include <cstdint>

namespace touchline {

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

}  // namespace touchline
