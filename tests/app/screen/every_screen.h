// Every screen of visitor and operator as the kiosk makes it, for measuring and viewing.
#pragma once

#include "app/operator/operator.h"
#include "app/visit/visit.h"
#include "tests/app/screen/sample_screens.h"

#include <optional>
#include <vector>

namespace touchline {

// They are in a language of every_language().

/// Empty if no visit opens this screen.
[[nodiscard]] std::optional<SpokenScreen> visit_screen(VisitScreen wanted,
                                                       const Language& language);

/// A drawing of two lines.
[[nodiscard]] SpokenScreen drawing_screen(const Language& language);

/// As in a house where much happens, and something is broken.
[[nodiscard]] SpokenScreen staff_screen(OperatorPlace place, const Language& language);

/// One screen for each kind of screen of the visit, one of a drawing, and one for each place of the
/// operator.
[[nodiscard]] std::vector<NamedScreen> every_screen(const Language& language);

}  // namespace touchline
