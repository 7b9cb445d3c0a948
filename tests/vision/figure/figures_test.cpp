// A photograph made for the test: an animal with thin legs before a striped wall, with noise.
#include "vision/figure/figures.h"

#include "config/types/map_bytes.h"
#include "vision/simplify/trace.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

/// A likelihood of 0.97 inside the drawn parts and 0.02 outside.
class Likelihood {
  public:
    Likelihood() : map_(256, 256, 0.02F) {}

    Likelihood& disc(cv::Point centre, int radius, float value = 0.97F) {
        cv::circle(map_, centre, radius, cv::Scalar(static_cast<double>(value)), cv::FILLED);
        return *this;
    }

    [[nodiscard]] Figures in(cv::Size picture) const { return figures_of(map_, picture); }

    [[nodiscard]] Figures at(cv::Point place, const cv::Rect& part, cv::Size picture) const {
        return figure_at(map_, part, picture, place);
    }

  private:
    cv::Mat1f map_;
};

TEST(Figures, AThingIsFoundInThePicturesProportions) {
    const Figures found = Likelihood().disc({128, 128}, 60).in({900, 600});
    EXPECT_TRUE(found.is_sure);
    ASSERT_EQ(found.boxes.size(), 1U);
    EXPECT_EQ(found.mask.size(), cv::Size(900, 600));
    const double across = 900.0 * 121 / 256;
    EXPECT_NEAR(found.boxes[0].width, across, 8.0);
    EXPECT_NEAR(found.boxes[0].height, across * 600 / 900, 6.0);
    EXPECT_GE(found.mask(300, 450), 128);
    EXPECT_LT(found.mask(20, 20), 128);
    EXPECT_NEAR(found.signs.area, 3.1416 * 60 * 60 / 65536, 0.01);
}

TEST(Figures, SeveralThingsComeTheLargestFirstAndSpecksAreNone) {
    const Figures found = Likelihood()
                              .disc({60, 60}, 30)
                              .disc({180, 150}, 50)
                              .disc({240, 20}, 4)         // too small to be a thing
                              .disc({180, 150}, 3, 0.1F)  // too small for a hole
                              .in({512, 512});
    ASSERT_EQ(found.boxes.size(), 2U);
    EXPECT_GT(found.boxes[0].area(), found.boxes[1].area());
    EXPECT_LT(found.mask(40, 480), 128);
    EXPECT_GE(found.mask(300, 360), 128);
}

TEST(Figures, AHoleThatAFingerFindsStays) {
    const Figures found =
        Likelihood().disc({128, 128}, 80).disc({128, 128}, 20, 0.02F).in({512, 512});
    EXPECT_TRUE(found.is_sure);
    EXPECT_LT(found.mask(256, 256), 128);
}

TEST(Figures, NothingASpeckOrAWideHaloIsNoClearThing) {
    EXPECT_FALSE(Likelihood().in({640, 480}).is_sure);
    EXPECT_TRUE(Likelihood().in({640, 480}).boxes.empty());
    EXPECT_FALSE(Likelihood().disc({128, 128}, 7).in({640, 480}).is_sure);
    EXPECT_FALSE(Likelihood().disc({128, 128}, 60, 0.6F).in({640, 480}).is_sure);
    EXPECT_FALSE(Likelihood().disc({128, 128}, 90, 0.5F).disc({128, 128}, 60).in({64, 48}).is_sure);
}

TEST(Figures, OfALargePictureTheMaskHasAMegapixel) {
    const Figures found = Likelihood().disc({128, 128}, 60).in({8000, 6000});
    EXPECT_LE(found.mask.total(), 1'010'000U);
    EXPECT_NEAR(static_cast<double>(found.mask.cols) / found.mask.rows, 8.0 / 6.0, 0.01);
    EXPECT_EQ(Likelihood().disc({128, 128}, 60).in({5000, 1}).mask.rows, 1);
}

TEST(Figures, ThePartAroundAPlaceLiesInThePicture) {
    const cv::Size size(800, 600);
    EXPECT_EQ(part_around(size, {400, 300}, 0.5), cv::Rect(200, 100, 400, 400));
    EXPECT_EQ(part_around(size, {0, 599}, 0.5), cv::Rect(0, 200, 400, 400));
    EXPECT_EQ(part_around(size, {799, 0}, 0.9), cv::Rect(80, 0, 720, 600));
    EXPECT_EQ(part_around({1, 1}, {0, 0}, 0.25), cv::Rect(0, 0, 1, 1));
}

