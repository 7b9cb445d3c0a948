// Every screen of visitor and operator as the kiosk makes it, to be measured and looked at.
#pragma once

#include "tests/app/screen/sample_screens.h"

#include <vector>

namespace touchline {

/// Of the visit one for each of its screens, of the operator one for each place; in a language of
/// every_language().
[[nodiscard]] std::vector<NamedScreen> every_screen(const Language& language);

}  // namespace touchline
