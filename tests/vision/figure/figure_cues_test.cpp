// The pictures are made for the test: a thing on grounds of other colours.
#include "vision/figure/figure_cues.h"

#include "tests/vision/figure/with_noise.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

const cv::Point in_thing(70, 60);
const cv::Point in_ground(15, 60);

/// A red disc on a ground that grows lighter, with noise.
cv::Mat3b disc_on_ground() {
    cv::Mat3b picture(128, 128);
    for (int y = 0; y < picture.rows; ++y) picture.row(y).setTo(cv::Scalar::all(90 + y / 2));
    cv::circle(picture, in_thing, 25, cv::Scalar(40, 50, 190), cv::FILLED);
    return with_noise(picture, 4.0, 7);
}

double at(const std::array<cv::Mat1f, figure_cue_count>& cues, FigureCue cue, cv::Point place) {
    return cv::mean(
        cues[static_cast<std::size_t>(cue)](cv::Rect(place - cv::Point(4, 4), cv::Size(8, 8))))[0];
}

TEST(FigureCues, AThingOfItsOwnColourStandsOut) {
    const auto cues = figure_cues(disc_on_ground());
    for (const FigureCue cue : {FigureCue::barrier, FigureCue::side, FigureCue::unusual}) {
        EXPECT_GT(at(cues, cue, in_thing), 0.7) << static_cast<int>(cue);
        EXPECT_LT(at(cues, cue, in_ground), 0.35) << static_cast<int>(cue);
    }
    EXPECT_LT(at(cues, FigureCue::spread, in_thing), 0.5);
    EXPECT_GT(at(cues, FigureCue::spread, in_ground), 0.6);
    EXPECT_LT(at(cues, FigureCue::framed, in_thing), 0.05);
    EXPECT_GT(at(cues, FigureCue::framed, in_ground), 0.2);
    EXPECT_LT(at(cues, FigureCue::centre, {64, 64}), 0.01);
    EXPECT_GT(at(cues, FigureCue::centre, {4, 4}), 0.8);
}

/// A ring of the ground's colour round a thing: only the way out tells them apart.
TEST(FigureCues, WhatAnOutlineClosesInIsBehindABarrier) {
    cv::Mat3b picture(128, 128, cv::Vec3b(120, 120, 120));
    cv::circle(picture, {64, 64}, 30, cv::Scalar(10, 10, 10), 4);
    const auto cues = figure_cues(picture);
    EXPECT_GT(at(cues, FigureCue::barrier, {64, 64}), 0.8);
    EXPECT_LT(at(cues, FigureCue::barrier, {12, 64}), 0.05);
    EXPECT_NEAR(at(cues, FigureCue::side, {64, 64}), at(cues, FigureCue::side, {12, 64}), 0.01);
}

TEST(FigureCues, AreSharesOfOneForAnyPicture) {
    cv::Mat3b random(64, 200);
    cv::RNG(3).fill(random, cv::RNG::UNIFORM, 0, 256);
    cv::Mat3b even(16, 16, cv::Vec3b(0, 0, 0));
    cv::Mat3b white(40, 30, cv::Vec3b(255, 255, 255));
    cv::Mat3b halves(64, 64, cv::Vec3b(255, 0, 0));
    halves.colRange(32, 64).setTo(cv::Scalar(0, 255, 255));
    for (const cv::Mat3b& picture : {random, even, white, halves}) {
        for (const cv::Mat1f& cue : figure_cues(picture)) {
            ASSERT_EQ(cue.size(), picture.size());
            EXPECT_TRUE(cv::checkRange(cue, true, nullptr, 0.0, 1.0 + 1e-6));
        }
    }
}

TEST(FigureCues, OfAnEvenPictureNothingStandsOut) {
    const auto cues = figure_cues(cv::Mat3b(64, 64, cv::Vec3b(30, 160, 90)));
    for (const FigureCue cue : {FigureCue::barrier, FigureCue::side, FigureCue::unusual})
        EXPECT_LT(at(cues, cue, {32, 32}), 0.01) << static_cast<int>(cue);
}

TEST(FigureCues, AreTheSameBitsAgain) {
    const auto first = figure_cues(disc_on_ground());
    const auto second = figure_cues(disc_on_ground());
    for (std::size_t i = 0; i < figure_cue_count; ++i)
        EXPECT_TRUE(std::ranges::equal(first[i], second[i])) << i;
}

TEST(FigureCues, APictureOfAFewPixelsHasNone) {
    EXPECT_THROW((void)figure_cues(cv::Mat3b(15, 64)), cv::Exception);
}

}  // namespace
}  // namespace touchline::testing
