#include "vision/figure/figure_network.h"

#include "tests/vision/figure/onnx_writer.h"

#include <string>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

TEST(FigureNetwork, TellsHowLikelyEachPlaceIsTheThingAtAnySize) {
    auto network = FigureNetwork::from_onnx(written(red_network()));
    ASSERT_TRUE(network) << network.error().line;
    cv::Mat3b picture(120, 300, cv::Vec3b(90, 90, 90));
    cv::circle(picture, {200, 60}, 40, cv::Scalar(20, 20, 230), cv::FILLED);
    for (const int side_px : {64, 192}) {
        const auto map = network->likelihood(picture, side_px);
        ASSERT_TRUE(map) << map.error().line;
        ASSERT_EQ(map->size(), cv::Size(side_px, side_px));
        EXPECT_GT((*map)(side_px / 2, side_px * 2 / 3), 0.99F);
        EXPECT_LT((*map)(side_px / 2, side_px / 4), 0.01F);
    }
}

TEST(FigureNetwork, PlanesAreRedGreenBlueAboutTheMiddleGrey) {
    OnnxGraph graph = red_network();
    graph.constants = {{"mix", {1, 3, 1, 1}, {0.5F, 0.25F, 0.125F}}, {"least", {1}, {0.5F}}};
    graph.nodes = {{"Conv", {"picture", "mix", "least"}, "likelihood", {1, 1}}};
    auto network = FigureNetwork::from_onnx(written(graph));
    ASSERT_TRUE(network) << network.error().line;
    const auto map = network->likelihood(cv::Mat3b(64, 64, cv::Vec3b(0, 192, 255)), 64);
    ASSERT_TRUE(map) << map.error().line;
    EXPECT_NEAR((*map)(10, 10), 0.5 + 0.5 * 127 / 256 + 0.25 * 64 / 256 - 0.125 * 128 / 256, 1e-5);
}

void expect_one_line(const Error& error, const std::string& why) {
    EXPECT_EQ(error.line.find("the network that finds the main thing cannot be used"), 0U);
    EXPECT_NE(error.line.find(why), std::string::npos) << error.line;
    EXPECT_EQ(error.line.find('\n'), std::string::npos);
}

TEST(FigureNetwork, OneThatIsDamagedOrOfAnotherKindIsOneLine) {
    const std::vector<std::byte> whole = written(red_network());
    for (const std::size_t size : {std::size_t{0}, std::size_t{9}, whole.size() / 2}) {
        const auto network = FigureNetwork::from_onnx(std::span(whole).first(size));
        ASSERT_FALSE(network) << size;
        expect_one_line(network.error(), "cannot be built");
    }
    OnnxGraph two_maps = red_network();
    two_maps.constants = {{"mix", {2, 3, 1, 1}, {1, 0, 0, 0, 1, 0}}, {"least", {2}, {0, 0}}};
    OnnxGraph unbounded = red_network();
    unbounded.nodes.pop_back();
    unbounded.outputs = {{"redder", {1, 1, 0, 0}}};
    for (const auto& [graph, why] :
         {std::pair(two_maps, "answers in another form"), std::pair(unbounded, "no likelihood")}) {
        auto network = FigureNetwork::from_onnx(written(graph));
        ASSERT_TRUE(network) << network.error().line;
        const auto map = network->likelihood(cv::Mat3b(64, 64, cv::Vec3b(0, 0, 255)), 64);
        ASSERT_FALSE(map) << why;
        expect_one_line(map.error(), why);
    }
}

}  // namespace
}  // namespace touchline::testing
