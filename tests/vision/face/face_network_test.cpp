#include "vision/face/face_network.h"

#include "app/documents/decode/files.h"
#include "tests/vision/face/made_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

constexpr int anchor_count = 896;

/// The network's answer when it finds nothing.
struct Answer {
    cv::Mat1f scores = cv::Mat1f(anchor_count, 1, -50.0F);
    cv::Mat1f places = cv::Mat1f(anchor_count, 16, 0.0F);

    /// Adds a box of 40 x 50 with eyes, its centre (dx, dy) from the row's anchor.
    void add(int row, float score, float dx = 0.0F, float dy = 0.0F) {
        scores(row, 0) = score;
        const std::array<float, 8> values{dx, dy, 40, 50, dx - 10, dy - 8, dx + 10, dy - 8};
        std::ranges::copy(values, places.ptr<float>(row));
    }

    [[nodiscard]] std::vector<FaceBox> boxes() const { return face_boxes(scores, places); }
};

/// Lists the anchors as the network's authors describe them.
std::vector<cv::Point2d> all_anchors() {
    std::vector<cv::Point2d> anchors;
    for (const auto& [stride, at_each] : {std::pair(16, 2), std::pair(32, 6)}) {
        for (int y = stride / 2; y < 256; y += stride) {
            for (int x = stride / 2; x < 256; x += stride) {
                anchors.insert(anchors.end(), static_cast<std::size_t>(at_each),
                               {1.0 * x, 1.0 * y});
            }
        }
    }
    return anchors;
}

TEST(FaceBoxes, EachRowHasItsAnchor) {
    const std::vector<cv::Point2d> anchors = all_anchors();
    ASSERT_EQ(anchors.size(), static_cast<std::size_t>(anchor_count));
    for (int row = 0; row < anchor_count; ++row) {
        Answer answer;
        answer.add(row, 3.0F, 1.5F, -2.0F);
        const std::vector<FaceBox> boxes = answer.boxes();
        ASSERT_EQ(boxes.size(), 1U) << row;
        const cv::Point2d centre = anchors[static_cast<std::size_t>(row)] + cv::Point2d(1.5, -2.0);
        EXPECT_EQ(boxes[0].box, cv::Rect2d(centre.x - 20, centre.y - 25, 40, 50)) << row;
        EXPECT_EQ(boxes[0].left_eye, centre + cv::Point2d(-10, -8));
        EXPECT_EQ(boxes[0].right_eye, centre + cv::Point2d(10, -8));
        EXPECT_NEAR(boxes[0].likelihood, 1.0 / (1.0 + std::exp(-3.0)), 1e-9);
    }
}

TEST(FaceBoxes, WhatIsLessLikelyThanNotIsNone) {
    Answer answer;
    answer.add(100, -0.01F);
    EXPECT_TRUE(answer.boxes().empty());
    answer.add(100, 0.01F);
    EXPECT_EQ(answer.boxes().size(), 1U);
}

TEST(FaceBoxes, OfTwoOnOneFaceTheLikelierStaysAndOthersAreTheirOwn) {
    Answer answer;
    answer.add(200, 2.0F);
    answer.add(201, 4.0F, 3.0F, 2.0F);  // at the same place
    answer.add(210, 1.0F);              // 80 px beside them
    const std::vector<FaceBox> boxes = answer.boxes();
    ASSERT_EQ(boxes.size(), 2U);
    EXPECT_GT(boxes[0].likelihood, 0.98);
    EXPECT_LT(boxes[1].likelihood, 0.74);
}

FaceBox square_at(double x) {
    return {{x, 0.0, 10.0, 10.0}, {x + 2.0, 4.0}, {x + 8.0, 4.0}, 0.6};
}

TEST(FaceBoxes, ManyBoxesOfOneLookLeaveRoomForThoseOfTheNext) {
    std::vector<FaceBox> boxes;
    for (int i = 0; i < 16; ++i) boxes.push_back(square_at(20.0 * i));
    add_apart({square_at(400.0), square_at(61.0)}, boxes);
    ASSERT_EQ(boxes.size(), 17U) << "the second lies on one that is there";
    EXPECT_EQ(boxes.back().box.x, 400.0);
}

