#include "vision/simplify/trace.h"

#include "config/types/map_frame.h"
#include "config/types/pinned.h"
#include "tests/vision/contour/shapes.h"
#include "tests/vision/pictures/canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

Shape star(cv::Size picture) {
    return test_shapes({picture.width / 2.0, picture.height / 2.0}, 0.8 * picture.height, 10.0)[2];
}

cv::Mat noise(cv::Size size, int seed) {
    cv::Mat picture(size, CV_8UC3);
    cv::RNG random(static_cast<std::uint64_t>(seed));
    random.fill(picture, cv::RNG::UNIFORM, 0, 256);
    return picture;
}

/// Returns the outlines of a trace in picture pixels; closed ones repeat their first point.
std::vector<Ring> lines_in_pixels(const Trace& trace, cv::Size picture) {
    std::vector<Ring> lines;
    for (const Outline& outline : trace.map.outlines) {
        Ring line;
        for (const Position& p : outline.points) {
            line.emplace_back(p.x * trace.report.pixels_per_metre + picture.width / 2.0,
                              picture.height / 2.0 - p.y * trace.report.pixels_per_metre);
        }
        if (outline.is_closed) {
            line.push_back(line.front());
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

void expect_one_line(const Result<Trace>& trace, const std::string& part) {
    ASSERT_FALSE(trace.has_value());
    EXPECT_NE(trace.error().line.find(part), std::string::npos) << trace.error().line;
    EXPECT_EQ(trace.error().line.find('\n'), std::string::npos);
}

TEST(Trace, OnePixelHasNoOutline) {
    expect_one_line(trace_outlines(cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(255)), {}),
                    "no outline found, because the picture is only 1 x 1 pixels");
}

TEST(Trace, AllWhiteHasNoOutline) {
    expect_one_line(trace_outlines(cv::Mat(300, 400, CV_8UC3, cv::Scalar::all(255)), {}),
                    "no outline found, because nothing in the picture stands out");
    expect_one_line(trace_outlines(cv::Mat(1, 2000, CV_8UC1, cv::Scalar::all(255)), {}),
                    "no outline found, because");
}

/// The reason is its shape, not its contrast, whatever the picture shows.
TEST(Trace, ATooFlatOrTooNarrowPictureSaysSo) {
    for (const int thickness : {1, 2, 7}) {
        cv::Mat1b stripes(thickness, 1000);
        for (int x = 0; x < stripes.cols; ++x)
            stripes.col(x) = static_cast<uchar>(x / 50 % 2 == 0 ? 255 : 0);
        const std::string side = std::to_string(thickness);
        expect_one_line(
            trace_outlines(stripes, {}),
            "the picture is 1000 x " + side + " pixels, too flat to be felt; use a higher one");
        expect_one_line(
            trace_outlines(stripes.t(), {}),
            "the picture is " + side + " x 1000 pixels, too narrow to be felt; use a wider one");
    }
}

TEST(Trace, ASmoothRampHasNoOutline) {
    cv::Mat1b ramp(200, 400);
    for (int x = 0; x < ramp.cols; ++x) {
        ramp.col(x) = static_cast<uchar>(x / 2);
    }
    expect_one_line(trace_outlines(ramp, {}), "no outline found, because");
}

TEST(Trace, UnusableArgumentsAreOneClearLine) {
    const cv::Mat picture(10, 10, CV_8UC3, cv::Scalar::all(0));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    expect_one_line(trace_outlines({}, {}), "no pixels");
    expect_one_line(trace_outlines(cv::Mat(5, 5, CV_32FC3), {}), "8-bit");
    expect_one_line(trace_outlines(picture, {.area = {nan, 0.084}}), "drawing area");
    expect_one_line(trace_outlines(picture, {.area = {0.116, 0.0}}), "drawing area");
    expect_one_line(trace_outlines(picture, {.area = {}, .detail = 0}), "detail is 0");
    expect_one_line(trace_outlines(picture, {.area = {}, .detail = 6}), "detail is 6");
    expect_one_line(trace_outlines(picture, {.area = {}, .zoom = {{nan, 0.0}, 2.0}}),
                    "choose another part");
}

/// Acts like OpenCV's own memory when it runs out, or fails with another error code.
class Failing final : public cv::MatAllocator, Pinned {
  public:
    explicit Failing(int code) : code_(code), before_(cv::Mat::getDefaultAllocator()) {
        cv::Mat::setDefaultAllocator(this);
    }

    ~Failing() override { cv::Mat::setDefaultAllocator(before_); }

    cv::UMatData* allocate(int, const int*, int, void*, std::size_t*, cv::AccessFlag,
                           cv::UMatUsageFlags) const override {
        throw cv::Exception(code_, "(-4) inside", "function", "file.cpp", 1);
    }

    bool allocate(cv::UMatData*, cv::AccessFlag, cv::UMatUsageFlags) const override {
        return false;
    }

    void deallocate(cv::UMatData*) const override {}

  private:
    int code_;
    cv::MatAllocator* before_;
};

std::string line_when_failing(int code) {
    const cv::Mat picture(30, 30, CV_8UC3, cv::Scalar::all(0));
    const Failing failing(code);
    const auto trace = trace_outlines(picture, {});
    return trace ? "a map" : trace.error().line;
}

TEST(Trace, WhatALibraryThrowsIsNotReadToAVisitor) {
    EXPECT_EQ(line_when_failing(cv::Error::StsNoMem),
              "the picture could not be traced, because there is not enough memory; try a smaller "
              "one");
    EXPECT_EQ(line_when_failing(cv::Error::StsAssert),
              "the picture could not be traced, because it is of a kind that was not foreseen; "
              "try another one");
}

TEST(Trace, NoiseIsAFewLinesAndOneSentence) {
    const auto trace = trace_outlines(noise({900, 600}, 1), {.area = {}, .detail = 5});
    ASSERT_TRUE(trace.has_value()) << trace.error().line;
    EXPECT_LE(static_cast<int>(trace->map.outlines.size()), limits_for(5, {}).strokes);
    EXPECT_GT(trace->report.simplified.left_out, 0);
    EXPECT_NE(trace->report.warning.find("grain"), std::string::npos);
    EXPECT_EQ(trace->report.warning.find('\n'), std::string::npos);
}

TEST(Trace, ACrowdedPictureIsCutInOneSentence) {
    cv::Mat1b rings(1000, 1000, uchar{255});
    for (int y = 0; y < rings.rows; ++y) {
        for (int x = 0; x < rings.cols; ++x) {  // 1600 squares of 13 pixels, 12 apart
            rings(y, x) = x % 25 < 13 && y % 25 < 13 ? 0 : 255;
        }
    }
    const auto trace =
        trace_outlines(rings, {.area = {}, .detail = 5, .picture_class = PictureClass::diagram});
    ASSERT_TRUE(trace.has_value()) << trace.error().line;
    EXPECT_GT(trace->report.outlines, 1);
    EXPECT_LE(trace->report.outlines, limits_for(5, {}).strokes);
    EXPECT_NE(trace->report.warning.find("more than can be felt"), std::string::npos);
}

TEST(Trace, TheWholePictureIsCentredInTheArea) {
    const cv::Size size(400, 200);  // wider than the area: 116 mm on 400 pixels
    const Shape square{"", {{{100, 50}, {180, 50}, {180, 120}, {100, 120}}}};
    const auto trace = trace_outlines(drawn(square, size, {}), {});
    ASSERT_TRUE(trace.has_value());
    EXPECT_NEAR(trace->report.pixels_per_metre, 400 / 0.116, 1e-9);
    double left = 1.0;
    double top = -1.0;
    for (const Position& p : trace->map.outlines.at(0).points) {
        left = std::min(left, p.x);
        top = std::max(top, p.y);
    }
    EXPECT_NEAR(left, (100 - 200) * 0.116 / 400, 0.3 * 0.116 / 400);
    EXPECT_NEAR(top, (100 - 50) * 0.116 / 400, 0.3 * 0.116 / 400);
}

TEST(Trace, EveryPointReadsBackFromItsMillimetres) {
    const cv::Size size(331, 257);
    const auto trace =
        trace_outlines(drawn(star(size), size, {}), {.area = {0.1234567891, 0.0876543219}});
    ASSERT_TRUE(trace.has_value());
    const ViewBox box = view_box_of(trace->map.area);
    EXPECT_EQ(area_of(box), trace->map.area);
    for (const Outline& outline : trace->map.outlines) {
        for (const Position& p : outline.points) {
            const ViewBoxPoint written = to_view_box(p, box);
            EXPECT_EQ(written.u_mm, on_nanometre_grid_mm(written.u_mm));
            EXPECT_EQ(written.v_mm, on_nanometre_grid_mm(written.v_mm));
            EXPECT_EQ(from_view_box(written.u_mm, written.v_mm, box), p);
        }
    }
}

/// Rings ever closer, up to the limit of the pixels: junctions everywhere.
cv::Mat1b zone_plate(int side) {
    cv::Mat1b picture(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double r2 = std::pow(x - side / 2, 2) + std::pow(y - side / 2, 2);
            picture(y, x) = cv::saturate_cast<uchar>(127.0 + 127.0 * std::sin(r2 / 300.0));
        }
    }
    return picture;
}

/// Walls between cells, randomly open to the right or below: one ring that comes near itself
/// everywhere.
cv::Mat1b maze(int cells) {
    constexpr int cell = 12;
    cv::RNG random(5);
    cv::Mat1b picture(cells * cell + 4, cells * cell + 4, uchar{255});
    for (int row = 0; row <= cells; ++row) {
        for (int column = 0; column <= cells; ++column) {
            const cv::Point corner(column * cell, row * cell);
            const bool is_across = random.uniform(0, 2) == 0;
            if (column < cells && (row == 0 || row == cells || is_across)) {
                picture(cv::Rect(corner.x, corner.y, cell + 4, 4)) = 0;
            }
            if (row < cells && (column == 0 || column == cells || !is_across)) {
                picture(cv::Rect(corner.x, corner.y, 4, cell + 4)) = 0;
            }
        }
    }
    return picture;
}

TEST(Trace, OddPicturesAreAMapOrOneLineWhateverTheirClass) {
    cv::Mat1b wide(1, 65535, uchar{255});
    wide.colRange(20000, 40000) = 0;
    cv::Mat1b tall(65535, 1, uchar{255});
    tall.rowRange(20000, 40000) = 0;
    cv::Mat1b strip(9, 4000, uchar{0});
    strip.colRange(1000, 3000) = 255;
    cv::Mat3b half(200, 300, cv::Vec3b(0, 0, 0));
    half.colRange(150, 300) = cv::Vec3b(255, 255, 255);
    const std::vector<cv::Mat> pictures{wide,
                                        tall,
                                        strip,
                                        half,
                                        cv::Mat1b(200, 300, uchar{128}),
                                        noise({301, 200}, 3),
                                        zone_plate(1000),
                                        maze(60),
                                        noise({2, 2}, 1)};
    for (const cv::Mat& picture : pictures) {
        for (const auto picture_class : {PictureClass::photo, PictureClass::diagram,
                                         PictureClass::line_art, PictureClass::text_page}) {
            SCOPED_TRACE(name_of(picture_class) + ", " + std::to_string(picture.cols) + " wide");
            const auto trace =
                trace_outlines(picture, {.area = {}, .detail = 5, .picture_class = picture_class});
            if (!trace) {
                EXPECT_EQ(trace.error().line.find('\n'), std::string::npos);
                continue;
            }
            EXPECT_LE(trace->report.outlines, limits_for(5, {}).strokes);
            for (const Outline& outline : trace->map.outlines) {
                EXPECT_GE(outline.points.size(), outline.is_closed ? 3U : 2U);
                for (const Position& p : outline.points) {
                    EXPECT_LE(std::abs(p.x), 0.5 * Area{}.width_m + 1e-9);
                    EXPECT_LE(std::abs(p.y), 0.5 * Area{}.height_m + 1e-9);
                }
            }
        }
    }
}

TEST(Trace, AThingThatFillsThePictureIsNoFrame) {
    cv::Mat3b picture(400, 400, cv::Vec3b::all(240));
    cv::rectangle(picture, {8, 8}, {391, 391}, cv::Scalar::all(30), cv::FILLED);
    cv::circle(picture, {200, 200}, 60, cv::Scalar::all(240), cv::FILLED, cv::LINE_AA);
    for (const int detail : {1, 3, 5}) {
        const auto trace = trace_outlines(picture, {.area = {}, .detail = detail});
        ASSERT_TRUE(trace);
        EXPECT_EQ(trace->report.simplified.frames_dropped, 0);
        EXPECT_GT(trace->report.simplified.line_mm, 250.0) << detail;
    }
    cv::rectangle(picture, {12, 12}, {387, 387}, cv::Scalar::all(240), cv::FILLED);
    cv::circle(picture, {200, 200}, 60, cv::Scalar::all(30), cv::FILLED, cv::LINE_AA);
    const auto framed = trace_outlines(picture, {.area = {}, .detail = 1});
    ASSERT_TRUE(framed);
    EXPECT_GT(framed->report.simplified.frames_dropped, 0);
    EXPECT_NE(framed->report.simplified.words.find("A frame around the picture is left out."),
              std::string::npos);
    const auto finer = trace_outlines(picture, {.area = {}, .detail = 3});
    ASSERT_TRUE(finer);
    EXPECT_EQ(finer->report.simplified.frames_dropped, 0);
    ASSERT_GE(finer->map.outlines.size(), 2U);
    const Position first = finer->map.outlines.front().points.front();  // the circle's
    EXPECT_NEAR(std::hypot(first.x, first.y), 0.0126, 0.001);
}

TEST(Trace, WallsBesideTheRimAreNoFrame) {
    cv::Mat3b plan(400, 560, cv::Vec3b::all(255));
    cv::rectangle(plan, {8, 8}, {551, 391}, cv::Scalar::all(0), 4);
    cv::line(plan, {200, 8}, {200, 250}, cv::Scalar::all(0), 4);
    for (const int detail : {1, 3, 5}) {
        const auto trace = trace_outlines(plan, {.area = {}, .detail = detail});
        ASSERT_TRUE(trace);
        EXPECT_EQ(trace->report.simplified.frames_dropped, 0) << detail;
        EXPECT_GT(trace->report.simplified.line_mm, 300.0) << detail;
    }
}

TEST(Trace, PartsOfAPageSayWhatTheyAre) {
    Canvas page({600, 800}, {255, 255, 255});
    for (int line = 0; line < 12; ++line) {
        page.write("felt lines need words beside them", {60.0, 80.0 + 28.0 * line},
                   {.size_px = 22.0}, {0, 0, 0});
    }
    const auto trace =
        trace_outlines(page.picture(), {.area = {}, .picture_class = PictureClass::text_page});
    ASSERT_TRUE(trace);
    EXPECT_EQ(trace->map.outlines.front().label.rfind("line of text", 0), 0U);
}

TEST(Trace, TheClassIsSaidAndCanBeChosen) {
    const cv::Size size(400, 300);
    const auto decided = trace_outlines(drawn(star(size), size, {}), {});
    ASSERT_TRUE(decided);
    EXPECT_EQ(decided->report.decision.picture_class, PictureClass::diagram);
    EXPECT_FALSE(decided->report.decision.reason.empty());
    const auto chosen = trace_outlines(drawn(star(size), size, {}),
                                       {.area = {}, .picture_class = PictureClass::photo});
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->report.decision.picture_class, PictureClass::photo);
}

