#include "vision/contour/photo_lines.h"

#include "vision/contour/corners.h"
#include "vision/contour/edge_lines.h"
#include "vision/contour/linking.h"
#include "vision/contour/rings.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <opencv2/imgproc.hpp>

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

constexpr double cells_per_spacing = 2.0;
constexpr double smoothing_cells = 3.0;
constexpr double most_of_picture = 0.5;  // more is the picture itself
constexpr double mostly_there = 0.5;
constexpr int fewest_lines = 8;

class TextureMap {
  public:
    TextureMap(const std::vector<Chain>& chains, cv::Size picture, const TextureScale& scale)
        : chains_(chains),
          picture_(picture),
          scale_(scale),
          cell_px_(scale.spacing_px / cells_per_spacing) {
        const cv::Size cells(static_cast<int>(std::ceil(picture.width / cell_px_)),
                             static_cast<int>(std::ceil(picture.height / cell_px_)));
        density_ = cv::Mat1f(cells, 0.0F);
        for (const Chain& chain : chains) lengths_px_.push_back(length_of(chain));
        measure();
        find_areas();
        sort_lines();
    }

    [[nodiscard]] bool is_replaced(std::size_t chain) const {
        return area_of_[chain] > 0 && is_texture(area_of_[chain]);
    }

    /// Returns an outline round every area, once.
    [[nodiscard]] std::vector<Chain> outlines() const {
        std::vector<Chain> rings = iso_rings(density_, least_density());
        std::erase_if(rings, [&](const Chain& ring) {
            return area_within(ring) < 0.0 || !is_texture(area_at(ring));
        });
        for (Chain& ring : rings) {
            const Lines& lines = lines_in_[static_cast<std::size_t>(area_at(ring))];
            for (EdgePoint& p : ring.points) {
                p.at.x = std::min(cell_px_ * (p.at.x + 0.5), picture_.width * 1.0) - 0.5;
                p.at.y = std::min(cell_px_ * (p.at.y + 0.5), picture_.height * 1.0) - 0.5;
                p.strength = lines.strength / static_cast<double>(lines.points);
            }
            ring.of = LineOf::texture;
        }
        return rings;
    }

  private:
    struct Lines {
        int count = 0;
        std::size_t points = 0;
        double strength = 0.0;  // summed
    };

    bool is_short(std::size_t chain) const {
        return lengths_px_[chain] <= scale_.longest_px && !chains_[chain].points.empty();
    }

    cv::Point cell_of(const cv::Point2d& at) const {
        return {std::clamp(static_cast<int>((at.x + 0.5) / cell_px_), 0, density_.cols - 1),
                std::clamp(static_cast<int>((at.y + 0.5) / cell_px_), 0, density_.rows - 1)};
    }

    float least_density() const { return static_cast<float>(1.0 / scale_.spacing_px); }

    /// Measures the length of short lines per area, smoothed; what lies beyond the frame does not
    /// count.
    void measure() {
        for (std::size_t c = 0; c < chains_.size(); ++c) {
            const std::vector<EdgePoint>& points = chains_[c].points;
            for (std::size_t i = 1; is_short(c) && i < points.size(); ++i) {
                density_(cell_of(points[i].at)) += static_cast<float>(
                    distance(points[i - 1].at, points[i].at) / (cell_px_ * cell_px_));
            }
        }
        cv::Mat1f inside(density_.size(), 1.0F);
        for (cv::Mat1f* map : {&density_, &inside}) {
            cv::GaussianBlur(*map, *map, cv::Size(), smoothing_cells, smoothing_cells,
                             cv::BORDER_CONSTANT);
        }
        density_ /= inside;
    }

    void find_areas() {
        const cv::Mat is_dense = density_ >= least_density();
        cv::Mat1d centroids;
        cv::Mat1i stats;
        const int count =
            cv::connectedComponentsWithStats(is_dense, areas_, stats, centroids, 4, CV_32S);
        lines_in_.resize(static_cast<std::size_t>(count));
        for (int area = 0; area < count; ++area) {
            const double cells = stats(area, cv::CC_STAT_AREA);
            const bool is_wide =
                cells * cell_px_ * cell_px_ >= scale_.smallest_px * scale_.smallest_px;
            is_sized_.push_back(area > 0 && is_wide &&
                                cells <= most_of_picture * static_cast<double>(density_.total()));
        }
    }

    /// Finds the area of each short line: the one that most of its points are in, or 0.
    void sort_lines() {
        area_of_.assign(chains_.size(), 0);
        for (std::size_t c = 0; c < chains_.size(); ++c) {
            if (!is_short(c)) continue;
            const std::vector<EdgePoint>& points = chains_[c].points;
            const int area = areas_(cell_of(points[points.size() / 2].at));
            const auto there = std::ranges::count_if(
                points, [&](const EdgePoint& p) { return areas_(cell_of(p.at)) == area; });
            if (static_cast<double>(there) >= mostly_there * static_cast<double>(points.size())) {
                area_of_[c] = area;
                Lines& lines = lines_in_[static_cast<std::size_t>(area)];
                ++lines.count;
                lines.points += points.size();
                for (const EdgePoint& p : points) lines.strength += p.strength;
            }
        }
    }

    bool is_texture(int area) const {
        const auto i = static_cast<std::size_t>(area);
        return is_sized_[i] && lines_in_[i].count >= fewest_lines;
    }

    /// Returns the area inside a ring, from the high element beside its first crossing, which lies
    /// on a side between two elements of a row.
    int area_at(const Chain& ring) const {
        const cv::Point2d first = ring.points.front().at;
        return areas_(static_cast<int>(std::lround(first.y)), static_cast<int>(std::ceil(first.x)));
    }

    const std::vector<Chain>& chains_;
    cv::Size picture_;
    TextureScale scale_;
    double cell_px_;
    std::vector<double> lengths_px_;
    cv::Mat1f density_;
    cv::Mat1i areas_;  // of each cell, 0: none
    std::vector<bool> is_sized_;
    std::vector<Lines> lines_in_;
    std::vector<int> area_of_;  // of each line
};

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

std::vector<Chain> with_textures_outlined(std::vector<Chain> chains, cv::Size picture,
                                          const TextureScale& scale) {
    const TextureMap map(chains, picture, scale);
    std::vector<Chain> kept;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        if (!map.is_replaced(c)) kept.push_back(std::move(chains[c]));
    }
    std::ranges::move(map.outlines(), std::back_inserter(kept));
    return kept;
}

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
