#include "vision/figure/figure_network.h"

#include <algorithm>
#include <array>
#include <utility>

#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

/// Shrinking averages the pixels that become one; enlarging interpolates smoothly.
cv::Mat3b stretched(const cv::Mat3b& picture, int side_px) {
    const bool shrinks = std::max(picture.cols, picture.rows) > side_px;
    cv::Mat3b square;
    cv::resize(picture, square, {side_px, side_px}, 0.0, 0.0,
               shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
    return square;
}

}  // namespace

Result<FigureNetwork> FigureNetwork::from_onnx(std::span<const std::byte> model) {
    return TrainedNetwork::from_onnx(model, "finds the main thing")
        .map([](TrainedNetwork&& network) { return FigureNetwork(std::move(network)); });
}

Result<cv::Mat1f> FigureNetwork::likelihood(const cv::Mat3b& picture, int side_px) {
    const cv::Mat input = cv::dnn::blobFromImage(stretched(picture, side_px), 1.0 / 256.0, {},
                                                 cv::Scalar::all(128.0), true, false);
    const std::array map{std::vector{1, 1, side_px, side_px}};
    const auto found = network_.outputs(input, map);
    if (!found) return tl::unexpected(found.error());
    if (!cv::checkRange(found->front(), true, nullptr, 0.0, 1.0 + 1e-6))
        return network_.unusable("its output is no likelihood");
    return found->front();
}

}  // namespace touchline
