// The short way to a document: a fixed stand whose bed has a mark at each corner. The operator
// calibrates once; from then on every picture of the bed is put upright without a search.
// Threads: pure functions.
#pragma once

#include "config/settings/stand.h"
#include "config/types/result.h"
#include "vision/prepare/quad.h"

namespace touchline {

/// Mark 0 lies outside the bed's upper left corner and touches it with its own lower right corner,
/// marks 1, 2, 3 likewise at upper right, lower right, lower left, all upright. Fails with the
/// sentence of CaptureTrouble::no_markers unless all four are found in a sensible place. `bed_mm`:
/// width and height of the bed, 50 ... 2000. 8-bit BGR.
[[nodiscard]] Result<StandSettings> calibrated_stand(const cv::Mat& bgr, cv::Size2d bed_mm);

/// The bed seen from above, at most `most_pixels`, from a picture of any size in the shape of the
/// calibration's. 8-bit BGR.
[[nodiscard]] cv::Mat bed_picture(const cv::Mat& bgr, const StandSettings& stand,
                                  double most_pixels = 1e6);

}  // namespace touchline
