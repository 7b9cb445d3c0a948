// The shipped network on pictures that the tests draw.
#include "app/documents/decode/files.h"
#include "tests/vision/face/made_face.h"
#include "vision/face/face_lines.h"
#include "vision/face/face_network.h"

#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

cv::Mat1f likelihood(const cv::Mat3b& picture, const std::vector<cv::Rect2d>& people) {
    static PersonNetwork network =
        PersonNetwork::from_onnx(read_file(TOUCHLINE_SHIPPED_NETWORKS "/selfie.onnx").value())
            .value();
    const auto found = people_likelihood(picture, people, network);
    EXPECT_TRUE(found) << found.error().line;
    return found ? *found : cv::Mat1f();
}

/// The box of the painted head.
const cv::Rect2d head(210.0, 110.0, 180.0, 220.0);

TEST(People, APersonIsLikelyInItsBoxAndNothingIsElsewhere) {
    const cv::Mat1f found = likelihood(portrait_of({}), {head});
    ASSERT_EQ(found.size(), made_picture);
    EXPECT_GT(found(220, 300), 0.5F);
    EXPECT_TRUE(cv::checkRange(found, true, nullptr, 0.0, 1.0 + 1e-6));
    const double beyond_px = 0.04 * head.height + 1.0;
    const cv::Point2d beyond(beyond_px, beyond_px);
    cv::Mat1f outside = found.clone();
    outside(part_within({head.tl() - beyond, head.br() + beyond}, made_picture)).setTo(0.0F);
    EXPECT_EQ(cv::countNonZero(outside), 0);
}

TEST(People, NoBoxAndASmallOneFindNobody) {
    EXPECT_EQ(cv::countNonZero(likelihood(portrait_of({}), {})), 0);
    EXPECT_EQ(cv::countNonZero(likelihood(portrait_of({}), {{270.0, 190.0, 60.0, 60.0}})), 0);
    EXPECT_GT(cv::countNonZero(likelihood(portrait_of({}), {{265.0, 190.0, 70.0, 70.0}})), 0);
}

TEST(People, FiveCountAtMostAndSmallOnesAreNotAmongThem) {
    const cv::Rect2d corner(0.0, 0.0, 80.0, 80.0);
    const cv::Rect2d small(0.0, 0.0, 10.0, 10.0);
    const auto face = [&](const std::vector<cv::Rect2d>& people) {
        return likelihood(portrait_of({}), people)(220, 300);
    };
    EXPECT_GT(face({corner, corner, corner, corner, head}), 0.5F);
    EXPECT_EQ(face({corner, corner, corner, corner, corner, head}), 0.0F);
    EXPECT_GT(face({small, small, small, small, small, head}), 0.5F);
}

TEST(People, BoxesThatHoldNothingOfThePictureDoNotCount) {
    const double endless = std::numeric_limits<double>::infinity();
    const double no_number = std::numeric_limits<double>::quiet_NaN();
    const cv::Mat3b picture = portrait_of({});
    for (const cv::Rect2d& box :
         {cv::Rect2d(-300.0, 0.0, 280.0, 400.0), cv::Rect2d(660.0, 0.0, 300.0, 480.0),
          cv::Rect2d(-9e12, 0.0, 1e6, 1e6), cv::Rect2d(400.0, 400.0, -300.0, -300.0),
          cv::Rect2d(0.0, 0.0, endless, endless), cv::Rect2d(no_number, 0.0, 300.0, 300.0),
          cv::Rect2d(0.0, 0.0, no_number, 300.0), cv::Rect2d(-endless, 0.0, endless, 300.0)}) {
        EXPECT_EQ(cv::countNonZero(likelihood(picture, {box})), 0) << box;
    }
}

TEST(People, AnyBoxOfAnyPictureHasALikelihoodOfItsSize) {
    std::mt19937 random(13);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (const cv::Size size : {cv::Size(1, 1), cv::Size(11, 7), cv::Size(3, 200)}) {
        const cv::Mat3b picture(size, cv::Vec3b(90, 120, 150));
        EXPECT_EQ(likelihood(picture, {{1.5, 0.0, 1e3, 1e3}}).size(), size);
        for (int trial = 0; trial < 20; ++trial) {
            const cv::Rect2d box(between(-1.0, 1.0) * size.width, between(-1.0, 1.0) * size.height,
                                 between(0.0, 2.0) * size.width, between(0.0, 2.0) * size.height);
            EXPECT_EQ(likelihood(picture, {box}).size(), size) << box;
        }
    }
}

TEST(People, APartOfAPictureLiesInIt) {
    EXPECT_EQ(part_within({1.5, 0.0, 20.0, 3.0}, {11, 7}), cv::Rect(2, 0, 9, 3));
    EXPECT_TRUE(part_within({11.0, 0.0, 5.0, 5.0}, {11, 7}).empty());
    EXPECT_TRUE(part_within({3.1, 3.1, 0.2, 0.2}, {11, 7}).empty()) << "no whole pixel";
    std::mt19937 random(17);
    std::uniform_real_distribution<double> any(-15.0, 15.0);
    for (int trial = 0; trial < 2000; ++trial) {
        const cv::Rect part =
            part_within({any(random), any(random), any(random), any(random)}, {11, 7});
        EXPECT_EQ(part & cv::Rect(0, 0, 11, 7), part) << part;
    }
}

TEST(People, ANetworkOfAnotherKindIsOneLine) {
    auto other =
        PersonNetwork::from_onnx(read_file(TOUCHLINE_SHIPPED_NETWORKS "/blazeface.onnx").value());
    ASSERT_TRUE(other);
    const auto found = people_likelihood(portrait_of({}), std::vector{head}, *other);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().line.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace touchline::testing
