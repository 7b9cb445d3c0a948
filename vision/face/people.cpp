#include "vision/face/people.h"

#include "vision/face/picture_part.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int kMostPeople = 5;
constexpr double kLeastShare = 1.0 / 80.0;  // of the picture
constexpr double kSeenBeyond = 0.12;   // of a box's longer side: what the network sees round it
constexpr double kTakenBeyond = 0.04;  // and how much of that counts

cv::Rect grown(const cv::Rect2d& box, double share, cv::Size picture) {
    const double by = share * std::max(box.width, box.height);
    return part_within({box.x - by, box.y - by, box.width + 2.0 * by, box.height + 2.0 * by},
                       picture);
}

/// Also false for a box without width or height, and for one with NaN.
bool is_large(const cv::Rect2d& box, cv::Size picture) {
    return box.width > 0.0 && box.height > 0.0 &&
           box.width * box.height >= kLeastShare * picture.width * picture.height;
}

}  // namespace

Result<cv::Mat1f> people_likelihood(const cv::Mat3b& picture, std::span<const cv::Rect2d> people,
                                    PersonNetwork& network) {
    cv::Mat1f likelihood(picture.size(), 0.0F);
    int seen = 0;
    for (const cv::Rect2d& box : people) {
        const cv::Rect part = grown(box, kSeenBeyond, picture.size());
        const cv::Rect taken = grown(box, kTakenBeyond, picture.size()) & part;
        if (!is_large(box, picture.size()) || taken.empty()) continue;
        if (++seen > kMostPeople) break;
        const auto mask = network.mask_of(picture, part);
        if (!mask) return tl::unexpected(mask.error());
        cv::Mat1f here;
        mask->convertTo(here, CV_32F, 1.0 / 255.0);
        cv::resize(here, here, part.size(), 0.0, 0.0, cv::INTER_LINEAR);
        cv::Mat whole = likelihood(taken);
        cv::max(whole, cv::Mat(here(taken - part.tl())), whole);
    }
    return likelihood;
}

}  // namespace touchline