TEST(Trace, ThresholdsFollowTheContrast) {
    const cv::Size size(400, 300);
    const Look plain{.ink = {70, 70, 70}, .paper = {150, 150, 150}, .blur_px = 0.7};
    const std::vector<Ring> lines =
        lines_in_pixels(*trace_outlines(drawn(star(size), size, plain), {}), size);
    for (const double gain : {0.6, 1.3}) {
        const Look look{.ink = gain * plain.ink, .paper = gain * plain.paper, .blur_px = 0.7};
        const auto trace = trace_outlines(drawn(star(size), size, look), {});
        ASSERT_TRUE(trace.has_value());
        const std::vector<Ring> other = lines_in_pixels(*trace, size);
        ASSERT_EQ(other.size(), lines.size());
        Shape truth{"", lines};
        truth.rings[0].pop_back();
        const Distances d = distances(truth, other);
        EXPECT_LT(std::max({d.smooth_px, d.corner_px, d.tip_px}), 0.6) << gain;
    }
}

TEST(Trace, IsRepeatable) {
    const cv::Size size(300, 200);
    const cv::Mat picture = drawn(star(size), size, {.blur_px = 1.0, .noise_levels = 12.0});
    const auto first = trace_outlines(picture, {.area = {}, .detail = 5});
    const auto second = trace_outlines(picture.clone(), {.area = {}, .detail = 5});
    ASSERT_TRUE(first.has_value() && second.has_value());
    ASSERT_EQ(first->map.outlines.size(), second->map.outlines.size());
    for (std::size_t i = 0; i < first->map.outlines.size(); ++i) {
        EXPECT_EQ(first->map.outlines[i].points, second->map.outlines[i].points);
    }
}

