#include "vision/figure/figures.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double kMaskPixels = 1e6;
constexpr uchar kLimit = 128;         // of a mask
constexpr float kFigure = 0.3F;       // likelihood: measured, tests/bench/vision/photographs.md
constexpr double kLeastPart = 0.05;   // of all figures
constexpr double kLeastArea = 0.002;  // of the picture
constexpr double kLeastHole = 0.004;  // of the picture

cv::Size mask_size(cv::Size picture) {
    const double pixels = static_cast<double>(picture.width) * picture.height;
    const double scale = std::min(1.0, std::sqrt(kMaskPixels / pixels));
    return {std::max(1, cvRound(scale * picture.width)),
            std::max(1, cvRound(scale * picture.height))};
}

/// Connected pieces of a mask, the background not among them.
struct Pieces {
    explicit Pieces(const cv::Mat& mask) {
        cv::Mat1d centres;
        count = cv::connectedComponentsWithStats(mask, number, stats, centres, 8, CV_32S);
    }

    [[nodiscard]] int area(int piece) const { return stats(piece, cv::CC_STAT_AREA); }

    [[nodiscard]] cv::Rect box(int piece) const {
        return {stats(piece, cv::CC_STAT_LEFT), stats(piece, cv::CC_STAT_TOP),
                stats(piece, cv::CC_STAT_WIDTH), stats(piece, cv::CC_STAT_HEIGHT)};
    }

    cv::Mat1i number;
    cv::Mat1i stats;
    int count = 0;
};

/// Soft likelihood to a mask in which the limit lies at 128.
cv::Mat1b soft_mask(const cv::Mat1f& likelihood) {
    cv::Mat1b mask(likelihood.size());
    std::ranges::transform(likelihood, mask.begin(), [](float value) {
        const float below = 127.0F * value / kFigure;
        const float above = 128.0F + 127.0F * (value - kFigure) / (1.0F - kFigure);
        return static_cast<uchar>(value < kFigure ? below : std::min(255.0F, above));
    });
    return mask;
}

bool touches_frame(const cv::Rect& box, cv::Size size) {
    return box.x == 0 || box.y == 0 || box.br().x == size.width || box.br().y == size.height;
}

/// The pieces that `is_out` says go to the other side of the limit, all of their pixels to `value`.
template <class IsOut>
void change(const Pieces& pieces, uchar value, IsOut is_out, cv::Mat1b& mask) {
    std::vector<bool> goes(static_cast<std::size_t>(pieces.count), false);
    for (int piece = 1; piece < pieces.count; ++piece) {
        goes[static_cast<std::size_t>(piece)] = is_out(piece);
    }
    std::ranges::transform(pieces.number, mask, mask.begin(), [&](int piece, uchar before) {
        return goes[static_cast<std::size_t>(piece)] ? value : before;
    });
}

/// Parts that are too small to be a thing go, small holes are filled.
void clean(cv::Mat1b& mask) {
    const auto pixels = static_cast<double>(mask.total());
    const cv::Mat is_figure = mask >= kLimit;
    const double least_px = std::max(kLeastPart * cv::countNonZero(is_figure), kLeastArea * pixels);
    const Pieces parts(is_figure);
    change(
        parts, kLimit - 1, [&](int part) { return parts.area(part) < least_px; }, mask);
    const Pieces holes(mask < kLimit);
    change(
        holes, kLimit,
        [&](int hole) {
            return holes.area(hole) < kLeastHole * pixels &&
                   !touches_frame(holes.box(hole), mask.size());
        },
        mask);
}

std::vector<cv::Rect> boxes_of(const cv::Mat1b& mask) {
    const Pieces parts(mask >= kLimit);
    std::vector<int> order;
    for (int part = 1; part < parts.count; ++part) {
        order.push_back(part);
    }
    std::ranges::stable_sort(order, std::ranges::greater{},
                             [&](int part) { return parts.area(part); });
    std::vector<cv::Rect> boxes;
    std::ranges::transform(order, std::back_inserter(boxes),
                           [&](int part) { return parts.box(part); });
    return boxes;
}

FigureSigns signs_of(const cv::Mat1f& likelihood, const cv::Mat1b& mask) {
    constexpr float kMayBe = 0.2F;
    constexpr float kSurely = 0.8F;
    const int may_be = cv::countNonZero(likelihood > kMayBe);
    const int surely = cv::countNonZero(likelihood >= kSurely);
    const int figure = cv::countNonZero(mask >= kLimit);
    return {figure / static_cast<double>(mask.total()),
            surely / static_cast<double>(std::max(1, may_be))};
}

/// Told from pictures that somebody looked at, and which of their masks are a thing.
bool is_sure_of(const FigureSigns& signs) {
    constexpr double kSteady = 0.65;
    constexpr double kLeastSeen = 0.003;
    return signs.steadiness >= kSteady && signs.area >= kLeastSeen;
}

}  // namespace

Figures figures_of(const cv::Mat1f& likelihood, cv::Size picture) {
    cv::Mat1f fitted;
    cv::resize(likelihood, fitted, mask_size(picture), 0.0, 0.0, cv::INTER_LINEAR);
    Figures figures;
    figures.mask = soft_mask(fitted);
    clean(figures.mask);
    figures.boxes = boxes_of(figures.mask);
    figures.signs = signs_of(fitted, figures.mask);
    figures.is_sure = !figures.boxes.empty() && is_sure_of(figures.signs);
    return figures;
}

}  // namespace touchline
