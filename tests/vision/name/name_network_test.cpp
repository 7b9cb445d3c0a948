// The shipped network on pictures that the tests draw.
#include "vision/name/name_network.h"

#include "app/documents/decode/files.h"
#include "tests/vision/figure/onnx_writer.h"
#include "vision/name/names.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <rapidcheck/gtest.h>

namespace touchline::testing {
namespace {

/// Finds nothing anywhere; all distances are equal.
GridAnswer empty_answer(int side) {
    return {side, cv::Mat1f(side * side, known_kinds, 0.0F),
            cv::Mat1f(side * side, 4 * distance_steps, 0.0F)};
}

GridAnswer random_answer(int side, unsigned seed) {
    GridAnswer answer = empty_answer(side);
    std::mt19937 chance(seed);
    std::uniform_real_distribution<float> likelihood(0.0F, 0.36F);
    std::normal_distribution<float> logit(0.0F, 3.0F);
    for (float& value : answer.likelihoods) value = likelihood(chance);
    for (float& value : answer.distances) value = logit(chance);
    return answer;
}

/// Puts one thing at a cell; its sides are so many whole cells from its middle.
void put(GridAnswer& answer, cv::Point cell, int kind, float likelihood, cv::Vec4i cells) {
    const int row = cell.y * answer.side + cell.x;
    answer.likelihoods(row, kind) = likelihood;
    for (int side = 0; side < 4; ++side)
        answer.distances(row, side * distance_steps + cells[side]) = 100.0F;
}

GridAnswer mirrored(const GridAnswer& answer) {
    GridAnswer turned = empty_answer(answer.side);
    const int steps = distance_steps;
    for (int y = 0; y < answer.side; ++y) {
        for (int x = 0; x < answer.side; ++x) {
            const int from = y * answer.side + x;
            const int to = y * answer.side + answer.side - 1 - x;
            answer.likelihoods.row(from).copyTo(turned.likelihoods.row(to));
            const cv::Mat1f sides = answer.distances.row(from);
            cv::Mat1f there = turned.distances.row(to);
            sides.colRange(2 * steps, 3 * steps).copyTo(there.colRange(0, steps));
            sides.colRange(steps, 2 * steps).copyTo(there.colRange(steps, 2 * steps));
            sides.colRange(0, steps).copyTo(there.colRange(2 * steps, 3 * steps));
            sides.colRange(3 * steps, 4 * steps).copyTo(there.colRange(3 * steps, 4 * steps));
        }
    }
    return turned;
}

TEST(Detections, AThingIsWhereItsCellAndDistancesSay) {
    GridAnswer answer = empty_answer(13);  // cells of 32 pixels
    put(answer, {6, 4}, 16, 0.8F, {2, 1, 3, 4});
    const auto found = detections_of(std::vector{answer}, letterbox_of({832, 416}));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, 16);
    EXPECT_NEAR(found[0].likelihood, 0.8, 1e-6);
    // Its middle is at (208, 144) of the square; the picture fills rows 104 to 311.
    EXPECT_NEAR(found[0].box.left, (208.0 - 64) / 416, 1e-9);
    EXPECT_NEAR(found[0].box.top, (144.0 - 32 - 104) / 208, 1e-9);
    EXPECT_NEAR(found[0].box.right, (208.0 + 96) / 416, 1e-9);
    EXPECT_NEAR(found[0].box.bottom, (144.0 + 128 - 104) / 208, 1e-9);
}

TEST(Detections, WhatLiesInTheBlackBesideThePictureIsNothing) {
    GridAnswer answer = empty_answer(13);
    put(answer, {6, 0}, 0, 0.9F, {1, 0, 1, 1});  // above a wide picture
    EXPECT_TRUE(detections_of(std::vector{answer}, letterbox_of({832, 208})).empty());
    EXPECT_EQ(detections_of(std::vector{answer}, letterbox_of({416, 416})).size(), 1U);
}

TEST(Detections, OneThingIsFoundOnce) {
    GridAnswer fine = empty_answer(26);
    GridAnswer coarse = empty_answer(13);
    put(coarse, {6, 6}, 0, 0.6F, {3, 3, 3, 3});
    put(fine, {12, 12}, 0, 0.7F, {6, 6, 6, 6});   // the same person
    put(fine, {13, 13}, 17, 0.5F, {6, 6, 6, 6});  // also taken for a horse
    put(fine, {2, 2}, 0, 0.4F, {1, 1, 1, 1});     // another person
    const auto found = detections_of(std::vector{fine, coarse}, letterbox_of({416, 416}));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].likelihood, 0.7, 1e-6);
    EXPECT_NEAR(found[1].likelihood, 0.4, 1e-6);
}