TEST(Figures, TheThingAtAPlaceIsFoundWhereItLiesInThePicture) {
    const cv::Rect part(400, 100, 400, 400);
    const Likelihood two = Likelihood().disc({64, 128}, 40).disc({200, 128}, 30);
    // The discs' middles: 400 + 400 * 64 / 256 = 500 and 400 + 400 * 200 / 256 = 712.
    const Figures left = two.at({505, 300}, part, {800, 600});
    ASSERT_EQ(left.boxes.size(), 1U);
    EXPECT_TRUE(left.is_sure);
    EXPECT_EQ(left.mask.size(), cv::Size(800, 600));
    EXPECT_NEAR(left.boxes[0].x, 500 - 63, 4);
    EXPECT_NEAR(left.boxes[0].width, 126, 6);
    EXPECT_GE(left.mask(300, 500), 128);
    EXPECT_LT(left.mask(300, 712), 128) << "the other thing is another one";
    EXPECT_GE(two.at({755, 300}, part, {800, 600}).mask(300, 712), 128) << "close beside it";
    EXPECT_FALSE(two.at({590, 120}, part, {800, 600}).is_sure) << "nothing lies there";
    EXPECT_TRUE(two.at({590, 120}, part, {800, 600}).boxes.empty());
}

TEST(Figures, AThingThatThePartCutsIsNotFoundInIt) {
    const Likelihood wide = Likelihood().disc({128, 60}, 100);
    EXPECT_FALSE(wide.at({300, 200}, {100, 100, 400, 400}, {800, 600}).is_sure) << "at its top";
    EXPECT_TRUE(wide.at({300, 100}, {100, 0, 400, 400}, {800, 600}).is_sure)
        << "the picture's frame may cut it";
}

TEST(Figures, AllOfAPictureIsNoThing) {
    EXPECT_FALSE(Likelihood().disc({128, 128}, 400).in({640, 480}).is_sure);
}

TEST(Figures, WhatFillsThePartIsAGround) {
    const Figures found =
        Likelihood().disc({128, 128}, 200).at({300, 300}, {100, 100, 400, 400}, {800, 600});
    EXPECT_FALSE(found.is_sure);
}

const cv::Size size_px(580, 420);  // 5 pixels a millimetre on an area of 116 x 84

/// Body, neck, head, four legs of 4 mm.
cv::Mat1b animal() {
    cv::Mat1b mask(size_px, uchar{0});
    cv::ellipse(mask, {290, 210}, {120, 55}, 0, 0, 360, cv::Scalar(255), cv::FILLED);
    cv::line(mask, {380, 190}, {430, 90}, cv::Scalar(255), 40);
    cv::ellipse(mask, {450, 85}, {45, 25}, 0, 0, 360, cv::Scalar(255), cv::FILLED);
    for (const int x : {200, 245, 335, 380})
        cv::rectangle(mask, {x - 10, 220, 20, 150}, cv::Scalar(255), cv::FILLED);
    return mask;
}

cv::Mat photo_of(const cv::Mat1b& mask) {
    cv::Mat3b picture(size_px, cv::Vec3b(150, 150, 150));
    for (int x = 0; x < size_px.width; x += 70)
        cv::rectangle(picture, {x, 0, 35, size_px.height}, cv::Scalar(185, 185, 185), cv::FILLED);
    picture.setTo(cv::Scalar(40, 60, 90), mask);
    cv::circle(picture, {290, 205}, 22, cv::Scalar(190, 200, 220), cv::FILLED);  // a spot on it
    cv::GaussianBlur(picture, picture, cv::Size(), 1.2);
    cv::Mat noise(size_px, CV_16SC3);
    cv::RNG random(7);
    random.fill(noise, cv::RNG::NORMAL, 0.0, 3.0);
    cv::Mat sum;
    picture.convertTo(sum, CV_16SC3);
    sum += noise;
    sum.convertTo(picture, CV_8UC3);
    return picture;
}

/// Returns the mask as a network gives it: a little too large, and soft.
cv::Mat1b loose(const cv::Mat1b& mask) {
    cv::Mat1b grown;
    cv::dilate(mask, grown, cv::Mat::ones(5, 5, CV_8U));
    cv::GaussianBlur(grown, grown, cv::Size(), 2.0);
    return grown;
}

Result<Trace> traced(int detail, bool has_figure) {
    const cv::Mat1b mask = animal();
    return trace_outlines(photo_of(mask),
                          {.area = {}, .detail = detail, .picture_class = PictureClass::photo},
                          has_figure ? loose(mask) : cv::Mat1b());
}