TEST(FaceBoxes, NumbersThatAreNoBoxGiveNone) {
    constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinite = std::numeric_limits<float>::infinity();
    for (const float bad : {not_a_number, infinite, -infinite, 1e30F, -1e30F, 2000.0F}) {
        for (int k = 0; k < 8; ++k) {
            Answer answer;
            answer.add(300, 5.0F);
            answer.places(300, k) = bad;
            EXPECT_TRUE(answer.boxes().empty()) << bad << " as number " << k;
        }
    }
    for (const float bad : {not_a_number, -infinite}) {
        Answer answer;
        answer.add(300, bad);
        EXPECT_TRUE(answer.boxes().empty()) << bad;
    }
    for (const float side : {0.0F, -40.0F, 3.0F, 500.0F}) {
        Answer answer;
        answer.add(300, 5.0F);
        answer.places(300, 2) = side;
        EXPECT_TRUE(answer.boxes().empty()) << side;
    }
    Answer one_eyed;
    one_eyed.add(300, 5.0F);
    one_eyed.places(300, 6) = one_eyed.places(300, 4);
    EXPECT_TRUE(one_eyed.boxes().empty()) << "it has no way up";
}

TEST(FaceBoxes, AnyNumbersGiveAFewSoundBoxes) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> any(-300.0F, 300.0F);
    for (int trial = 0; trial < 50; ++trial) {
        Answer answer;
        for (float& value : answer.scores) value = any(random);
        for (float& value : answer.places) value = any(random);
        const std::vector<FaceBox> boxes = answer.boxes();
        EXPECT_LE(boxes.size(), 16U);
        for (const FaceBox& box : boxes) {
            EXPECT_GE(box.box.width, 4.0);
            EXPECT_LE(std::max(box.box.width, box.box.height), 384.0);
        }
    }
}

std::vector<std::byte> shipped(const std::string& name) {
    return read_file(TOUCHLINE_SHIPPED_NETWORKS "/" + name + ".onnx").value();
}

class FaceNetworks : public ::testing::Test {
  protected:
    void SetUp() override {
        auto made = FaceNetwork::from_onnx(shipped("blazeface"), shipped("facemesh"));
        ASSERT_TRUE(made) << made.error().line;
        network_ = std::make_unique<FaceNetwork>(std::move(*made));
    }

    std::vector<FaceMesh> faces(const cv::Mat3b& picture, const std::vector<cv::Rect2d>& persons) {
        auto found = network_->faces(picture, persons);
        EXPECT_TRUE(found) << found.error().line;
        return found ? *found : std::vector<FaceMesh>{};
    }

    std::unique_ptr<FaceNetwork> network_;
};

const std::vector<cv::Rect2d> all{{0.0, 0.0, 640.0, 480.0}};

TEST_F(FaceNetworks, APaintedFaceIsFoundWhereItIs) {
    const MadeFace face;
    const std::vector<FaceMesh> found = faces(portrait_of(face), all);
    ASSERT_EQ(found.size(), 1U);
    const double unit = box_of(face.mesh()).width;
    for (const std::size_t i :
         {std::size_t{152}, std::size_t{33}, std::size_t{263}, std::size_t{13}}) {
        EXPECT_LT(cv::norm(found[0][i] - face.mesh()[i]), 0.15 * unit) << i;
    }
}

TEST_F(FaceNetworks, ATurnedPictureTurnsTheFace) {
    const cv::Mat3b upright = portrait_of({});
    for (const double degrees : {-35.0, 20.0, 40.0}) {
        const cv::Mat turn = cv::getRotationMatrix2D({300.0F, 220.0F}, degrees, 1.0);
        cv::Mat3b turned;
        cv::warpAffine(upright, turned, turn, upright.size(), cv::INTER_LINEAR,
                       cv::BORDER_REPLICATE);
        const std::vector<FaceMesh> found = faces(turned, all);
        ASSERT_EQ(found.size(), 1U) << degrees;
        EXPECT_NEAR(tilt_of(found[0]) * 180.0 / CV_PI, -degrees, 4.0);
    }
}

TEST_F(FaceNetworks, AFaceIsOneOnlyInThePersonThatHasIt) {
    const cv::Mat3b picture = portrait_of({});
    EXPECT_TRUE(faces(picture, {}).empty());
    EXPECT_TRUE(faces(picture, {{0.0, 0.0, 150.0, 480.0}}).empty());
    EXPECT_EQ(faces(picture, {{200.0, 100.0, 220.0, 380.0}, all[0]}).size(), 1U) << "once";
}

