// Every screen of visitor and operator as the kiosk makes it, for measuring and viewing.
#pragma once

#include "tests/app/screen/sample_screens.h"

#include <vector>

namespace touchline {

/// Returns one screen for each kind of screen of the visit and for each place of the operator, in a
/// language of every_language().
[[nodiscard]] std::vector<NamedScreen> every_screen(const Language& language);

}  // namespace touchline
