// Tests that the workers that find a picture's lines give what the algorithms give.
#include "app/documents/trace/tracing.h"

#include "app/documents/decode/opening.h"
#include "tests/app/documents/decode/encoders.h"
#include "tests/app/documents/decode/liar_in_place.h"
#include "tests/app/documents/decode/same_maps.h"
#include "tests/vision/pictures/scenes.h"

#include <cmath>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

Page page_of(const cv::Mat& bgr) {
    Page page;
    page.picture = picture_of(bgr);
    page.told.area = {1e-4 * bgr.cols, 1e-4 * bgr.rows};
    return page;
}

std::vector<cv::Mat> pictures() {
    return {testing::photo_scene(1, {320, 240}).picture, testing::diagram(2, {300, 260}),
            testing::line_drawing(3, {420, 300}), testing::text_page(4, {400, 500})};
}

TEST(Tracing, GivesWhatTheAlgorithmsGiveBitForBit) {
    for (const cv::Mat& picture : pictures()) {
        const Page page = page_of(picture);
        const auto first = find_page_lines(page, {});
        ASSERT_TRUE(first.has_value()) << first.error().line;
        const auto found = find_lines(picture, {});
        ASSERT_TRUE(found.has_value());
        for (int detail = 1; detail <= 5; ++detail) {
            for (const Zoom& zoom : {Zoom{}, Zoom{{0.01, -0.005}, 2.0}}) {
                const TraceOptions options{Area{}, detail, zoom};
                const auto here = trace_lines(*found, options);
                const auto there = trace_page_lines(page, first->lines, options);
                ASSERT_EQ(here.has_value(), there.has_value());
                if (!here) {
                    EXPECT_EQ(here.error().line, there.error().line);
                    continue;
                }
                expect_same(here->map, there->map);
                EXPECT_EQ(here->report.warning, there->warning);
                if (detail == TraceOptions{}.detail && zoom == Zoom{})
                    expect_same(first->map->map, there->map);
            }
        }
    }
}

TEST(Tracing, ThePagesOwnAnswerIsHandedOn) {
    const auto page = open_page(encoders::png(picture_of(pictures()[1])));
    ASSERT_TRUE(page.has_value()) << page.error().line;
    ASSERT_NE(page->answer, nullptr);
    Page copied = *page;
    copied.answer.reset();
    const auto handed = trace_page(*page, {});
    const auto anew = trace_page(copied, {});
    ASSERT_TRUE(handed.has_value() && anew.has_value());
    expect_same(handed->map, anew->map);
}

TEST(Tracing, WordsAreNotFelt) {
    cv::Mat picture(300, 400, CV_8UC3, cv::Scalar::all(250));
    cv::rectangle(picture, {30, 40, 120, 90}, cv::Scalar::all(20), cv::FILLED);
    cv::rectangle(picture, {200, 150, 150, 100}, {200, 60, 30}, cv::FILLED);
    Page page = page_of(picture);
    const auto with = trace_page(page, {});
    page.words = {{28, 38, 152, 132}};
    const auto without = trace_page(page, {});
    ASSERT_TRUE(with.has_value() && without.has_value());
    EXPECT_LT(without->map.outlines.size(), with->map.outlines.size());
}

TEST(Tracing, WhatIsToldOfThePageIsToldOfTheMap) {
    Page page = page_of(pictures()[1]);
    page.told.title = "a diagram";
    page.told.description = "of something";
    page.told.labels = {{"middle", {0.0, 0.0}}};
    const auto traced = trace_page(page, {});
    ASSERT_TRUE(traced.has_value());
    EXPECT_EQ(traced->map.title, "a diagram");
    EXPECT_EQ(traced->map.description, "of something");
    ASSERT_EQ(traced->map.labels.size(), 1U);
    EXPECT_EQ(traced->map.labels[0].text, "middle");
}

TEST(Tracing, EdgesComeWhereTheyAreWanted) {
    const Page page = page_of(pictures()[0]);
    const auto without = trace_page(page, {});
    const auto with = trace_page(page, {.wants_edges = true});
    ASSERT_TRUE(without.has_value() && with.has_value());
    EXPECT_EQ(without->edges.width, 0);
    EXPECT_EQ(with->edges.width, 320);
    EXPECT_EQ(with->edges.grey.size(), std::size_t{320} * 240);
}

TEST(Tracing, NothingToFeelIsTheAlgorithmsOwnLine) {
    for (const cv::Size size : {cv::Size(1, 1), cv::Size(60, 40), cv::Size(1, 200)}) {
        const cv::Mat white(size, CV_8UC3, cv::Scalar::all(255));
        const auto traced = trace_page(page_of(white), {});
        ASSERT_FALSE(traced.has_value());
        EXPECT_EQ(traced.error().line.find("no outline found, because"), 0U)
            << size << traced.error().line;
    }
}

TEST(Tracing, OptionsOutOfRangeAreOneLine) {
    const Page page = page_of(pictures()[1]);
    const auto first = find_page_lines(page, {});
    ASSERT_TRUE(first.has_value());
    EXPECT_FALSE(trace_page_lines(page, first->lines, {Area{}, 6}).has_value());
    EXPECT_FALSE(trace_page_lines(page, first->lines, {Area{}, 3, {{}, std::nan("")}}).has_value());
    EXPECT_FALSE(trace_page_lines(page, first->lines, {Area{0.0, 1.0}, 3}).has_value());
}

TEST(Tracing, WithoutItsProgramItSaysWhatToDo) {
    const LiarInPlace nothing("/nowhere");
    const auto traced = trace_page(page_of(pictures()[1]), {});
    ASSERT_FALSE(traced.has_value());
    EXPECT_NE(traced.error().line.find("have it installed anew"), std::string::npos)
        << traced.error().line;
}

TEST(Tracing, AFrameThatIsNoneIsOneLine) {
    CameraFrame frame{PixelFormat::mjpeg, {640, 480}, 0, {1, 2, 3}};
    const auto damaged = page_of_photo(frame, {});
    ASSERT_FALSE(damaged.has_value());
    EXPECT_TRUE(is_one_sentence(damaged.error().line)) << damaged.error().line;
    frame.size = {0, 0};
    const auto empty = page_of_photo(frame, {});
    ASSERT_FALSE(empty.has_value());
    EXPECT_TRUE(is_one_sentence(empty.error().line)) << empty.error().line;
}

/// Tracing any number of pictures leaves no descriptor, no child and no memory.
TEST(Tracing, ManyPicturesLeaveNothing) {
    const Page page = page_of(pictures()[1]);
    for (int i = 0; i < 5; ++i) (void)trace_page(page, {});
    const int descriptors = open_descriptors();
    const long before_kB = resident_kB();
    for (int i = 0; i < 50; ++i) ASSERT_TRUE(trace_page(page, {}).has_value());
    EXPECT_EQ(open_descriptors(), descriptors);
    EXPECT_FALSE(has_a_child());
    EXPECT_LT(resident_kB() - before_kB, 1024);
}

}  // namespace
}  // namespace touchline
