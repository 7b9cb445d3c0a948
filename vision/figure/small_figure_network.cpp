#include "vision/figure/small_figure_network.h"

#include "vision/figure/figure_colours.h"
#include "vision/figure/figure_cues.h"

#include <utility>

namespace touchline {
namespace {

constexpr int side_px = 256;
constexpr int answer_px = side_px / 2;
constexpr int colour_count = 3;
constexpr float figure_from = 0.45F;  // measured: tests/lab/figure_network/README.md

/// Returns the network's input for a picture of its size: colours, then cues.
cv::Mat planes_of(const cv::Mat3b& picture) {
    constexpr int planes = colour_count + static_cast<int>(figure_cue_count);
    cv::Mat input(std::vector<int>{1, planes, side_px, side_px}, CV_32F);
    const auto plane = [&input](int at) {
        return cv::Mat1f(side_px, side_px, input.ptr<float>(0, at));
    };
    for (int at = 0; at < colour_count; ++at) {
        cv::Mat1b colour;
        cv::extractChannel(picture, colour, colour_count - 1 - at);
        cv::Mat1f values = plane(at);
        colour.convertTo(values, CV_32F, 1.0 / 128.0, -1.0);
    }
    int at = colour_count;
    for (const cv::Mat1f& cue : figure_cues(picture)) cue.copyTo(plane(at++));
    return input;
}

}  // namespace

Result<SmallFigureNetwork> SmallFigureNetwork::from_onnx(std::span<const std::byte> model) {
    return TrainedNetwork::from_onnx(model, "finds the main thing")
        .map([](TrainedNetwork&& network) { return SmallFigureNetwork(std::move(network)); });
}

Result<cv::Mat1f> SmallFigureNetwork::likelihood(const cv::Mat3b& picture) {
    return network_
        .likelihoods(planes_of(stretched(picture, {side_px, side_px})),
                     {1, 1, answer_px, answer_px})
        .map([&](const cv::Mat1f& seen) { return drawn_by_colours(seen, figure_from, picture); });
}

}  // namespace touchline
