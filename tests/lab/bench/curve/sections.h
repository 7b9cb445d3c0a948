// The sections of the bench: each measures, then writes its CSV or data to plot, and its words.
// Threads: one.
#pragma once

#include "tests/lab/bench/curve/report.h"

namespace touchline::bench {

/// Measures how far coarse curves lie from real outlines, by method and level, and how wide their
/// boxes are.
[[nodiscard]] Result<void> measure_errors(const Folders& folders);

/// Measures the same on curves that are known without their noise.
[[nodiscard]] Result<void> measure_noise(const Folders& folders);

/// Measures how long the methods take.
[[nodiscard]] Result<void> measure_times(const Folders& folders);

/// Measures how many points resampling keeps of the gallery's pictures.
[[nodiscard]] Result<void> measure_points(const Folders& folders);

/// Writes the data of the paper's Figs. 1 to 3: coefficients and approximations.
[[nodiscard]] Result<void> plot_levels(const Folders& folders);

/// Writes the data of the paper's Fig. 4: boundary sections as a handle approaches.
[[nodiscard]] Result<void> plot_sections(const Folders& folders);

/// Paints the paper's Fig. 7: curve and error boxes over the picture.
[[nodiscard]] Result<void> paint_boxes(const Folders& folders);

}  // namespace touchline::bench