TEST(Trace, GreyAndColourOfTheSamePictureAgree) {
    const cv::Size size(300, 200);
    const cv::Mat colour = drawn(star(size), size, {});
    cv::Mat grey;
    cv::extractChannel(colour, grey, 0);
    EXPECT_EQ(trace_outlines(colour, {})->map.outlines.at(0).points,
              trace_outlines(grey, {})->map.outlines.at(0).points);
}

TEST(Trace, LargePicturesAreReducedAndStayInPlace) {
    const cv::Size size(2400, 1800);
    const Shape shape = star(size);
    const auto trace = trace_outlines(drawn(shape, size, {}), {});
    ASSERT_TRUE(trace.has_value());
    EXPECT_LT(trace->report.working_scale, 0.5);
    const Distances d = distances(shape, lines_in_pixels(*trace, size));
    EXPECT_LT(d.smooth_px * trace->report.working_scale, 0.5);
}

TEST(Trace, AHigherDetailShowsMore) {
    cv::Mat picture(300, 400, CV_8UC3, cv::Scalar::all(255));
    for (int i = 0; i < 30; ++i) {  // squares of falling size and contrast, over 4 mm apart
        const cv::Rect square(10 + 65 * (i % 6), 8 + 58 * (i / 6), 43 - i, 43 - i);
        picture(square).setTo(cv::Scalar::all(4 * i));
    }
    std::size_t previous = 0;
    for (int detail = 1; detail <= 5; ++detail) {
        const auto trace = trace_outlines(picture, {.area = {}, .detail = detail});
        ASSERT_TRUE(trace.has_value());
        EXPECT_GT(trace->map.outlines.size(), previous) << detail;
        EXPECT_EQ(static_cast<int>(trace->map.outlines.size()), trace->report.outlines);
        EXPECT_EQ(trace->report.outlines + trace->report.simplified.left_out, 30);
        std::set<std::string> ids;
        for (const Outline& outline : trace->map.outlines) {
            EXPECT_LE(outline.detail, detail);
            EXPECT_GT(outline.weight, 0.0);
            ids.insert(outline.id);
        }
        EXPECT_EQ(ids.size(), trace->map.outlines.size());
        EXPECT_EQ(trace->map.outlines.front().detail, 1);
        previous = trace->map.outlines.size();
    }
}

