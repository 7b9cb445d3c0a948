// touchline feel --probe: a shape in the hand moves and turns over a map, one servo step a row.
// Threads: one.
#pragma once

#include "app/cli/feel.h"
#include "app/cli/hand_csv.h"
#include "haptics/collision/scene.h"
#include "haptics/probe/probe_shape.h"
#include "haptics/resolution/level_rule.h"

#include <string>
#include <vector>

namespace touchline {

inline constexpr double first_period_s = 1e-3;  // of a path with a single row

/// The shape of options.probe, rounded by the radius of the options; the hand holds the middle of
/// its drawing area. The error names the file.
[[nodiscard]] Result<ProbeShape> load_shape(const FeelOptions& options);

/// RUN.csv: the columns of a point's run, then angle_rad, proxy_angle_rad and torque_Nm; where
/// asked for, step_ns last. `limits` are those of the level rule.
[[nodiscard]] std::string feel_shape(const Scene& scene, const ProbeShape& shape,
                                     const FeelOptions& options, LevelLimits limits,
                                     const std::vector<HandRow>& hand);

}  // namespace touchline
