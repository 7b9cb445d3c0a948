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

    /// Adds a line of some hundred strokes at most, fainter the older it is, with a gap where the
    /// hand jumped. It fades with each new place, and every 1.5 s while the hand rests: each change
    /// is a frame.
    void add_to(Strokes& strokes, const View& view, double width_px, Colour colour) const;

  private:
    struct Place {
        Position p_WH;
        std::int64_t at_ns;
    };

    std::deque<Place> places_;
    std::int64_t faded_ns_ = 0;  // ages are as of then
};

}  // namespace touchline
