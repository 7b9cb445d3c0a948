#include "vision/face/face_boxes.h"

#include "vision/face/face_mesh.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr std::size_t kMostBoxes = 16;
constexpr double kLeastLikelihood = 0.5;
constexpr double kShared = 0.3;  // of a box: then it is the same face again
constexpr double kLeastSide_px = 4.0;

cv::Point2d anchor(int row) {
    struct Level {
        int first, stride_px, at_each_place;
    };

    const Level level = row < 512 ? Level{0, 16, 2} : Level{512, 32, 6};
    const int place = (row - level.first) / level.at_each_place;
    const int across = kFaceInput_px / level.stride_px;
    return {(place % across + 0.5) * level.stride_px, (place / across + 0.5) * level.stride_px};
}

bool is_box_of_the_input(const FaceBox& found) {
    const cv::Rect2d& box = found.box;
    const cv::Point2d centre = centre_of(box);
    const cv::Rect2d input(0.0, 0.0, kFaceInput_px, kFaceInput_px);
    const double reach_px = 1.5 * std::max(box.width, box.height);
    return box.width >= kLeastSide_px && box.height >= kLeastSide_px &&
           std::max(box.width, box.height) <= 1.5 * kFaceInput_px && input.contains(centre) &&
           cv::norm(found.left_eye - centre) <= reach_px &&
           cv::norm(found.right_eye - centre) <= reach_px && found.left_eye != found.right_eye;
}

FaceBox box_at(const cv::Mat1f& places, int row) {
    const cv::Point2d from = anchor(row);
    const auto point = [&](int k) {
        return from + cv::Point2d(static_cast<double>(places(row, k)),
                                  static_cast<double>(places(row, k + 1)));
    };
    const cv::Point2d size = point(2) - from;
    const cv::Point2d corner = point(0) - 0.5 * size;
    return {{corner.x, corner.y, size.x, size.y}, point(4), point(6), 0.0};
}

bool is_apart(const FaceBox& box, const std::vector<FaceBox>& others) {
    return std::ranges::none_of(others, [&](const FaceBox& other) {
        return (box.box & other.box).area() >= kShared * box.box.area();
    });
}

}  // namespace

void add_apart(const std::vector<FaceBox>& more, std::vector<FaceBox>& boxes) {
    for (const FaceBox& box : more) {
        if (is_apart(box, boxes)) boxes.push_back(box);
    }
}

std::vector<FaceBox> face_boxes(const cv::Mat1f& scores, const cv::Mat1f& places) {
    std::vector<FaceBox> all;
    for (int row = 0; row < scores.rows; ++row) {
        const double likelihood = 1.0 / (1.0 + std::exp(-static_cast<double>(scores(row, 0))));
        if (!(likelihood >= kLeastLikelihood)) continue;
        FaceBox box = box_at(places, row);
        box.likelihood = likelihood;
        if (is_box_of_the_input(box)) all.push_back(box);
    }
    std::ranges::stable_sort(all, std::ranges::greater{}, &FaceBox::likelihood);
    std::vector<FaceBox> kept;
    add_apart(all, kept);
    if (kept.size() > kMostBoxes) kept.resize(kMostBoxes);
    return kept;
}

}  // namespace touchline