TEST(Detections, ARiderIsBesideTheHorse) {
    GridAnswer answer = empty_answer(26);
    put(answer, {12, 9}, 0, 0.7F, {3, 6, 3, 6});
    put(answer, {12, 14}, 17, 0.8F, {6, 6, 6, 6});
    EXPECT_EQ(detections_of(std::vector{answer}, letterbox_of({416, 416})).size(), 2U);
}

/// Computes the same a second way: all cells, boxes from the means of their sides in pixels of the
/// square, the likeliest first, again and again.
std::vector<Detection> worked_out(const std::vector<GridAnswer>& answers, const cv::Rect& part) {
    std::vector<Detection> all;
    for (const GridAnswer& answer : answers) {
        for (int row = 0; row < answer.side * answer.side; ++row) {
            cv::Point best;
            double likelihood = 0.0;
            cv::minMaxLoc(answer.likelihoods.row(row), nullptr, &likelihood, nullptr, &best);
            if (likelihood < detected_from) continue;
            double reach[4];
            for (int side = 0; side < 4; ++side) {
                double above = 0.0;
                double below = 0.0;
                for (int step = 0; step < distance_steps; ++step) {
                    const double e =
                        std::exp(double{answer.distances(row, side * distance_steps + step)});
                    above += e * step;
                    below += e;
                }
                reach[side] = above / below * 416.0 / answer.side;
            }
            const double x = (row % answer.side * 2 + 1) * 208.0 / answer.side;
            const double y = (row / answer.side * 2 + 1) * 208.0 / answer.side;
            const double left = std::max(x - reach[0], double(part.x));
            const double top = std::max(y - reach[1], double(part.y));
            const double right = std::min(x + reach[2], double(part.x + part.width));
            const double bottom = std::min(y + reach[3], double(part.y + part.height));
            if (left >= right || top >= bottom) continue;
            all.push_back({best.x,
                           likelihood,
                           {(left - part.x) / part.width, (top - part.y) / part.height,
                            (right - part.x) / part.width, (bottom - part.y) / part.height}});
        }
    }
    std::vector<Detection> kept;
    while (!all.empty()) {
        const Detection best = *std::ranges::max_element(all, {}, &Detection::likelihood);
        kept.push_back(best);
        std::erase_if(all, [&best](const Detection& other) {
            const auto& a = best.box;
            const auto& b = other.box;
            const double w = std::min(a.right, b.right) - std::max(a.left, b.left);
            const double h = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
            const double both = std::max(w, 0.0) * std::max(h, 0.0);
            const double either = (a.right - a.left) * (a.bottom - a.top) +
                                  (b.right - b.left) * (b.bottom - b.top) - both;
            return both / either > (best.kind == other.kind ? 0.5 : 0.7);
        });
    }
    return kept;
}

RC_GTEST_PROP(Detections, AreThoseOfAComputationOfItsOwn, ()) {
    const unsigned seed = *rc::gen::arbitrary<unsigned>();
    const cv::Size picture(*rc::gen::inRange(1, 2000), *rc::gen::inRange(1, 2000));
    const std::vector answers{random_answer(26, seed), random_answer(13, seed + 1)};
    const Letterbox letterbox = letterbox_of(picture);
    const auto found = detections_of(answers, letterbox);
    const auto expected = worked_out(answers, letterbox.part);
    RC_ASSERT(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        RC_ASSERT(found[i].kind == expected[i].kind);
        RC_ASSERT(std::abs(found[i].likelihood - expected[i].likelihood) < 1e-9);
        RC_ASSERT(std::abs(found[i].box.left - expected[i].box.left) < 1e-6);
        RC_ASSERT(std::abs(found[i].box.top - expected[i].box.top) < 1e-6);
        RC_ASSERT(std::abs(found[i].box.right - expected[i].box.right) < 1e-6);
        RC_ASSERT(std::abs(found[i].box.bottom - expected[i].box.bottom) < 1e-6);
    }
}

