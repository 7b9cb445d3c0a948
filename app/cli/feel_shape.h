// touchline feel --probe: a held shape moves and turns over a map, one servo step per row.
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

inline constexpr double first_period_s = 1e-3;  // for a path with a single row

/// Loads the shape of options.probe, rounded by the radius of the options. The hand holds the
/// middle of its drawing area. The error names the file.
[[nodiscard]] Result<ProbeShape> load_shape(const FeelOptions& options);

/// RUN.csv: the columns of a point's run, then angle_rad, proxy_angle_rad and torque_Nm; step_ns
/// comes last if it was asked for. `limits` are those of the level rule.
[[nodiscard]] std::string feel_shape(const Scene& scene, const ProbeShape& shape,
                                     const FeelOptions& options, LevelLimits limits,
                                     const std::vector<HandRow>& hand);

}  // namespace touchline