TEST(Trace, EdgeStrengthMarksTheLinesAtWorkingSize) {
    const cv::Size size(300, 200);
    const auto trace = trace_outlines(drawn(star(size), size, {}), {});
    ASSERT_TRUE(trace.has_value());
    ASSERT_EQ(trace->report.found.edge_strength.size(), size);
    ASSERT_EQ(trace->report.found.edge_strength.type(), CV_8UC1);
    EXPECT_GT(cv::countNonZero(trace->report.found.edge_strength > 128), 300);
    EXPECT_EQ(trace->report.found.edge_strength.at<uchar>(100, 150), 0);  // inside the star
}

/// Counts the outlines that have exactly this point.
int outlines_with(const TactileMap& map, const Position& p) {
    return static_cast<int>(std::ranges::count_if(map.outlines, [&](const Outline& outline) {
        return std::ranges::find(outline.points, p) != outline.points.end();
    }));
}

TEST(Trace, ThreeLinesThatMeetShareTheirEndPoint) {
    const cv::Size size(400, 300);
    cv::Mat picture(size, CV_8UC1, cv::Scalar(60));
    const cv::Mat lower = drawn({"", {{{200.5, 150.3}, {-10, 150.3}, {-10, 310}, {260, 310}}}},
                                size, {.ink = {150, 150, 150}, .paper = {0, 0, 0}});
    const cv::Mat right =
        drawn({"", {{{200.5, 150.3}, {260, 310}, {410, 310}, {410, -10}, {300, -10}}}}, size,
              {.ink = {230, 230, 230}, .paper = {0, 0, 0}});
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double a = lower.at<cv::Vec3b>(y, x)[0] / 150.0;
            const double b = right.at<cv::Vec3b>(y, x)[0] / 230.0;
            picture.at<uchar>(y, x) =
                cv::saturate_cast<uchar>(60.0 * (1.0 - a - b) + 150.0 * a + 230.0 * b);
        }
    }
    const auto trace = trace_outlines(picture, {.area = {}, .picture_class = PictureClass::photo});
    ASSERT_TRUE(trace.has_value());
    ASSERT_EQ(trace->map.outlines.size(), 3U);
    EXPECT_EQ(trace->report.found.junctions, 1);
    int meeting = 0;
    for (const Position& end :
         {trace->map.outlines[0].points.front(), trace->map.outlines[0].points.back()}) {
        if (outlines_with(trace->map, end) == 3) {
            ++meeting;
            EXPECT_NEAR(end.x * trace->report.pixels_per_metre + 200.0, 200.5, 1.0);
            EXPECT_NEAR(150.0 - end.y * trace->report.pixels_per_metre, 150.3, 1.0);
        }
    }
    EXPECT_EQ(meeting, 1);
}

