#include "vision/figure/figure_colours.h"

#include "vision/contour/fixed_random_state.h"
#include "vision/contour/ink_parts.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int coarse_side_px = 224;   // of the longer side
constexpr int finest_side_px = 500;   // a smaller picture is not enlarged to it
constexpr float figure_limit = 0.3F;  // of figures.h
constexpr float just_above = 1.01F * figure_limit;
constexpr float just_below = 0.99F * figure_limit;
constexpr float beside_ring = 0.1F;  // a place next to the ring is that far from the limit
// Measured on held-out photographs: tests/lab/figure_network/README.md.
constexpr float surely_figure = 0.9F;
constexpr float surely_ground = 0.04F;
constexpr int coarse_rounds = 2;
constexpr double least_agreement = 0.4;  // intersection over union
constexpr double band_share = 0.03;      // of the longer side, to either side of the coarse ring
constexpr double deepest_share = 0.6;    // of a thing's depth: a thin one has sure places too

cv::Mat3b copy_of(const cv::Mat3b& picture, int longer_side_px) {
    const double scale = static_cast<double>(longer_side_px) / std::max(picture.cols, picture.rows);
    const cv::Size size(std::max(1, cvRound(scale * picture.cols)),
                        std::max(1, cvRound(scale * picture.rows)));
    cv::Mat3b copy;
    cv::resize(picture, copy, size, 0.0, 0.0, scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
    return copy;
}

cv::Mat1f fitted(const cv::Mat1f& likelihood, cv::Size size) {
    cv::Mat1f map;
    cv::resize(likelihood, map, size, 0.0, 0.0, cv::INTER_LINEAR);
    return map;
}

/// Moves the limit of a likelihood to that of figures.h.
float at_figure_limit(float likelihood, float limit) {
    if (likelihood < limit) return figure_limit * likelihood / limit;
    return figure_limit + (1.0F - figure_limit) * (likelihood - limit) / (1.0F - limit);
}

/// Returns what GrabCut takes for the figure, 255; nothing if the seed is all figure or all ground.
cv::Mat cut(cv::Mat1b seed, int rounds, const cv::Mat3b& picture) {
    const int figure = cv::countNonZero(seed & 1);
    if (figure == 0 || figure == static_cast<int>(seed.total())) return {};
    const FixedRandomState fixed;
    cv::Mat background;
    cv::Mat foreground;
    cv::grabCut(picture, seed, {}, background, foreground, rounds, cv::GC_INIT_WITH_MASK);
    return (seed & 1) * 255;
}

/// `is_figure`: 255 there. Certain are those places alone that the likelihood is sure of.
cv::Mat1b seed_of(const cv::Mat1f& likelihood, const cv::Mat1b& is_figure) {
    cv::Mat1b seed(likelihood.size());
    std::ranges::transform(likelihood, is_figure, seed.begin(),
                           [](float value, uchar figure) -> uchar {
                               if (value > surely_figure) return cv::GC_FGD;
                               if (value < surely_ground) return cv::GC_BGD;
                               return figure != 0 ? cv::GC_PR_FGD : cv::GC_PR_BGD;
                           });
    return seed;
}

/// Draws a coarse cut again, finer, in a band round its ring.
cv::Mat drawn_finer(const cv::Mat& coarse, const cv::Mat1f& likelihood, const cv::Mat3b& picture) {
    cv::Mat1b figure;
    cv::resize(coarse, figure, picture.size(), 0.0, 0.0, cv::INTER_LINEAR);
    cv::threshold(figure, figure, 127, 255, cv::THRESH_BINARY);
    const cv::Mat1f depth_px = depth_of(figure);
    double deepest_px = 0.0;
    cv::minMaxLoc(depth_px, nullptr, &deepest_px);
    const double band_px = band_share * std::max(picture.cols, picture.rows);
    cv::Mat1b seed = seed_of(likelihood, figure);
    seed.setTo(cv::GC_FGD, depth_px > std::min(band_px, deepest_share * deepest_px));
    seed.setTo(cv::GC_BGD, depth_of(~figure) > band_px);
    cv::Mat fine = cut(seed, 1, picture);
    if (!fine.empty()) cv::medianBlur(fine, fine, 3);
    return fine;
}

/// Moves a likelihood to the sides of the limit that a cut says. Places on both sides of its ring
/// are equally far from the limit, so that the ring lies in the middle between them: it would move
/// by up to a pixel towards those nearer to the limit.
void divide(const cv::Mat1b& figure, cv::Mat1f& likelihood) {
    std::ranges::transform(
        likelihood, figure, likelihood.begin(), [](float value, uchar is_figure) {
            return is_figure != 0 ? std::max(value, just_above) : std::min(value, just_below);
        });
    cv::Mat inner;
    cv::Mat outer;
    cv::erode(figure, inner, {});
    cv::dilate(figure, outer, {});
    likelihood.setTo(figure_limit + beside_ring, figure & ~inner);
    likelihood.setTo(figure_limit - beside_ring, outer & ~figure);
}

bool agree(const cv::Mat& one, const cv::Mat& other) {
    return cv::countNonZero(one & other) >= least_agreement * cv::countNonZero(one | other);
}

}  // namespace

cv::Mat1f drawn_by_colours(const cv::Mat1f& likelihood, float limit, const cv::Mat3b& picture) {
    const cv::Mat3b small = copy_of(picture, coarse_side_px);
    const cv::Mat1f seen = fitted(likelihood, small.size());
    const cv::Mat likely = seen > limit;
    const cv::Mat coarse = cut(seed_of(seen, likely), coarse_rounds, small);
    const int fine_side_px =
        std::clamp(std::max(picture.cols, picture.rows), coarse_side_px, finest_side_px);
    const cv::Mat3b large = copy_of(picture, fine_side_px);
    cv::Mat1f drawn = fitted(likelihood, large.size());
    cv::Mat fine;
    if (!coarse.empty() && agree(coarse, likely)) fine = drawn_finer(coarse, drawn, large);
    std::ranges::transform(drawn, drawn.begin(),
                           [limit](float value) { return at_figure_limit(value, limit); });
    if (!fine.empty()) divide(fine, drawn);
    return drawn;
}

}  // namespace touchline
