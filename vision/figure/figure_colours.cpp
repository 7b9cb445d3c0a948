#include "vision/figure/figure_colours.h"

#include "vision/contour/fixed_random_state.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int longer_side_px = 224;
constexpr float figure_limit = 0.3F;  // of figures.h
constexpr float just_below = 0.99F * figure_limit;
// Measured on held-out photographs: tests/lab/figure_network/README.md.
constexpr float surely_figure = 0.9F;
constexpr float surely_ground = 0.04F;
constexpr int rounds = 2;
constexpr double least_agreement = 0.4;  // intersection over union

cv::Mat3b small_copy(const cv::Mat3b& picture) {
    const double scale = static_cast<double>(longer_side_px) / std::max(picture.cols, picture.rows);
    const cv::Size size(std::max(1, cvRound(scale * picture.cols)),
                        std::max(1, cvRound(scale * picture.rows)));
    cv::Mat3b copy;
    cv::resize(picture, copy, size, 0.0, 0.0, scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
    return copy;
}

/// Moves the limit of a likelihood to that of figures.h.
float at_figure_limit(float likelihood, float limit) {
    if (likelihood < limit) return figure_limit * likelihood / limit;
    return figure_limit + (1.0F - figure_limit) * (likelihood - limit) / (1.0F - limit);
}

/// Returns what GrabCut takes for the figure, 255; nothing if all is figure or all is ground.
cv::Mat cut_by_colours(const cv::Mat1f& likelihood, float limit, const cv::Mat3b& picture) {
    cv::Mat1b seed(likelihood.size());
    std::ranges::transform(likelihood, seed.begin(), [limit](float value) -> uchar {
        if (value > surely_figure) return cv::GC_FGD;
        if (value < surely_ground) return cv::GC_BGD;
        return value > limit ? cv::GC_PR_FGD : cv::GC_PR_BGD;
    });
    const int figure = cv::countNonZero(seed & 1);
    if (figure == 0 || figure == static_cast<int>(seed.total())) return {};
    const FixedRandomState fixed;
    cv::Mat background;
    cv::Mat foreground;
    cv::grabCut(picture, seed, {}, background, foreground, rounds, cv::GC_INIT_WITH_MASK);
    return (seed & 1) * 255;
}

bool agree(const cv::Mat& one, const cv::Mat& other) {
    return cv::countNonZero(one & other) >= least_agreement * cv::countNonZero(one | other);
}

}  // namespace

cv::Mat1f drawn_by_colours(const cv::Mat1f& likelihood, float limit, const cv::Mat3b& picture) {
    const cv::Mat3b small = small_copy(picture);
    cv::Mat1f drawn;
    cv::resize(likelihood, drawn, small.size(), 0.0, 0.0, cv::INTER_LINEAR);
    const cv::Mat1b cut = cut_by_colours(drawn, limit, small);
    const bool is_cut = !cut.empty() && agree(cut, drawn > limit);
    std::ranges::transform(drawn, drawn.begin(),
                           [limit](float value) { return at_figure_limit(value, limit); });
    if (!is_cut) return drawn;
    std::ranges::transform(drawn, cut, drawn.begin(), [](float value, uchar figure) {
        return figure != 0 ? std::max(value, figure_limit) : std::min(value, just_below);
    });
    return drawn;
}

}  // namespace touchline
