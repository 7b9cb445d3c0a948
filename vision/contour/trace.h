// The outlines of a picture, as a map to be felt.
//
// picture -> at most 1 megapixel -> Lab -> Gaussian -> colour gradient -> lines of greatest
// gradient (sub-pixel) with hysteresis -> junctions, gaps, closing -> corners -> ranking ->
// TactileMap.
#pragma once

#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "vision/contour/edge_model.h"

#include <string>

#include <opencv2/core.hpp>

namespace touchline {

struct TraceOptions {
    Area area;
    int detail = 3;                   // 1 silhouette ... 5 all; outlines above it are left out
    EdgeModel* edge_model = nullptr;  // tells the boundaries instead of the gradient; not owned
};

/// What the tracer chose, found and left out. Pixels are working pixels: those of the picture after
/// the reduction to at most a megapixel.
struct TraceReport {
    double working_scale = 1.0;     // working pixels per pixel of the picture, <= 1
    double pixels_per_metre = 0.0;  // pixels of the picture (as given) on a metre of W
    double noise = 0.0;             // standard deviation, grey levels
    double smoothing_px = 0.0;      // Gaussian sigma
    double low = 0.0;               // hysteresis, grey levels per pixel
    double high = 0.0;
    int lines_found = 0;  // after hysteresis
    int gaps_closed = 0;
    int junctions = 0;       // places where three or more arms meet
    int specks_dropped = 0;  // shorter than a finger can follow
    int over_budget = 0;     // outlines beyond the budget of the finest detail
    int over_detail = 0;     // outlines that only a higher detail shows
    int outlines = 0;        // kept
    int points = 0;          // kept
    std::string warning;     // one sentence when outlines were cut to the budget, else empty
};

struct Trace {
    TactileMap map;
    TraceReport report;
    /// 8-bit, working size: how strong each candidate line is, 0 where there is none. 128 is the
    /// picture's own threshold `high`; strength = 255 r / (1 + r), r = mean gradient along 20
    /// pixels either way / high, less for short lines.
    cv::Mat edge_strength;
};

/// Traces an 8-bit picture, BGR or grey, already composed over white. The whole picture is centred
/// in the area, as large as fits, aspect kept, row down = W y down: W = ((x - cols/2), (rows/2 -
/// y)) / pixels_per_metre, x and y in pixels from the upper left corner of the upper left pixel.
/// Points are canonical (config/types/map_frame.h). Outlines come most salient first, ids
/// "outline-1"
/// ...; arms of a junction share their end point bit for bit.
/// Errors: an empty or unsupported matrix, an area or detail out of range, no outline found.
/// Deterministic. Threads: pure function (OpenCV may use its own threads inside). About 0.2 s a
/// megapixel.
[[nodiscard]] Result<Trace> trace_outlines(const cv::Mat& picture, const TraceOptions& options);

}  // namespace touchline
