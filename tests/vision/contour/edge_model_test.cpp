#include "vision/contour/edge_model.h"

#include "tests/vision/contour/onnx_writer.h"
#include "tests/vision/contour/shapes.h"
#include "vision/contour/onnx_input.h"

#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline::testing {
namespace {

void expect_unusable(const OnnxGraph& graph, const std::string& why) {
    const Result<EdgeModel> model = EdgeModel::from_onnx(written(graph));
    ASSERT_FALSE(model.has_value()) << why;
    EXPECT_EQ(model.error().line.find("the edge model cannot be used, because "), 0U);
    EXPECT_NE(model.error().line.find(why), std::string::npos) << model.error().line;
    EXPECT_EQ(model.error().line.find('\n'), std::string::npos);
}

cv::Mat3b two_halves(cv::Size size) {
    cv::Mat3b picture(size, cv::Vec3b(40, 40, 40));
    picture.colRange(size.width / 2, size.width) = cv::Vec3b(200, 200, 200);
    return picture;
}

TEST(EdgeModel, TellsBoundariesAtThePicturesSize) {
    for (const cv::Size size : {cv::Size(64, 96), cv::Size(101, 67), cv::Size(33, 500)}) {
        Result<EdgeModel> model = EdgeModel::from_onnx(written(contrast_network(0.1F)));
        ASSERT_TRUE(model.has_value()) << model.error().line;
        const Result<cv::Mat1f> found = model->boundaries(two_halves(size));
        ASSERT_TRUE(found.has_value()) << found.error().line;
        ASSERT_EQ(found->size(), size);
        const int row = size.height / 2;
        EXPECT_GT((*found)(row, size.width / 2), 0.9F);
        EXPECT_GT((*found)(row, size.width / 2 - 1), 0.9F);
        EXPECT_LT((*found)(row, size.width / 4), 0.2F);
    }
}

TEST(EdgeModel, ANetworkOfOneSizeSeesThePictureAtThatSize) {
    Result<EdgeModel> model = EdgeModel::from_onnx(written(contrast_network(0.1F, 48, 80)));
    ASSERT_TRUE(model.has_value()) << model.error().line;
    const Result<cv::Mat1f> found = model->boundaries(two_halves({240, 160}));
    ASSERT_TRUE(found.has_value()) << found.error().line;
    ASSERT_EQ(found->size(), cv::Size(240, 160));
    EXPECT_GT((*found)(80, 120), 0.9F);
    EXPECT_LT((*found)(80, 60), 0.2F);
}

TEST(EdgeModel, PlanesAreRedGreenBlueFromZeroToOne) {
    OnnxGraph graph;  // 0.5 red + 0.25 green + 0 blue
    graph.constants = {{"mix", {1, 3, 1, 1}, {0.5F, 0.25F, 0.0F}}};
    graph.inputs = {{"picture", {1, 3, 0, 0}}};
    graph.nodes = {{"Conv", {"picture", "mix"}, "mixed", {1, 1}}};
    graph.outputs = {{"mixed", {1, 1, 0, 0}}};
    Result<EdgeModel> model = EdgeModel::from_onnx(written(graph));
    ASSERT_TRUE(model.has_value()) << model.error().line;
    const auto value_of = [&](const cv::Mat& picture) {
        return (*model->boundaries(picture))(10, 10);
    };
    EXPECT_NEAR(value_of(cv::Mat3b(40, 40, cv::Vec3b(0, 0, 255))), 0.5F, 1e-5F);
    EXPECT_NEAR(value_of(cv::Mat3b(40, 40, cv::Vec3b(0, 255, 0))), 0.25F, 1e-5F);
    EXPECT_NEAR(value_of(cv::Mat3b(40, 40, cv::Vec3b(255, 0, 0))), 0.0F, 1e-5F);
    EXPECT_NEAR(value_of(cv::Mat1b(40, 40, uchar{51})), 0.15F, 1e-5F);
}

TEST(EdgeModel, ItsBoundariesAreLinkedAsTheGradientsAre) {
    const cv::Size size(300, 240);
    Result<EdgeModel> model = EdgeModel::from_onnx(written(contrast_network(0.1F)));
    ASSERT_TRUE(model.has_value());
    for (const Shape& shape : test_shapes({150.0, 120.0}, 180.0, 10.0)) {
        if (shape.name == "star") {
            continue;  // its tips are narrower than this network sees
        }
        const auto found =
            photo_lines(drawn(shape, size, {.blur_px = 0.5}), 105.0,
                        [&model](const cv::Mat& picture) { return model->boundaries(picture); });
        ASSERT_TRUE(found.has_value()) << shape.name;
        const std::vector<Ring> lines = lines_in_pixels(*found, size);
        EXPECT_EQ(lines.size(), shape.rings.size()) << shape.name;
        for (const Chain& chain : found->chains) {
            EXPECT_TRUE(chain.is_closed) << shape.name;
        }
        EXPECT_LT(distances(shape, lines).smooth_px, 1.0) << shape.name;
        EXPECT_GT(cv::countNonZero(found->edge_strength >= 128), 200);
    }
}

TEST(EdgeModel, AnythingElseIsOneClearLine) {
    OnnxGraph two = contrast_network(0.1F);
    two.inputs.push_back({"second", {1, 3, 0, 0}});
    expect_unusable(two, "it has 2 inputs");
    OnnxGraph none = contrast_network(0.1F);
    none.inputs.clear();
    expect_unusable(none, "it has 0 inputs");
    OnnxGraph grey = contrast_network(0.1F);
    grey.inputs[0].shape[1] = 1;
    expect_unusable(grey, "its input is no picture of three colours");
    OnnxGraph flat = contrast_network(0.1F);
    flat.inputs[0].shape = {1, 3};
    expect_unusable(flat, "its input is no picture of three colours");
    OnnxGraph vast = contrast_network(0.1F, 1 << 20, 1 << 20);
    expect_unusable(vast, "its input is no picture of three colours");
    OnnxGraph unknown = contrast_network(0.1F);
    unknown.nodes[1].operation = "Frobnicate";
    expect_unusable(unknown, "OpenCV cannot build it");
    OnnxGraph two_maps = contrast_network(0.1F);
    two_maps.nodes.pop_back();
    two_maps.outputs = {{"sizes", {1, 2, 0, 0}}};
    expect_unusable(two_maps, "its output is no map");
    OnnxGraph infinite = contrast_network(0.1F);
    infinite.constants[2].values[0] = std::numeric_limits<float>::quiet_NaN();
    expect_unusable(infinite, "its output is not finite");
}

RC_GTEST_PROP(EdgeModel, DamagedFilesAreOneClearLine, ()) {
    std::vector<std::byte> bytes = written(contrast_network(0.1F));
    if (*rc::gen::arbitrary<bool>()) {
        bytes.resize(static_cast<std::size_t>(*rc::gen::inRange(0, 60)));  // within the first node
    } else {
        bytes = *rc::gen::container<std::vector<std::byte>>(rc::gen::map(
            rc::gen::inRange(0, 256), [](int value) { return static_cast<std::byte>(value); }));
    }
    const Result<EdgeModel> model = EdgeModel::from_onnx(bytes);
    RC_ASSERT(!model.has_value());
    RC_ASSERT(model.error().line.find('\n') == std::string::npos);
}

TEST(OnnxInput, TellsNameAndShape) {
    const auto inputs = onnx_inputs(written(contrast_network(0.1F, 321, 0)));
    ASSERT_TRUE(inputs.has_value());
    ASSERT_EQ(inputs->size(), 1U);
    EXPECT_EQ((*inputs)[0].name, "picture");
    EXPECT_EQ((*inputs)[0].shape, (std::vector<std::int64_t>{1, 3, 321, 0}));
}

TEST(OnnxInput, ConstantsListedAsInputsAreNone) {
    OnnxGraph graph = contrast_network(0.1F);
    graph.inputs.push_back({"across", {2, 3, 3, 3}});
    EXPECT_EQ(onnx_inputs(written(graph))->size(), 1U);
}

}  // namespace
}  // namespace touchline::testing
