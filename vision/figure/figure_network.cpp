#include "vision/figure/figure_network.h"

#include <utility>

#include <opencv2/dnn.hpp>

namespace touchline {

Result<FigureNetwork> FigureNetwork::from_onnx(std::span<const std::byte> model) {
    return TrainedNetwork::from_onnx(model, "finds the main thing")
        .map([](TrainedNetwork&& network) { return FigureNetwork(std::move(network)); });
}

Result<cv::Mat1f> FigureNetwork::likelihood(const cv::Mat3b& picture, int side_px) {
    const cv::Mat input =
        cv::dnn::blobFromImage(stretched(picture, {side_px, side_px}), 1.0 / 256.0, {},
                               cv::Scalar::all(128.0), true, false);
    return network_.likelihoods(input, {1, 1, side_px, side_px});
}

}  // namespace touchline
