#include "vision/contour/main_shape.h"

#include "vision/contour/fixed_random_state.h"
#include "vision/contour/gradient.h"
#include "vision/contour/region_map.h"
#include "vision/contour/rings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int coarse_side_px = 160;  // longer side, for GrabCut
constexpr double fine_pixels = 1.2e5;
constexpr int coarse_border_px = 2;  // of the coarse copy: at least this wide
constexpr int rounds = 2;
constexpr double least_shape_part = 0.02;  // of the picture
constexpr double greatest_part = 0.7;
constexpr double greatest_on_frame = 0.3;   // of the outline
constexpr double greatest_likeness = 0.55;  // of the colours inside and outside, 0 to 1
constexpr double least_edge = 1.6;  // mean gradient on the outline, over the picture's median one
constexpr double snap_within_px = 5.0;  // of the fine copy: how far off the coarse outline may be

/// Returns a copy of at most `side_px` on its longer side.
cv::Mat sized(const cv::Mat& picture, int side_px) {
    const double scale =
        std::min(1.0, static_cast<double>(side_px) / std::max(picture.cols, picture.rows));
    cv::Mat copy;
    cv::resize(
        picture, copy,
        {std::max(1, cvRound(picture.cols * scale)), std::max(1, cvRound(picture.rows * scale))},
        0.0, 0.0, cv::INTER_AREA);
    return copy;
}

/// Returns how much each pixel differs from the colours of the border, grey levels, less far from
/// the middle.
cv::Mat1f salience(const LabPicture& lab) {
    const int band = std::max(coarse_border_px, std::min(lab.cols, lab.rows) / 20);
    LabPicture border(2 * band, lab.cols + lab.rows);
    for (int i = 0; i < band; ++i) {
        for (int x = 0; x < lab.cols; ++x) {
            border(2 * i, x) = lab(i, x);
            border(2 * i + 1, x) = lab(lab.rows - 1 - i, x);
        }
        for (int y = 0; y < lab.rows; ++y) {
            border(2 * i, lab.cols + y) = lab(y, i);
            border(2 * i + 1, lab.cols + y) = lab(y, lab.cols - 1 - i);
        }
    }
    constexpr double any_noise = 100.0;  // textured borders have colours too
    std::vector<cv::Vec3f> colours = palette_of(border, any_noise);
    constexpr std::size_t most_asked = 12;
    colours.resize(std::min(colours.size(), most_asked));
    cv::Mat1f unlike(lab.size());
    for (int y = 0; y < lab.rows; ++y) {
        for (int x = 0; x < lab.cols; ++x) {
            double nearest = 1e9;
            for (const cv::Vec3f& colour : colours) {
                nearest = std::min(nearest, cv::norm(lab(y, x) - colour));
            }
            const double u = (2.0 * x + 1.0) / lab.cols - 1.0;
            const double v = (2.0 * y + 1.0) / lab.rows - 1.0;
            unlike(y, x) = static_cast<float>(nearest * std::exp(-0.8 * (u * u + v * v)));
        }
    }
    cv::GaussianBlur(unlike, unlike, cv::Size(), 2.0);
    return unlike;
}

/// Seeds GrabCut: sure background at the border, probable object where it is salient.
cv::Mat1b seeded_by_salience(const LabPicture& lab) {
    const cv::Mat1f unlike = salience(lab);
    const float limit = std::max(10.0F, 0.5F * quantile(unlike, 0.98));
    cv::Mat1b seed(lab.size(), uchar{cv::GC_PR_BGD});
    seed.setTo(cv::GC_PR_FGD, unlike > limit);
    cv::rectangle(seed, cv::Rect({}, lab.size()), cv::GC_BGD, coarse_border_px);
    return seed;
}

