#include "vision/contour/photo_lines.h"

#include "vision/contour/corners.h"
#include "vision/contour/edge_lines.h"
#include "vision/contour/linking.h"
#include "vision/contour/texture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double photo_pixels = 3e5;  // finer edges of a photo are texture, and cost time
constexpr double photo_smoothing_px = 2.0;
constexpr double longest_texture_mm = 20.0;
constexpr double smallest_texture_mm = 20.0;
// Shorter lines are pixels, whatever their size on the device.
constexpr double shortest_line_px = 8.0;
// Grey levels; more noise than that in an otherwise empty picture is its content.
constexpr double grain = 1.0;
constexpr double photo_blur_px = 0.8;  // sigma, of lens and sampling

/// The picture at working size, with its measurements.
struct Working {
    LabPicture lab;
    double noise = 0.0;
    double smoothing_px = 0.0;
};

Working measured(const cv::Mat& picture) {
    Working working;
    working.lab = to_lab(picture, full_colour);
    working.noise = noise_of(working.lab);
    working.smoothing_px = smoothing_for(working.lab, working.noise);
    return working;
}

Working prepared(const cv::Mat& picture) {
    const cv::Mat small = reduced(picture, working_pixels);
    Working working = measured(small);
    if (working.smoothing_px >= photo_smoothing_px &&
        static_cast<double>(small.total()) > photo_pixels) {
        return measured(reduced(small, photo_pixels));
    }
    return working;
}

Reach reach_for(cv::Size size, double smoothing_px, double shortest_px) {
    constexpr double gap_over_diagonal = 0.02;
    constexpr double least_gap_px = 6.0;
    Reach reach;
    reach.junction_px = 2.5 * smoothing_px + 2.0;
    reach.gap_px = std::max(least_gap_px, gap_over_diagonal * std::hypot(size.width, size.height));
    reach.blur_px = 1.5 * smoothing_px;
    reach.shortest_px = shortest_px;
    return reach;
}

int drop_specks(std::vector<Chain>& chains, double shortest_px) {
    return static_cast<int>(
        std::erase_if(chains, [&](const Chain& c) { return length_of(c) < shortest_px; }));
}

/// Merges lines that are too close together or too crowded for a hand.
std::vector<Chain> without_clutter(std::vector<Chain> chains, cv::Size size, double px_per_mm) {
    const double gap_px = least_apart_mm * px_per_mm;
    return with_textures_outlined(
        with_double_edges_merged(std::move(chains), size, gap_px), size,
        {gap_px, longest_texture_mm * px_per_mm, smallest_texture_mm * px_per_mm});
}

/// Finds the lines that these thresholds give.
void find(const GradientField& field, const Hysteresis& limits, double px_per_mm,
          PhotoLines& found) {
    std::vector<Chain> lines = edge_lines(field, limits);
    found.low = limits.low;
    found.high = limits.high;
    found.lines_found = static_cast<int>(lines.size());
    found.edge_strength = edge_strength(lines, found.size, limits.high);
    const double shortest_px = std::max(shortest_line_px, shortest_line_mm * px_per_mm);
    Linked network = linked(std::move(lines), found.size,
                            reach_for(found.size, found.smoothing_px, shortest_px));
    found.gaps_closed = network.gaps_closed;
    found.junctions = network.junctions;
    found.chains = std::move(network.chains);
    if (found.smoothing_px >= photo_smoothing_px) {
        found.chains = without_clutter(std::move(found.chains), found.size, px_per_mm);
    }
    found.specks_dropped = drop_specks(found.chains, shortest_px);
    const double blur_px = std::hypot(found.smoothing_px, photo_blur_px);
    for (Chain& chain : found.chains) {
        if (chain.of != LineOf::texture) chain = with_sharp_corners(chain, blur_px);
    }
}

}  // namespace

PhotoLines photo_lines(const cv::Mat& picture, double longer_side_mm) {
    const Working working = prepared(picture);
    const GradientField field = colour_gradient(working.lab, working.smoothing_px);
    PhotoLines found;
    found.size = working.lab.size();
    found.noise = working.noise;
    found.smoothing_px = working.smoothing_px;
    const double px_per_mm = std::max(found.size.width, found.size.height) / longer_side_mm;
    find(field, thresholds_for(field, working.noise, working.smoothing_px), px_per_mm, found);
    if (found.chains.empty() && working.noise >= grain) {
        find(field, grain_thresholds(field), px_per_mm, found);
        found.is_grain = true;
    }
    return found;
}

}  // namespace touchline