double off_mm(const TactileMap& map, const cv::Mat1b& mask, double share) {
    std::vector<std::vector<cv::Point>> truth;
    cv::findContours(mask, truth, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    std::vector<double> off;
    for (const Position& p : map.outlines.front().points) {
        const cv::Point2f at(static_cast<float>(5.0 * (1000.0 * p.x + 58.0) - 0.5),
                             static_cast<float>(5.0 * (42.0 - 1000.0 * p.y) - 0.5));
        off.push_back(std::abs(cv::pointPolygonTest(truth.front(), at, true)) / 5.0);
    }
    std::ranges::sort(off);
    return off[static_cast<std::size_t>(share * static_cast<double>(off.size() - 1))];
}

int legs_in(const TactileMap& map) {
    int crossings = 0;
    for (const Outline& outline : map.outlines) {
        for (std::size_t i = 1; i < outline.points.size(); ++i) {
            const double y = -0.022;  // below the body
            crossings += (outline.points[i - 1].y > y) != (outline.points[i].y > y) ? 1 : 0;
        }
    }
    return crossings / 2;
}

TEST(FigureLines, TheThingComesFirstWithItsLimbsAtEveryDetail) {
    for (int detail = 1; detail <= 5; ++detail) {
        SCOPED_TRACE(detail);
        const auto trace = traced(detail, true);
        ASSERT_TRUE(trace) << trace.error().line;
        EXPECT_NE(trace->map.outlines.front().label.find("main subject"), std::string::npos)
            << trace->map.outlines.front().label;
        EXPECT_LT(off_mm(trace->map, animal(), 0.9), 0.7);
        EXPECT_GE(legs_in(trace->map), 4);
    }
}

TEST(FigureLines, WhatLiesBehindIsLeftToTheTwoFinestDetails) {
    const auto behind = [](const TactileMap& map) {
        return std::ranges::count_if(map.outlines, [](const Outline& outline) {
            return std::ranges::all_of(outline.points, [](const Position& p) {
                return p.x < -0.035;  // a stripe of the wall on the left
            });
        });
    };
    for (const int detail : {1, 2, 3}) EXPECT_EQ(behind(traced(detail, true)->map), 0) << detail;
    EXPECT_GT(behind(traced(5, true)->map), 0);
    EXPECT_GT(behind(traced(3, false)->map), 0);
}

TEST(FigureLines, WhatLiesInItComesBeforeWhatLiesBehind) {
    const auto trace = traced(5, true);
    ASSERT_TRUE(trace) << trace.error().line;
    const auto spot = std::ranges::find_if(trace->map.outlines, [](const Outline& outline) {
        return std::ranges::all_of(outline.points, [](const Position& p) {
            return std::abs(p.x) < 0.006 && std::abs(p.y - 0.001) < 0.006;
        });
    });
    ASSERT_NE(spot, trace->map.outlines.end());
    const auto stripe = std::ranges::find_if(trace->map.outlines, [](const Outline& outline) {
        return outline.points.front().x < -0.035;
    });
    EXPECT_LT(spot, stripe);
}

/// The picture cuts off the left half of the thing: there is no edge along the frame.
TEST(FigureLines, AThingThatTheFrameCutsIsOpenThere) {
    const cv::Rect right_half(250, 0, 330, 420);
    const cv::Mat1b mask = animal()(right_half).clone();
    const double left_m = -0.0002 * 0.5 * right_half.width;
    for (const int detail : {1, 3, 5}) {
        SCOPED_TRACE(detail);
        const auto trace = trace_outlines(
            photo_of(animal())(right_half).clone(),
            {.area = {}, .detail = detail, .picture_class = PictureClass::photo}, loose(mask));
        ASSERT_TRUE(trace) << trace.error().line;
        const Outline& thing = trace->map.outlines.front();
        EXPECT_NE(thing.label.find("main subject"), std::string::npos) << thing.label;
        EXPECT_FALSE(thing.is_closed);
        for (const Outline& outline : trace->map.outlines)
            for (std::size_t i = 1; i < outline.points.size(); ++i)
                EXPECT_FALSE(outline.points[i - 1].x < left_m + 0.0004 &&
                             outline.points[i].x < left_m + 0.0004 &&
                             std::abs(outline.points[i].y) < 0.010)
                    << "the frame is felt as its edge";
    }
}

TEST(FigureLines, AMaskWithoutAThingChangesNothing) {
    const cv::Mat picture = photo_of(animal());
    const TraceOptions options{.area = {}, .detail = 5, .picture_class = PictureClass::diagram};
    const auto plain = trace_outlines(picture, options);
    const auto masked = trace_outlines(
        picture, options, cv::Mat1b(60, 80, uchar{255}));  // a drawing is felt as it is painted
    ASSERT_TRUE(plain && masked);
    EXPECT_EQ(*bytes_of(plain->map), *bytes_of(masked->map));
    const PhotoLines lines = photo_lines(picture, 116.0);
    const PhotoLines same = with_figure(lines, picture, cv::Mat1b(60, 80, uchar{100}), 116.0);
    EXPECT_EQ(same.chains.size(), lines.chains.size());
}

}  // namespace
}  // namespace touchline::testing
