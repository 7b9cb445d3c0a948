#include "vision/face/face_network.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include <gtest/gtest.h>

namespace touchline::testing {
namespace {

constexpr int kRows = 896;

/// The network's answer when it finds nothing.
struct Answer {
    cv::Mat1f scores = cv::Mat1f(kRows, 1, -50.0F);
    cv::Mat1f places = cv::Mat1f(kRows, 16, 0.0F);

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
    ASSERT_EQ(anchors.size(), static_cast<std::size_t>(kRows));
    for (int row = 0; row < kRows; ++row) {
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
    constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    for (const float bad : {kNoNumber, kInfinite, -kInfinite, 1e30F, -1e30F, 2000.0F}) {
        for (int k = 0; k < 8; ++k) {
            Answer answer;
            answer.add(300, 5.0F);
            answer.places(300, k) = bad;
            EXPECT_TRUE(answer.boxes().empty()) << bad << " as number " << k;
        }
    }
    for (const float bad : {kNoNumber, -kInfinite}) {
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

}  // namespace
}  // namespace touchline::testing
