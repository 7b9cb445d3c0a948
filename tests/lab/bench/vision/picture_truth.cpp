#include "tests/lab/bench/vision/picture_truth.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include <opencv2/imgproc.hpp>

namespace touchline::bench {
namespace {

constexpr double kLeastLine_mm = 3.0;  // shorter ones are not required
// The answer of a Sobel filter where a step of 25 of 255 has become three pixels wide.
constexpr double seen_step = 60.0;
constexpr int kNearCorner_px = 31;
constexpr float corner_beyond_middle = 2.0F;  // in half widths, at 60 degrees
constexpr double along = 0.7;  // least cosine between the gradients of the two sides of a stroke

const cv::Size kSheet(static_cast<int>(testing::sheet_mm.width* kPixels_per_mm),
                      static_cast<int>(testing::sheet_mm.height* kPixels_per_mm));

/// The picture on the sheet, and where it lies there.
struct Fitted {
    cv::Mat sheet;
    cv::Rect box;
};

Fitted on_sheet(const cv::Mat& picture) {
    const double scale = std::min(kSheet.width / static_cast<double>(picture.cols),
                                  kSheet.height / static_cast<double>(picture.rows));
    cv::Mat fitted;
    cv::resize(picture, fitted,
               cv::Size(std::max(1, static_cast<int>(std::lround(scale * picture.cols))),
                        std::max(1, static_cast<int>(std::lround(scale * picture.rows)))),
               0, 0, scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
    const int left = (kSheet.width - fitted.cols) / 2;
    const int top = (kSheet.height - fitted.rows) / 2;
    cv::Mat sheet;
    cv::copyMakeBorder(fitted, sheet, top, kSheet.height - fitted.rows - top, left,
                       kSheet.width - fitted.cols - left, cv::BORDER_REPLICATE);
    return {sheet, {{left, top}, fitted.size()}};
}

/// The gradient of the channel that changes most, pixel by pixel.
struct Gradient {
    cv::Mat x, y;  // 16-bit

    [[nodiscard]] cv::Point2d at(const cv::Point& p) const {
        return {static_cast<double>(x.at<short>(p)), static_cast<double>(y.at<short>(p))};
    }
};

Gradient gradient_of(const cv::Mat& sheet) {
    cv::Mat x, y;
    cv::Sobel(sheet, x, CV_16S, 1, 0);
    cv::Sobel(sheet, y, CV_16S, 0, 1);
    Gradient out{cv::Mat(sheet.size(), CV_16S), cv::Mat(sheet.size(), CV_16S)};
    for (int row = 0; row < sheet.rows; ++row)
        for (int column = 0; column < sheet.cols; ++column) {
            const auto& dx = x.at<cv::Vec3s>(row, column);
            const auto& dy = y.at<cv::Vec3s>(row, column);
            int most = 0;
            for (int c = 1; c < 3; ++c)
                if (std::hypot(dx[c], dy[c]) > std::hypot(dx[most], dy[most])) most = c;
            out.x.at<short>(row, column) = dx[most];
            out.y.at<short>(row, column) = dy[most];
        }
    return out;
}

cv::Mat edges_of(const Gradient& gradient, const cv::Rect& picture) {
    cv::Mat everywhere, parts, sizes, middles;
    cv::Canny(gradient.x, gradient.y, everywhere, seen_step, seen_step, true);
    cv::Mat edges(everywhere.size(), CV_8U, cv::Scalar(0));
    everywhere(picture).copyTo(edges(picture));
    const int count = cv::connectedComponentsWithStats(edges, parts, sizes, middles, 8);
    for (int i = 1; i < count; ++i) {
        const double long_mm =
            std::hypot(sizes.at<int>(i, cv::CC_STAT_WIDTH), sizes.at<int>(i, cv::CC_STAT_HEIGHT)) /
            kPixels_per_mm;
        if (long_mm < kLeastLine_mm) edges.setTo(0, parts == i);
    }
    return edges;
}

/// Returns the nearest edge in this direction that runs along this one; a stroke lies between.
std::optional<cv::Point> other_side(const cv::Mat& edges, const Gradient& gradient,
                                    const cv::Point& from, const cv::Point2d& direction) {
    const cv::Point2d own = gradient.at(from) * (1.0 / cv::norm(gradient.at(from)));
    const int furthest = static_cast<int>(testing::kWidestLine_mm * kPixels_per_mm);
    for (int step = 4; step <= furthest; ++step) {
        const cv::Point middle = cv::Point2d(from) + direction * static_cast<double>(step);
        for (const cv::Point& beside : {cv::Point(0, 0), {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const cv::Point at = middle + beside;
            if (!cv::Rect({}, edges.size()).contains(at) || edges.at<uchar>(at) == 0) continue;
            const cv::Point2d there = gradient.at(at);
            if (std::abs(own.dot(there)) > along * cv::norm(there)) return at;
        }
    }
    return std::nullopt;
}

cv::Mat distance_to(const cv::Mat& mask) {
    cv::Mat distance;
    cv::distanceTransform(255 - mask, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return distance;
}

cv::Mat mask_of(const std::vector<cv::Point2d>& points_mm) {
    cv::Mat mask(kSheet, CV_8U, cv::Scalar(0));
    for (const cv::Point2d& mm : points_mm) {
        const cv::Point at = mm * kPixels_per_mm;
        if (cv::Rect({}, kSheet).contains(at)) mask.at<uchar>(at) = 255;
    }
    return mask;
}

double share_within(const cv::Mat& edges, const cv::Mat& distance, double tolerance_px) {
    const int all = cv::countNonZero(edges);
    return all == 0
               ? 1.0
               : cv::countNonZero(edges & (distance <= tolerance_px)) / static_cast<double>(all);
}

/// A stretch of missed edge that lies within the gap of a felt line all along, and is longer than
/// the gap, runs beside it: the tactile rules chose the other line.
void count_missed(const cv::Mat& missed, const cv::Mat& to_felt, double gap_mm,
                  testing::Counted& seen) {
    cv::Mat parts, sizes, middles, furthest;
    const int count = cv::connectedComponentsWithStats(missed, parts, sizes, middles, 8);
    for (int i = 1; i < count; ++i) {
        const cv::Mat part = parts == i;
        double far_px = 0.0;
        cv::minMaxLoc(to_felt, nullptr, &far_px, nullptr, nullptr, part);
        const double length_mm = sizes.at<int>(i, cv::CC_STAT_AREA) / kPixels_per_mm;
        const bool is_beside = far_px <= gap_mm * kPixels_per_mm && length_mm > gap_mm;
        (is_beside ? seen.too_near_mm : seen.wrong_mm) += length_mm;
    }
}

}  // namespace

PictureTruth truth_of(const cv::Mat& picture) {
    const Fitted fitted = on_sheet(picture);
    const Gradient gradient = gradient_of(fitted.sheet);
    PictureTruth truth;
    truth.edges = edges_of(gradient, fitted.box);
    truth.lines = truth.edges.clone();
    std::vector<cv::Point> points;
    cv::findNonZero(truth.edges, points);
    cv::Mat half_widths(kSheet, CV_32F, cv::Scalar(0));
    for (const cv::Point& at : points) {
        std::vector<cv::Point>& choices = truth.each.emplace_back().choices;
        choices.push_back(at);
        const cv::Point2d across = gradient.at(at) * (1.0 / cv::norm(gradient.at(at)));
        for (const cv::Point2d& direction : {across, -across}) {
            const auto other = other_side(truth.edges, gradient, at, direction);
            if (!other) continue;
            choices.push_back((at + *other) / 2);
            truth.lines.at<uchar>(choices.back()) = 255;
            half_widths.at<float>(at) = static_cast<float>(0.5 * cv::norm(at - *other));
        }
    }
    cv::dilate(half_widths, half_widths, cv::Mat::ones(kNearCorner_px, kNearCorner_px, CV_8U));
    for (PictureTruth::Edge& edge : truth.each) {
        if (edge.choices.size() == 1)
            edge.beside_px = corner_beyond_middle * half_widths.at<float>(edge.choices.front());
    }
    return truth;
}

Shares shares_of(const PictureTruth& truth, const TactileMap& map, double gap_mm,
                 double tolerance_mm) {
    std::vector<cv::Point2d> felt;
    for (const Outline& outline : map.outlines) {
        const std::vector<cv::Point2d> steps = testing::in_steps(outline);
        felt.insert(felt.end(), steps.begin(), steps.end());
    }
    const double tolerance_px = tolerance_mm * kPixels_per_mm;
    const cv::Mat to_felt = distance_to(mask_of(felt));
    Shares out;
    cv::Mat missed(kSheet, CV_8U, cv::Scalar(0));
    for (const PictureTruth::Edge& edge : truth.each) {
        const float near_px = static_cast<float>(tolerance_px) + edge.beside_px;
        if (std::ranges::any_of(edge.choices, [&](const cv::Point& at) {
                return to_felt.at<float>(at) <= near_px;
            }))
            out.seen.right_mm += 1.0 / kPixels_per_mm;
        else
            missed.at<uchar>(edge.choices.front()) = 255;
    }
    count_missed(missed, to_felt, gap_mm, out.seen);
    const cv::Mat to_line = distance_to(truth.lines);
    for (const cv::Point2d& mm : felt) {
        const cv::Point at = mm * kPixels_per_mm;
        const bool is_seen = cv::Rect({}, kSheet).contains(at) &&
                             to_line.at<float>(at) <= static_cast<float>(tolerance_px);
        (is_seen ? out.felt.right_mm : out.felt.wrong_mm) += testing::kStep_mm;
    }
    return out;
}

bool are_alike(const PictureTruth& a, const PictureTruth& b, double tolerance_mm) {
    constexpr double kAlike = 0.99;
    const double tolerance_px = tolerance_mm * kPixels_per_mm;
    return share_within(a.edges, distance_to(b.edges), tolerance_px) >= kAlike &&
           share_within(b.edges, distance_to(a.edges), tolerance_px) >= kAlike;
}

}  // namespace touchline::bench
