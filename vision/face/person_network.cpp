#include "vision/face/person_network.h"

#include <algorithm>
#include <array>
#include <utility>

#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int kSide_px = 256;

}  // namespace

Result<PersonNetwork> PersonNetwork::from_onnx(std::span<const std::byte> model) {
    return TrainedNetwork::from_onnx(model, "tells persons from the rest")
        .map([](TrainedNetwork&& network) { return PersonNetwork(std::move(network)); });
}

Result<cv::Mat1b> PersonNetwork::mask_of(const cv::Mat3b& picture, const cv::Rect& part) {
    const bool shrinks = std::max(part.width, part.height) > kSide_px;
    cv::Mat3b square;
    cv::resize(picture(part), square, {kSide_px, kSide_px}, 0.0, 0.0,
               shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
    const std::array map{std::vector{1, kSide_px, kSide_px, 1}};
    const auto found =
        network_.outputs(cv::dnn::blobFromImage(square, 1.0 / 255.0, {}, {}, true, false), map);
    if (!found) return tl::unexpected(found.error());
    if (!cv::checkRange(found->front(), true, nullptr, 0.0, 1.0 + 1e-6))
        return network_.unusable("its output is no likelihood");
    cv::Mat1b mask;
    found->front().reshape(1, kSide_px).convertTo(mask, CV_8U, 255.0);
    return mask;
}

}  // namespace touchline
