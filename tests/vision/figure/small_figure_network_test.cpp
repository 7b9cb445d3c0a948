#include "vision/figure/small_figure_network.h"

#include "tests/vision/figure/onnx_writer.h"
#include "tests/vision/figure/with_noise.h"

#include <stdexcept>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

/// Takes red for the main thing: a network of the small one's kind without its weights.
OnnxGraph small_red_network() {
    OnnxGraph graph;
    constexpr float gain = 6.0F;
    graph.constants = {{"mix", {1, 9, 1, 1}, {gain, -0.5F * gain, -0.5F * gain, 0, 0, 0, 0, 0, 0}},
                       {"least", {1}, {-0.8F * gain}}};
    graph.inputs = {{"planes", {1, 9, 256, 256}}};
    graph.nodes = {{"Conv", {"planes", "mix", "least"}, "redder", {1, 1}, 2},
                   {"Sigmoid", {"redder"}, "likelihood", {}}};
    graph.outputs = {{"likelihood", {1, 1, 128, 128}}};
    return graph;
}

cv::Mat1f seen(const cv::Mat3b& picture) {
    auto network = SmallFigureNetwork::from_onnx(written(small_red_network()));
    if (!network) throw std::runtime_error(network.error().line);
    const auto likelihood = network->likelihood(picture);
    if (!likelihood) throw std::runtime_error(likelihood.error().line);
    return *likelihood;
}

cv::Mat3b with_red(const cv::Rect& box) {
    cv::Mat3b picture(300, 400, cv::Vec3b(90, 90, 90));
    cv::rectangle(picture, box, cv::Scalar(20, 20, 230), cv::FILLED);
    return with_noise(picture, 4.0, 3);
}

TEST(SmallFigureNetwork, TellsWhereAThingIsInThePicturesProportions) {
    const cv::Rect thing(20, 60, 80, 60);
    const cv::Mat1f likelihood = seen(with_red(thing));
    ASSERT_EQ(likelihood.size(), cv::Size(400, 300));
    const cv::Rect found = cv::boundingRect(likelihood >= 0.3F);
    EXPECT_EQ(found, thing);
}

TEST(SmallFigureNetwork, APictureWithoutAThingHasNone) {
    const cv::Mat1f likelihood = seen(with_red({}));
    EXPECT_EQ(cv::countNonZero(likelihood >= 0.3F), 0);
}

TEST(SmallFigureNetwork, APictureOfOneRowIsSeenToo) {
    cv::Mat3b picture(1, 900, cv::Vec3b(90, 90, 90));
    picture.colRange(500, 600) = cv::Scalar(20, 20, 230);
    EXPECT_EQ(seen(picture).size(), cv::Size(500, 1));
}

}  // namespace
}  // namespace touchline::testing
