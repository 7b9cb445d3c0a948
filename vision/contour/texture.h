// Draws many short lines close together (grass, foliage, gravel, weave) as one outline round them
// all.
// Threads: pure function.
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

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

}  // namespace touchline
