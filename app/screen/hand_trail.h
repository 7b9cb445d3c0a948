// Where the hand has been, for who looks on: a line that fades.
// Threads: a plain value; one thread's.
#pragma once

#include "app/screen/marks.h"

#include <cstdint>
#include <deque>

namespace touchline {

class HandTrail {
  public:
    /// The hand is here now. A place that is not finite, or less than half a millimetre away from
    /// the last one, adds nothing. `now_ns` never goes back.
    void add(Position p_WH, std::int64_t now_ns);

    void clear() { places_.clear(); }

    /// Adds a line of some hundred strokes at most, fainter the older it is. It fades in steps of a
    /// quarter of a second.
    void add_to(Strokes& strokes, const View& view, std::int64_t now_ns, double width_px,
                Colour colour) const;

  private:
    struct Place {
        Position p_WH;
        std::int64_t at_ns;
    };

    std::deque<Place> places_;
};

}  // namespace touchline
