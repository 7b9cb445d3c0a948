// The slow reference for the collision tree: all segments of one level or blend, looked at one by
// one with exact arithmetic (tests/exact). Knows nothing of boxes. Threads: values.
#pragma once

#include "haptics/curve/curve_set.h"

#include <optional>
#include <vector>

namespace touchline {

struct NamedSegment {
    SegmentRef ref;
    Segment segment;
};

/// The first point that a way has in common with any segment.
struct FirstMeeting {
    double share = 0.0;  // of the way, the exact one rounded to nearest
    SegmentRef lowest;   // of the segments met there
};

class LevelSegments {
  public:
    LevelSegments(const CurveSet& curves, double level);

    /// In the order of their names.
    [[nodiscard]] const std::vector<NamedSegment>& all() const { return all_; }

    [[nodiscard]] const Segment& segment(SegmentRef ref) const;

    [[nodiscard]] std::optional<FirstMeeting> first_meeting(Position from, Position to) const;

    /// Whether p is a point of any segment.
    [[nodiscard]] bool holds(Position p) const;

    /// Whether a ray from p upwards crosses the segments an odd number of times. Of closed curves:
    /// whether p, not on them, is inside an odd number of windings.
    [[nodiscard]] bool is_inside(Position p) const;

    /// From p to the nearest point of any segment, in extended precision; infinite where there is
    /// none.
    [[nodiscard]] long double distance_m(Position p) const;

  private:
    std::vector<NamedSegment> all_;
    std::vector<std::size_t> first_of_piece_;
};

/// From p to the nearest point of the segment, in extended precision.
[[nodiscard]] long double distance_m(Position p, const Segment& segment);

}  // namespace touchline
