// Finds which of the two edges of a sharp tip is touched. Threads: one, the servo's. No allocation.
#pragma once

#include "haptics/collision/touch.h"
#include "haptics/contact/proxy_state.h"
#include "haptics/contact/rendered_outlines.h"

#include <optional>

namespace touchline {

/// Both edges of a sharp tip (under 25 degrees) are touched at the same moment within the tolerance
/// of a sweep. If the touched side of `segment` lies inside the tip, returns the contact with the
/// edge in front of it; else nothing. O(1).
[[nodiscard]] std::optional<Contact> contact_in_front(RenderedOutlines& outlines,
                                                      SegmentRef segment, const Touch& touch);

}  // namespace touchline