/// Returns a large picture with a face of 120 times `scale` pixels in it.
cv::Mat3b with_small_head(double scale) {
    cv::Mat3b small;
    cv::resize(portrait_of({}), small, {}, scale, scale, cv::INTER_AREA);
    cv::Mat3b picture(1200, 1600, cv::Vec3b(150, 140, 120));
    small.copyTo(picture(cv::Rect({900, 400}, small.size())));
    return picture;
}

TEST_F(FaceNetworks, ASmallHeadIsFoundInItsPerson) {
    EXPECT_EQ(faces(with_small_head(0.33), {{920.0, 400.0, 150.0, 400.0}}).size(), 1U);
}

TEST_F(FaceNetworks, AHeadTooSmallToBeDrawnIsNone) {
    EXPECT_TRUE(faces(with_small_head(0.2), {{920.0, 400.0, 90.0, 400.0}}).empty());
}

TEST_F(FaceNetworks, NothingAndNoiseAreNoFace) {
    cv::RNG random(3);
    for (int trial = 0; trial < 12; ++trial) {
        cv::Mat3b picture(480, 640, cv::Vec3b(20, 20, 20) * (trial % 4));
        if (trial >= 4) random.fill(picture, cv::RNG::UNIFORM, 0, 256);
        if (trial >= 8) cv::GaussianBlur(picture, picture, {}, trial);
        EXPECT_TRUE(faces(picture, all).empty()) << trial;
    }
    EXPECT_TRUE(faces({}, all).empty());
}

TEST_F(FaceNetworks, BoxesThatLieNowhereDoNoHarm) {
    const double endless = std::numeric_limits<double>::infinity();
    const double no_number = std::numeric_limits<double>::quiet_NaN();
    const cv::Mat3b picture = portrait_of({});
    for (const cv::Rect2d& box :
         {cv::Rect2d(-9e5, -9e5, 10, 10), cv::Rect2d(9e12, 0, 1, 1), cv::Rect2d(10, 10, -5, -5),
          cv::Rect2d(no_number, 0, 10, no_number)}) {
        EXPECT_TRUE(faces(picture, {box}).empty()) << box;
    }
    EXPECT_EQ(faces(picture, {{0, 0, endless, endless}}).size(), 1U) << "it holds the picture";
    EXPECT_TRUE(faces(cv::Mat3b(1, 1, cv::Vec3b(9, 9, 9)), all).empty());
    EXPECT_TRUE(faces(cv::Mat3b(3, 4000, cv::Vec3b(9, 9, 9)), {{0.0, 0.0, 4000.0, 3.0}}).empty());
}

TEST(FaceNetwork, OneOfAnotherKindIsOneLine) {
    EXPECT_FALSE(FaceNetwork::from_onnx({}, shipped("facemesh")));
    auto swapped = FaceNetwork::from_onnx(shipped("facemesh"), shipped("blazeface"));
    ASSERT_TRUE(swapped);
    const auto found = swapped->faces(portrait_of({}), all);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().line.find("the network that finds faces cannot be used"), 0U);
    EXPECT_EQ(found.error().line.find('\n'), std::string::npos);
}

TEST(PersonNetwork, TellsAPaintedPersonFromTheGround) {
    auto network = PersonNetwork::from_onnx(shipped("selfie"));
    ASSERT_TRUE(network) << network.error().line;
    const MadeFace face;
    const cv::Mat3b picture = portrait_of(face);
    const cv::Rect part = head_and_shoulders(face.mesh(), picture.size());
    const auto mask = network->mask_of(picture, part);
    ASSERT_TRUE(mask) << mask.error().line;
    ASSERT_EQ(mask->size(), cv::Size(256, 256));
    const cv::Point2d middle = face.middle - cv::Point2d(part.tl());
    EXPECT_GE(
        (*mask)(cvRound(256.0 * middle.y / part.height), cvRound(256.0 * middle.x / part.width)),
        128);
    EXPECT_LT((*mask)(8, 8), 128);
}

TEST(PersonNetwork, OneOfAnotherKindIsOneLine) {
    EXPECT_FALSE(PersonNetwork::from_onnx({}));
    auto other = PersonNetwork::from_onnx(shipped("blazeface"));
    ASSERT_TRUE(other);
    const auto mask = other->mask_of(cv::Mat3b(40, 40, cv::Vec3b(9, 9, 9)), {0, 0, 40, 40});
    ASSERT_FALSE(mask);
    EXPECT_NE(mask.error().line.find("answers in another form"), std::string::npos);
}

}  // namespace
}  // namespace touchline::testing
