#include "vision/name/name_network.h"

#include <algorithm>
#include <array>
#include <utility>

#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr std::array kGridSides{52, 26, 13};

cv::Mat3b in_square(const cv::Mat3b& picture, const Letterbox& letterbox) {
    cv::Mat3b square(names_side_px, names_side_px, cv::Vec3b(0, 0, 0));
    cv::Mat part = square(letterbox.part);
    const bool shrinks = std::max(picture.cols, picture.rows) > names_side_px;
    cv::resize(picture, part, part.size(), 0.0, 0.0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
    return square;
}

/// Uses the means and deviations of the pictures that it was trained on: blue, green, red.
cv::Mat input_of(const cv::Mat3b& square) {
    cv::Mat3f values;
    square.convertTo(values, CV_32F);
    cv::subtract(values, cv::Scalar(103.53, 116.28, 123.675), values);
    cv::divide(values, cv::Scalar(57.375, 57.12, 58.395), values);
    return cv::dnn::blobFromImage(values);
}

std::vector<std::vector<int>> shapes() {
    std::vector<std::vector<int>> shapes;
    for (const int side : kGridSides) {
        shapes.push_back({1, side * side, known_kinds});
        shapes.push_back({1, side * side, 4 * distance_steps});
    }
    return shapes;
}

}  // namespace

Result<NameNetwork> NameNetwork::from_onnx(std::span<const std::byte> model) {
    return TrainedNetwork::from_onnx(model, "names things").map([](TrainedNetwork&& network) {
        return NameNetwork(std::move(network));
    });
}

Result<std::vector<GridAnswer>> NameNetwork::answers(const cv::Mat3b& square) {
    const auto found = network_.outputs(input_of(square), shapes());
    if (!found) return tl::unexpected(found.error());
    std::vector<GridAnswer> answers;
    for (std::size_t i = 0; i < kGridSides.size(); ++i) {
        const GridAnswer answer{kGridSides[i], (*found)[2 * i], (*found)[2 * i + 1]};
        if (!cv::checkRange(answer.likelihoods, true, nullptr, 0.0, 1.0 + 1e-6))
            return network_.unusable("its output is no likelihood");
        answers.push_back(answer);
    }
    return answers;
}

Result<std::vector<Detection>> NameNetwork::detections(const cv::Mat3b& picture,
                                                       bool with_mirror_image) {
    const Letterbox letterbox = letterbox_of(picture.size());
    const cv::Mat3b square = in_square(picture, letterbox);
    auto upright = answers(square);
    if (!upright || !with_mirror_image)
        return upright.map([&letterbox](const auto& all) { return detections_of(all, letterbox); });
    cv::Mat3b mirror_image;
    cv::flip(square, mirror_image, 1);
    const auto mirrored = answers(mirror_image);
    if (!mirrored) return tl::unexpected(mirrored.error());
    std::ranges::transform(*upright, *mirrored, upright->begin(), mean_of);
    return detections_of(*upright, letterbox);
}

}  // namespace touchline
