// The shapes that a visitor may hold, and a shape's step reported like a point's.
// Threads: values and pure functions.
#pragma once

#include "config/types/hand_state.h"
#include "haptics/contact/contact_machine.h"
#include "haptics/probe/probe_proxy.h"
#include "haptics/probe/probe_shape.h"

namespace touchline {

/// Builds a shape as large as a thumb, so that it can turn among the outlines of a picture; none
/// gives a point. Allocates.
[[nodiscard]] ProbeShape held_shape(HeldShape shape);

/// Returns what events, sounds and screens know of a contact. If there are several, the first
/// counts.
[[nodiscard]] ContactReport contact_of(const ProbeReport& report, const CurveSet& curves);

}  // namespace touchline
