// The whole path from a picture to a map to be felt: the kind of picture, its lines, and those that
// a hand can follow.
#pragma once

#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "vision/contour/photo_lines.h"
#include "vision/prepare/picture_class.h"
#include "vision/simplify/simplify.h"

#include <optional>
#include <string>

#include <opencv2/core.hpp>

namespace touchline {

struct TraceOptions {
    Area area;
    int detail = 3;  // 1 silhouette ... 5 all
    Zoom zoom = {};
    std::optional<PictureClass> picture_class = std::nullopt;  // instead of the apparent one
};

/// What the tracer chose, found and left out.
struct TraceReport {
    double working_scale = 1.0;     // working pixels per pixel of the picture, <= 1
    double pixels_per_metre = 0.0;  // pixels of the picture (as given) on a metre of W
    ClassDecision decision;         // the kind of picture it was taken for
    PhotoLines found;               // without its chains
    SimplifyReport simplified;
    int outlines = 0;     // of the map
    int points = 0;       // of the map
    std::string warning;  // one sentence if a visitor should expect little, else empty
};

struct Trace {
    TactileMap map;
    TraceReport report;
};

/// A picture's lines, for every detail and zoom, and the measurements made on the way.
struct Found {
    PictureLines lines;
    ClassDecision decision;
    PhotoLines report;  // without its chains
};

/// 1 mm to 1 m on each side; false for NaN.
[[nodiscard]] bool is_usable(const Area& area);

/// Decides what kind of picture it is, unless the options do, and finds its lines. 8-bit, BGR or
/// grey, already composed over white; of the options, only area and class count. `figure`: the mask
/// of a photo's main things (vision/figure); empty: none, or none that is sure. Errors: an empty or
/// unsupported matrix, an area out of range, no line found. Deterministic. Threads: pure function
/// (OpenCV may use its own threads inside). About 0.2 s a megapixel.
[[nodiscard]] Result<Found> find_lines(const cv::Mat& picture, const TraceOptions& options,
                                       const cv::Mat1b& figure = {});

/// Returns the map of one detail and zoom. Errors: area, detail or zoom out of range, no line
/// there.
[[nodiscard]] Result<Trace> trace_lines(const Found& found, const TraceOptions& options);

/// Does both. The whole picture (zoom factor 1) is centred in the area, as large as fits, aspect
/// kept, row down = W y down: W = ((x - cols/2), (rows/2 - y)) / pixels_per_metre, x and y in
/// pixels from the upper left corner of the upper left pixel.
[[nodiscard]] Result<Trace> trace_outlines(const cv::Mat& picture, const TraceOptions& options,
                                           const cv::Mat1b& figure = {});

}  // namespace touchline