cv::Mat1b seeded_by_spot(const LabPicture& lab, const cv::Point& spot) {
    const double unit = std::min(lab.cols, lab.rows);
    const auto radius = [&](double part) { return std::max(1, cvRound(part * unit)); };
    cv::Mat1b seed(lab.size(), uchar{cv::GC_PR_BGD});
    cv::circle(seed, spot, radius(0.18), cv::GC_PR_FGD, cv::FILLED);
    cv::circle(seed, spot, radius(0.03), cv::GC_FGD, cv::FILLED);
    cv::rectangle(seed, cv::Rect({}, lab.size()), cv::GC_BGD, 1);
    return seed;
}

/// Returns the largest part of the object (or the one at the spot), with holes filled; empty if
/// there is none.
cv::Mat1b one_part(const cv::Mat& object, const std::optional<cv::Point>& spot) {
    cv::Mat1i label;
    cv::Mat1i stats;
    cv::Mat1d centres;
    const int n = cv::connectedComponentsWithStats(object, label, stats, centres, 4, CV_32S);
    int best = spot ? label(*spot) : 0;
    for (int i = 1; i < n && !spot; ++i) {
        if (best == 0 || stats(i, cv::CC_STAT_AREA) > stats(best, cv::CC_STAT_AREA)) best = i;
    }
    if (best == 0) return {};
    cv::Mat outside = label != best;  // flooded from a frame round the picture; the rest is holes
    cv::copyMakeBorder(outside, outside, 1, 1, 1, 1, cv::BORDER_CONSTANT, 255);
    cv::floodFill(outside, {0, 0}, 128);
    return cv::Mat(outside != 128)(cv::Rect({1, 1}, object.size())).clone();
}

cv::Mat1b cut_out(const cv::Mat& coarse, const std::optional<cv::Point>& spot) {
    const LabPicture lab = to_lab(coarse);
    cv::Mat mask = spot ? seeded_by_spot(lab, *spot) : seeded_by_salience(lab);
    const int probable = cv::countNonZero(mask & 1);
    if (probable < 20 || probable > static_cast<int>(0.9 * static_cast<double>(mask.total()))) {
        return {};
    }
    const FixedRandomState fixed;
    cv::Mat background;
    cv::Mat foreground;
    cv::grabCut(coarse, mask, {}, background, foreground, rounds, cv::GC_INIT_WITH_MASK);
    return one_part((mask & 1) * 255, spot);
}

/// Returns the Bhattacharyya coefficient of the colours inside and outside: 0 if they have nothing
/// in common, 1 if they are the same.
double likeness(const LabPicture& lab, const cv::Mat1b& inside) {
    constexpr int likeness_bins = 10;
    std::array<std::vector<double>, 2> histogram{
        std::vector<double>(likeness_bins * likeness_bins * likeness_bins, 0.0),
        std::vector<double>(likeness_bins * likeness_bins * likeness_bins, 0.0)};
    std::array<double, 2> sum{};
    const auto cell = [](float value, float low, float size) {
        return static_cast<int>(std::clamp((value - low) / size, 0.0F, likeness_bins - 1.0F));
    };
    for (int y = 0; y < lab.rows; ++y) {
        for (int x = 0; x < lab.cols; ++x) {
            const cv::Vec3f& c = lab(y, x);
            const int bin = (cell(c[0], 0.0F, 26.0F) * likeness_bins + cell(c[1], -75.0F, 15.0F)) *
                                likeness_bins +
                            cell(c[2], -75.0F, 15.0F);
            const std::size_t side = inside(y, x) != 0 ? 1 : 0;
            histogram[side][static_cast<std::size_t>(bin)] += 1.0;
            sum[side] += 1.0;
        }
    }
    double common = 0.0;
    for (std::size_t i = 0; i < histogram[0].size(); ++i) {
        common += std::sqrt(histogram[0][i] * histogram[1][i]);
    }
    return common / std::sqrt(std::max(1.0, sum[0] * sum[1]));
}