TEST(Detections, TheMeanOfAnAnswerAndItsMirrorImageIsTheAnswer) {
    const GridAnswer answer = random_answer(13, 7);
    const GridAnswer mean = mean_of(answer, mirrored(answer));
    EXPECT_EQ(cv::norm(mean.likelihoods, answer.likelihoods, cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::norm(mean.distances, answer.distances, cv::NORM_INF), 0.0);
    const GridAnswer other = random_answer(13, 8);
    const GridAnswer both = mean_of(answer, mirrored(other));
    const cv::Mat expected = 0.5 * answer.likelihoods + 0.5 * other.likelihoods;
    EXPECT_LT(cv::norm(both.likelihoods, expected, cv::NORM_INF), 1e-6);
}

TEST(Detections, APictureLiesInTheMiddleOfItsSquare) {
    EXPECT_EQ(letterbox_of({416, 416}).part, cv::Rect(0, 0, 416, 416));
    EXPECT_EQ(letterbox_of({4000, 3000}).part, cv::Rect(0, 52, 416, 312));
    EXPECT_EQ(letterbox_of({1, 100000}).part, cv::Rect(207, 0, 1, 416));
    EXPECT_EQ(letterbox_of({100000, 1}).part, cv::Rect(0, 207, 416, 1));
    EXPECT_EQ(letterbox_of({1, 1}).part, cv::Rect(0, 0, 416, 416));
}

TEST(Detections, NumbersThatAreNoneGiveNoBox) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float endless = std::numeric_limits<float>::infinity();
    const float huge = std::numeric_limits<float>::max();
    const Letterbox letterbox = letterbox_of({416, 300});
    for (const float odd : {nan, endless, -endless, huge, -huge, 0.0F}) {
        GridAnswer answer = empty_answer(13);
        answer.likelihoods.setTo(odd);
        answer.distances.setTo(odd);
        for (const Detection& found : detections_of(std::vector{answer}, letterbox)) {
            EXPECT_TRUE(is_sound(found.box)) << odd;
            EXPECT_TRUE(found.likelihood >= detected_from && found.likelihood <= 1.0) << odd;
        }
        answer.likelihoods.setTo(0.9F);
        for (const Detection& found : detections_of(std::vector{answer}, letterbox))
            EXPECT_TRUE(is_sound(found.box)) << odd;
    }
    GridAnswer answer = empty_answer(13);
    answer.likelihoods.setTo(nan);
    EXPECT_TRUE(detections_of(std::vector{answer}, letterbox).empty());
    put(answer, {6, 6}, 3, 0.9F, {2, 2, 2, 2});
    answer.distances.setTo(nan);
    EXPECT_TRUE(detections_of(std::vector{answer}, letterbox).empty());
}

TEST(Detections, APictureMadeToFillEveryCellEnds) {
    std::vector<GridAnswer> answers;
    for (const int side : {52, 26, 13}) {
        GridAnswer answer = empty_answer(side);
        for (int row = 0; row < side * side; ++row) {
            put(answer, {row % side, row / side}, row % known_kinds, 0.9F, {0, 0, 0, 0});
            for (int side_of = 0; side_of < 4; ++side_of)
                answer.distances(row, side_of * distance_steps + 1) = 97.0F;  // none overlap
        }
        answers.push_back(answer);
    }
    const auto found = detections_of(answers, letterbox_of({416, 416}));
    EXPECT_LE(found.size(), 52U * 52U + 26U * 26U + 13U * 13U);
    EXPECT_GT(found.size(), 2000U);
}

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
