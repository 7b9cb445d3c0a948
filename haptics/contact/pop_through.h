// A wall that lets a hand through which means it: a strong push that lasts, at one place.
// Threads: one, the servo's. No allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/contact/proxy_state.h"
#include "haptics/contact/rendered_outlines.h"

namespace touchline {

class PopThrough {
  public:
    /// One tick of `dt_s`, before the proxy moves. Once K |handle - proxy| has been at least
    /// settings.pop_through_N for pop_through_s and the proxy has not slid further than 0.5 mm,
    /// the proxy is put on the other side of the edge that it lies on, at the same parameter,
    /// free and as small as a point: then true. Never through a second line, nor where the line
    /// turns by a corner: there it stays, and the push may go on elsewhere. Off (false) where the
    /// force is not above 0.
    [[nodiscard]] bool step(RenderedOutlines& outlines, Position handle,
                            const ContactSettings& settings, const Budget& budget, double dt_s,
                            ProxyState& proxy, int& boxes);

  private:
    double pushed_s_ = 0.0;
    Position place_;  // of the proxy when the push began
};

}  // namespace touchline
