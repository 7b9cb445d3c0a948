#include "vision/figure/figure_lines.h"

#include "vision/contour/finger.h"
#include "vision/contour/gradient.h"
#include "vision/contour/iso_rings.h"
#include "vision/contour/ring_snap.h"
#include "vision/contour/sampling.h"
#include "vision/contour/stretches.h"

#include <algorithm>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr float kFigureLevel = 127.5F;
constexpr double kReach_mm = 1.5;  // the edge of a thing may lie off its mask
constexpr double kSmoothing_px = 1.5;

/// Returns the mask at the lines' size, with edges as smooth as the picture's.
cv::Mat1f fitted(const cv::Mat1b& mask, cv::Size size) {
    cv::Mat1f soft;
    mask.convertTo(soft, CV_32F);
    cv::resize(soft, soft, size, 0.0, 0.0,
               mask.cols > size.width ? cv::INTER_AREA : cv::INTER_LINEAR);
    cv::GaussianBlur(soft, soft, cv::Size(), 1.0);
    return soft;
}

std::vector<Chain> rings_of(const cv::Mat1f& soft, const cv::Mat1f& strength, double reach_px,
                            double shortest_px, double high) {
    std::vector<Chain> rings;
    for (const Chain& line : iso_rings(soft, kFigureLevel)) {
        if (length_of(line) < shortest_px) {
            continue;
        }
        Chain ring = resampled(line, 1.0);
        snap(ring, strength, reach_px);
        ring = resampled(ring, 1.0);
        ring.of = LineOf::ring;
        for (EdgePoint& p : ring.points) {
            p.strength = std::max(high, static_cast<double>(strength_at(strength, p.at)));
        }
        rings.push_back(std::move(ring));
    }
    return rings;
}

/// Returns the distance of each pixel to the nearest ring.
cv::Mat1f to_rings(const std::vector<Chain>& rings, cv::Size size) {
    cv::Mat1b free(size, uchar{255});
    for (const Chain& ring : rings) {
        std::vector<cv::Point> points;
        for (const EdgePoint& p : ring.points) {
            points.emplace_back(cvRound(p.at.x), cvRound(p.at.y));
        }
        cv::polylines(free, points, ring.is_closed, cv::Scalar(0));
    }
    cv::Mat1f distance;
    cv::distanceTransform(free, distance, cv::DIST_L2, 5);
    return distance;
}

enum class Place { on_ring, inside, outside };

/// Returns the rings without the parts along the picture's frame: a thing cut by the frame has no
/// edge there.
std::vector<Chain> off_frame(const std::vector<Chain>& rings, cv::Size size, double shortest_px) {
    std::vector<Chain> lines;
    for (const Chain& ring : rings) {
        cut_by_place(
            ring, [&](const EdgePoint& p) { return is_on_frame(p.at, size); },
            [&](Chain part, bool is_frame) {
                if (!is_frame && length_of(part) >= shortest_px) {
                    lines.push_back(std::move(part));
                }
            });
    }
    return lines;
}

}  // namespace

PhotoLines with_figure(PhotoLines lines, const cv::Mat& picture, const cv::Mat1b& mask,
                       double longer_side_mm) {
    const double px_per_mm = std::max(lines.size.width, lines.size.height) / longer_side_mm;
    const double shortest_px = kShortestLine_mm * px_per_mm;
    cv::Mat small;
    cv::resize(picture, small, lines.size, 0.0, 0.0, cv::INTER_AREA);
    const cv::Mat1f strength = colour_gradient(to_lab(small), kSmoothing_px).strength;
    const cv::Mat1f soft = fitted(mask, lines.size);
    const std::vector<Chain> rings =
        rings_of(soft, strength, kReach_mm * px_per_mm, shortest_px, lines.high);
    if (rings.empty()) {
        return lines;
    }
    std::vector<Chain> felt = off_frame(rings, lines.size, shortest_px);
    const cv::Mat1f distance = to_rings(felt, lines.size);
    const auto beside_px = static_cast<float>(kLeastApart_mm * px_per_mm);
    const auto place_of = [&](const EdgePoint& p) {
        const cv::Point at(std::clamp(cvRound(p.at.x), 0, soft.cols - 1),
                           std::clamp(cvRound(p.at.y), 0, soft.rows - 1));
        if (distance(at) < beside_px) {
            return Place::on_ring;
        }
        return soft(at) > kFigureLevel ? Place::inside : Place::outside;
    };
    const std::vector<Chain> all = std::exchange(lines.chains, std::move(felt));
    for (const Chain& line : all) {
        cut_by_place(line, place_of, [&](Chain part, Place place) {
            if (place == Place::on_ring || length_of(part) < shortest_px) {
                return;
            }
            if (place == Place::outside) {
                part.of = LineOf::background;
            }
            lines.chains.push_back(std::move(part));
        });
    }
    return lines;
}

}  // namespace touchline