/// Returns the longest ring round the mask, in its pixels; the frame closes what it cuts. Returns
/// nothing round a mask that is one pixel wide everywhere, because smoothing leaves no inside.
std::optional<Chain> ring_round(const cv::Mat1b& mask) {
    cv::Mat1f soft;
    mask.convertTo(soft, CV_32F, 2.0 / 255.0);
    cv::copyMakeBorder(soft, soft, 3, 3, 3, 3, cv::BORDER_CONSTANT, 0.0);
    cv::GaussianBlur(soft, soft, cv::Size(), 1.0);
    LabPicture levels(soft.size(), cv::Vec3f(0.0F, 0.0F, 0.0F));
    cv::insertChannel(soft, levels, 0);
    const cv::Mat1b map = cv::Mat((soft >= 1.0F) & 1);
    Chain longest;
    for (Chain& ring : region_borders(map, levels, {{0.0F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F}})) {
        if (ring.is_closed && length_of(ring) > length_of(longest)) longest = std::move(ring);
    }
    if (longest.points.empty()) return std::nullopt;
    for (EdgePoint& point : longest.points) {
        point.at.x = std::clamp(point.at.x - 3.0, -0.5, mask.cols - 0.5);
        point.at.y = std::clamp(point.at.y - 3.0, -0.5, mask.rows - 0.5);
    }
    return longest;
}

void scale(Chain& ring, double x, double y) {
    for (EdgePoint& point : ring.points) {
        point.at = {(point.at.x + 0.5) * x - 0.5, (point.at.y + 0.5) * y - 0.5};
    }
}

/// Sets the strengths, and returns whether the outline lies on edges more than the picture does on
/// average.
bool is_on_edges(Chain& ring, const cv::Mat1f& strength) {
    double sum = 0.0;
    int on_frame = 0;
    for (EdgePoint& point : ring.points) {
        point.strength = static_cast<double>(strength_at(strength, point.at));
        const bool is_frame = is_on_frame(point.at, strength.size());
        on_frame += is_frame ? 1 : 0;
        sum += is_frame ? 0.0 : point.strength;
    }
    const auto all = static_cast<double>(ring.points.size());
    const double free = all - on_frame;
    const auto middle = static_cast<double>(quantile(strength, 0.5));
    return on_frame < greatest_on_frame * all && sum > least_edge * std::max(0.5, middle) * free;
}

}  // namespace

std::optional<Chain> main_shape(const cv::Mat& picture, std::optional<cv::Point2d> spot) {
    constexpr int least_side_px = 16;
    if (std::min(picture.cols, picture.rows) < least_side_px || picture.type() != CV_8UC3) {
        return std::nullopt;
    }
    const cv::Mat coarse = sized(picture, coarse_side_px);
    if (std::min(coarse.cols, coarse.rows) < coarse_border_px) {  // a strip is nothing but border
        return std::nullopt;
    }
    std::optional<cv::Point> coarse_spot;
    if (spot) {
        coarse_spot = cv::Point(
            std::clamp(cvFloor(spot->x * coarse.cols / picture.cols), 0, coarse.cols - 1),
            std::clamp(cvFloor(spot->y * coarse.rows / picture.rows), 0, coarse.rows - 1));
    }
    const cv::Mat1b object = cut_out(coarse, coarse_spot);
    const double part =
        object.empty() ? 0.0 : cv::countNonZero(object) / static_cast<double>(object.total());
    if (part < least_shape_part || part > greatest_part ||
        likeness(to_lab(coarse), object) > greatest_likeness) {
        return std::nullopt;
    }
    const LabPicture fine = to_lab(reduced(picture, fine_pixels));
    constexpr double ring_smoothing_px = 1.5;
    const cv::Mat1f strength = colour_gradient(fine, ring_smoothing_px).strength;
    std::optional<Chain> found = ring_round(object);
    if (!found) return std::nullopt;
    Chain& ring = *found;
    scale(ring, static_cast<double>(fine.cols) / coarse.cols,
          static_cast<double>(fine.rows) / coarse.rows);
    ring = resampled(ring, 1.0);
    snap(ring, strength, snap_within_px);
    ring = resampled(ring, 1.0);
    if (!is_on_edges(ring, strength)) return std::nullopt;
    scale(ring, static_cast<double>(picture.cols) / fine.cols,
          static_cast<double>(picture.rows) / fine.rows);
    return found;
}

}  // namespace touchline
