// The shipped network on pictures that the tests draw.
#include "vision/name/name_network.h"

#include "app/decode/files.h"
#include "tests/vision/figure/onnx_writer.h"
#include "vision/name/names.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

std::vector<std::byte> shipped() {
    return read_file(TOUCHLINE_SHIPPED_NETWORKS "/nanodet.onnx").value();
}

NameNetwork& network() {
    static NameNetwork network = NameNetwork::from_onnx(shipped()).value();
    return network;
}

/// The aeroplane's box in its picture of 600 x 400.
const cv::Rect aeroplane_px(158, 125, 270, 172);

cv::Mat3b aeroplane() {
    cv::Mat3b near(400, 600);
    for (int y = 0; y < near.rows; ++y)
        near.row(y).setTo(cv::Scalar(230.0 - y * 0.1, 190.0 - y * 0.05, 140.0 - y * 0.05));
    const auto wing = [&near](const std::vector<cv::Point>& corners) {
        cv::fillPoly(near, corners, cv::Scalar(95, 90, 90), cv::LINE_AA);
    };
    cv::ellipse(near, {300, 200}, {170, 16}, 0.0, 0.0, 360.0, cv::Scalar(230, 225, 225), cv::FILLED,
                cv::LINE_AA);
    wing({{290, 205}, {340, 205}, {220, 330}, {190, 330}});
    wing({{290, 195}, {340, 195}, {240, 100}, {215, 100}});
    wing({{140, 198}, {180, 192}, {130, 130}, {110, 130}});
    cv::Mat3b far;
    cv::resize(near, far, {450, 300}, 0.0, 0.0, cv::INTER_AREA);
    cv::copyMakeBorder(far, far, 50, 50, 75, 75, cv::BORDER_REPLICATE);
    return far;
}

TEST(NameNetwork, AnAeroplaneIsNamedWhereItIs) {
    const auto found = network().detections(aeroplane());
    ASSERT_TRUE(found) << found.error().line;
    const auto things = names_of(*found);
    ASSERT_EQ(things.size(), 1U);
    EXPECT_EQ(things[0].name, ThingName::aeroplane);
    // numpy computed these from the same picture and file, without any code of this repository.
    EXPECT_NEAR(things[0].likelihood, 0.8093, 0.001);
    EXPECT_NEAR(things[0].box.left * 600, aeroplane_px.x, 15);
    EXPECT_NEAR(things[0].box.right * 600, aeroplane_px.br().x, 15);
    EXPECT_NEAR(things[0].box.top * 400, aeroplane_px.y, 15);
    EXPECT_NEAR(things[0].box.bottom * 400, aeroplane_px.br().y, 15);
    EXPECT_TRUE(people_in(*found).empty());
}

TEST(NameNetwork, TheMirrorImageHasTheSameThingsMirrored) {
    const cv::Mat3b picture = aeroplane();
    cv::Mat3b mirror_image;
    cv::flip(picture, mirror_image, 1);
    const auto things = network().detections(picture).value();
    const auto mirrored = network().detections(mirror_image).value();
    ASSERT_EQ(things.size(), mirrored.size());
    ASSERT_FALSE(things.empty());
    EXPECT_EQ(things[0].kind, mirrored[0].kind);
    EXPECT_NEAR(things[0].likelihood, mirrored[0].likelihood, 1e-3);
    EXPECT_NEAR(things[0].box.left, 1.0 - mirrored[0].box.right, 1e-3);
    EXPECT_NEAR(things[0].box.top, mirrored[0].box.top, 1e-3);
    const auto once = network().detections(picture, false).value();
    ASSERT_FALSE(once.empty());
    EXPECT_GT(std::abs(once[0].likelihood - things[0].likelihood), 1e-6) << "one look is not two";
}

TEST(NameNetwork, APictureThatShowsNothingIsGivenNoName) {
    cv::Mat3b noise(300, 500);
    cv::randu(noise, cv::Scalar::all(0), cv::Scalar::all(256));
    cv::Mat3b slope(300, 500);
    for (int x = 0; x < slope.cols; ++x) slope.col(x).setTo(cv::Scalar::all(x / 2));
    cv::Mat3b squares(400, 400, cv::Vec3b(255, 255, 255));
    for (int i = 0; i < 100; ++i) {
        const cv::Rect square(i % 10 * 40, i / 10 * 40, 40, 40);
        if ((i % 10 + i / 10) % 2 == 0) squares(square).setTo(0);
    }
    for (const cv::Mat3b& picture :
         {cv::Mat3b(300, 400, cv::Vec3b(0, 0, 0)), cv::Mat3b(300, 400, cv::Vec3b(255, 255, 255)),
          cv::Mat3b(1, 1, cv::Vec3b(90, 90, 90)), cv::Mat3b(3, 3000, cv::Vec3b(90, 120, 90)), noise,
          slope, squares}) {
        const auto found = network().detections(picture);
        ASSERT_TRUE(found) << found.error().line;
        EXPECT_TRUE(names_of(*found).empty()) << picture.size();
    }
}

void expect_one_line(const Error& error, const std::string& why) {
    EXPECT_EQ(error.line.find("the network that names things cannot be used"), 0U) << error.line;
    EXPECT_NE(error.line.find(why), std::string::npos) << error.line;
    EXPECT_EQ(error.line.find('\n'), std::string::npos);
}

TEST(NameNetwork, OneThatIsDamagedOrOfAnotherKindIsOneLine) {
    const auto whole = shipped();
    for (const std::size_t size : {std::size_t{0}, std::size_t{9}, whole.size() / 2}) {
        const auto damaged = NameNetwork::from_onnx(std::span(whole).first(size));
        ASSERT_FALSE(damaged) << size;
        expect_one_line(damaged.error(), "cannot be built");
    }
    auto other = NameNetwork::from_onnx(written(red_network()));
    ASSERT_TRUE(other) << other.error().line;
    const auto found = other->detections(aeroplane());
    ASSERT_FALSE(found);
    expect_one_line(found.error(), "answers in another form");
}

}  // namespace
}  // namespace touchline::testing
