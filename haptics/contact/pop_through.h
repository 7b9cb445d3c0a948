// A wall that lets a determined hand through: one that pushes hard, for a while, at one place.
// Threads: one, the servo's. No allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/contact/proxy_state.h"
#include "haptics/contact/rendered_outlines.h"

namespace touchline {

class PopThrough {
  public:
    /// Advances one tick of `dt_s`, before the proxy moves. Once K |handle - proxy| has been at
    /// least settings.pop_through_N for pop_through_s, and the proxy has not slid further than 0.5
    /// mm, puts the proxy on the other side of its edge, at the same parameter, free and as small
    /// as a point, and returns true. It never goes through a second line, nor where the line turns
    /// by a corner: there the proxy stays, and the push may go on elsewhere. Off (false) if
    /// pop_through_N is not above 0.
    [[nodiscard]] bool step(RenderedOutlines& outlines, Position handle,
                            const ContactSettings& settings, const Budget& budget, double dt_s,
                            ProxyState& proxy, int& boxes);

  private:
    double pushed_s_ = 0.0;
    Position place_;  // of the proxy when the push began
};

}  // namespace touchline
