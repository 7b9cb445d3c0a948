// Hands that hold through the skin, well and badly damped, beside the rigid ones of
// haptics/device/simulated/simulated_pantograph.h. The worst partner is a heavy arm behind a grip
// that damps little. Threads: immutable values.
#pragma once

#include "haptics/device/simulated/simulated_pantograph.h"

namespace touchline::stability {

/// Presses the device, but nobody holds it and nothing damps it.
inline constexpr HandModel soft_press{0.0, 0.0, 20.0, {}};

inline constexpr HandModel light_skin{0.02, 1.0, 50.0, HandModel::Skin{400.0, 1.0}};
inline constexpr HandModel light_bad_skin{0.02, 1.0, 50.0, HandModel::Skin{400.0, 0.2}};
inline constexpr HandModel normal_skin{0.10, 3.0, 300.0, HandModel::Skin{1000.0, 3.0}};
inline constexpr HandModel normal_bad_skin{0.10, 3.0, 300.0, HandModel::Skin{1000.0, 0.3}};
inline constexpr HandModel firm_skin{0.554, 6.45, 135.0, HandModel::Skin{3000.0, 8.0}};
inline constexpr HandModel arm_fair_skin{0.554, 6.45, 135.0, HandModel::Skin{2000.0, 2.0}};
inline constexpr HandModel arm_bad_skin{0.554, 6.45, 135.0, HandModel::Skin{2000.0, 0.5}};

}  // namespace touchline::stability