TEST(Trace, AStraightLineRunsThroughItsJunction) {
    cv::Mat picture(300, 400, CV_8UC1, cv::Scalar(40));
    picture.colRange(0, 200) = 120;
    picture.rowRange(150, 300) = 220;
    const auto trace = trace_outlines(picture, {});
    ASSERT_TRUE(trace.has_value());
    ASSERT_EQ(trace->map.outlines.size(), 2U);
    const Outline& bar = trace->map.outlines[0];
    const Outline& stem = trace->map.outlines[1];
    EXPECT_EQ(outlines_with(trace->map, stem.points.front()) +
                  outlines_with(trace->map, stem.points.back()),
              3);
    EXPECT_NEAR(std::abs(bar.points.front().x - bar.points.back().x),
                400 / trace->report.pixels_per_metre, 1e-9);
}

TEST(Trace, WhatTheFrameCutsOffIsClosedByIt) {
    const cv::Size size(300, 200);
    const Shape disc = test_shapes({150.0, 200.0}, 160.0, 0.0)[0];
    const auto trace = trace_outlines(drawn(disc, size, {}), {});
    ASSERT_TRUE(trace.has_value());
    ASSERT_EQ(trace->map.outlines.size(), 1U);
    EXPECT_TRUE(trace->map.outlines[0].is_closed);
    const Position lowest =
        *std::ranges::min_element(trace->map.outlines[0].points, {}, &Position::y);
    EXPECT_NEAR(lowest.y * trace->report.pixels_per_metre, -100.0, 1e-6);
}

}  // namespace
}  // namespace touchline::testing
