// The slow reference for the collision tree: looks at all segments of one level or blend one by
// one, with exact arithmetic (tests/exact). Knows nothing of boxes. Threads: values.
#pragma once

#include "haptics/curve/curve_set.h"

#include <optional>
#include <vector>

namespace touchline {

struct NamedSegment {
    SegmentRef ref;
    Segment segment;
};

/// The first point that a way shares with any segment.
struct FirstMeeting {
    double share = 0.0;  // of the way, the exact one rounded to nearest
    SegmentRef lowest;   // of the segments met there
};

class LevelSegments {
  public:
    LevelSegments(const CurveSet& curves, double level);

    /// All segments in the order of their names.
    [[nodiscard]] const std::vector<NamedSegment>& all() const { return all_; }

    [[nodiscard]] const Segment& segment(SegmentRef ref) const;

    [[nodiscard]] std::optional<FirstMeeting> first_meeting(Position from, Position to) const;

    /// Whether p lies on any segment.
    [[nodiscard]] bool holds(Position p) const;

    /// Whether a ray from p upwards crosses the segments an odd number of times. For closed curves
    /// and p not on them: whether p is inside an odd number of windings.
    [[nodiscard]] bool is_inside(Position p) const;

    /// Distance from p to the nearest point of any segment, in extended precision; infinite if
    /// there is none.
    [[nodiscard]] long double distance_m(Position p) const;

  private:
    std::vector<NamedSegment> all_;
    std::vector<std::size_t> first_of_piece_;
};

/// Distance from p to the nearest point of the segment, in extended precision.
[[nodiscard]] long double distance_m(Position p, const Segment& segment);

}  // namespace touchline
