// The shapes that a visitor may hold, and a shape's step in the words of a point's.
// Threads: values and pure functions.
#pragma once

#include "config/types/held_shape.h"
#include "haptics/contact/contact_machine.h"
#include "haptics/probe/probe_proxy.h"
#include "haptics/probe/probe_shape.h"

namespace touchline {

/// As large as a thumb, so that they turn among the outlines of a picture; none: a point.
/// Allocates.
[[nodiscard]] ProbeShape held_shape(HeldShape shape);

/// What events, sounds and screens know of a contact. Of several the first counts.
[[nodiscard]] ContactReport contact_of(const ProbeReport& report, const CurveSet& curves);

}  // namespace touchline
