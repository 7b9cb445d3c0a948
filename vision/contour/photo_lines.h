// Finds the lines of any picture as it is: edges, linked, corners restored.
//
// picture -> at most 1 megapixel -> Lab -> Gaussian -> colour gradient
// -> lines of greatest strength (sub-pixel) with hysteresis -> junctions, gaps, closing -> stripes,
// textures -> corners.
#pragma once

#include "vision/contour/chain.h"

#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// What counts as texture: many short lines close together (grass, foliage, gravel, weave).
/// Lengths in working pixels.
struct TextureScale {
    double spacing_px = 0.0;   // lines that lie closer than this cannot be told apart
    double longest_px = 0.0;   // a longer line is no texture, wherever it runs
    double smallest_px = 0.0;  // side of the smallest square that is worth an outline
};

/// Finds areas in which short lines are so dense that their mean spacing is below `spacing_px`
/// (their length per area, smoothed over about 1.5 spacings, above 1 / spacing). An area counts if
/// it is at least smallest_px^2 and at most half the picture, and eight or more lines lie there
/// with most of their length. Those lines go, and a closed line round the area (`LineOf::texture`,
/// strength: their mean) comes last. Holes in an area are not drawn. All other lines stay as they
/// are, in order. O(points + pixels / spacing^2).
[[nodiscard]] std::vector<Chain> with_textures_outlined(std::vector<Chain> chains, cv::Size picture,
                                                        const TextureScale& scale);

/// Lines are found in at most so many pixels: 0.1 mm each on a drawing area of 116 x 84 mm.
inline constexpr double working_pixels = 1e6;

/// Lines with the measurements made on the way. Pixels are working pixels: those of the picture
/// after the reduction to at most a megapixel.
struct PhotoLines {
    std::vector<Chain> chains;
    cv::Size size;              // working
    double noise = 0.0;         // standard deviation, grey levels
    double smoothing_px = 0.0;  // Gaussian sigma
    double low = 0.0;           // hysteresis, grey levels per pixel
    double high = 0.0;
    bool is_grain = false;  // nothing stands out: the lines are the picture's own noise
    int lines_found = 0;    // after hysteresis
    int gaps_closed = 0;
    int junctions = 0;       // places where three or more arms meet
    int specks_dropped = 0;  // shorter than 4 mm
    /// 8-bit, working size: how strong each candidate line is, 0 where there is none. 128 is the
    /// picture's own threshold `high`; strength = 255 r / (1 + r), r = mean gradient along 20
    /// pixels either way / high, less for short lines.
    cv::Mat edge_strength;
};

/// Returns the lines of an 8-bit picture, BGR or grey, whose longer side will be `longer_side_mm`
/// long at the handle; arms of a junction share their point bit for bit. Lines shorter than 4 mm
/// (and 8 working pixels) are specks. In photos, stripes narrower than 3.2 mm become one line and
/// textures one outline. Chains are empty if nothing was found. Throws cv::Exception without
/// memory. Deterministic. Threads: pure function (OpenCV may use its own threads inside).
/// O(pixels).
[[nodiscard]] PhotoLines photo_lines(const cv::Mat& picture, double longer_side_mm);

}  // namespace touchline
