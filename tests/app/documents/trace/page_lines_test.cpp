// Tests that a page's words are heard, and that the lines beneath them are felt.
#include "app/documents/trace/page_lines.h"

#include "app/documents/decode/page.h"
#include "tests/vision/pictures/canvas.h"

#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr int width_px = 600;
constexpr int height_px = 400;

/// A line from left to right through the middle, and a word.
Page page_with(const std::string& word, const WordBox& box, double size_px, const cv::Scalar& ink) {
    testing::Canvas canvas({width_px, height_px}, {255, 255, 255});
    if (!word.empty())
        canvas.write(word, {static_cast<double>(box.left), static_cast<double>(box.bottom)},
                     {"DejaVu Sans", size_px, false, false}, ink);
    canvas.stroke({{{{40.0, 200.0}, {560.0, 200.0}}, false}}, 3.0, {0, 0, 0});
    const cv::Mat drawn = canvas.picture();
    Page page;
    page.picture = {width_px, height_px, {drawn.datastart, drawn.dataend}};
    page.told.area = {0.06, 0.04};
    page.words = {box};
    return page;
}

/// Returns the length of all lines, in pixels of the page.
double length_px(const Page& page) {
    const auto bytes = answer_of(page);
    EXPECT_TRUE(bytes.has_value());
    const auto found = find_lines_of_page(*bytes, {});
    EXPECT_TRUE(found.has_value()) << found.error().line;
    double sum = 0.0;
    if (found)
        for (const Chain& line : found->lines.chains) sum += length_of(line);
    return sum;
}

TEST(PageLines, AWordBesideALineGoes) {
    EXPECT_NEAR(length_px(page_with("Circle", {200, 60, 330, 102}, 40.0, {0, 0, 0})), 520.0, 8.0);
}

TEST(PageLines, ALineThroughTheBoxOfAWordStays) {
    EXPECT_NEAR(length_px(page_with("", {200, 180, 330, 220}, 40.0, {0, 0, 0})), 520.0, 8.0);
    EXPECT_NEAR(length_px(page_with("oo", {300, 150, 350, 190}, 40.0, {0, 0, 0})), 520.0, 8.0);
}

TEST(PageLines, AWordAcrossThePageTakesNoLineAway) {
    EXPECT_NEAR(length_px(page_with("DRAFT", {60, 90, 540, 250}, 150.0, {220, 220, 220})), 520.0,
                30.0);
}

TEST(PageLines, ADarkWordOnAPaleLineGoesAndTheLineStays) {
    testing::Canvas canvas({width_px, height_px}, {255, 255, 255});
    canvas.stroke({{{{40.0, 200.0}, {560.0, 200.0}}, false}}, 5.0, {190, 190, 190});
    canvas.write("Harbour", {200.0, 212.0}, {"DejaVu Sans", 40.0, false, false}, {0, 0, 0});
    const cv::Mat drawn = canvas.picture();
    Page page;
    page.picture = {width_px, height_px, {drawn.datastart, drawn.dataend}};
    page.told.area = {0.06, 0.04};
    page.words = {{200, 180, 372, 214}};
    // This leaves out what the strokes of the letters cover.
    EXPECT_NEAR(length_px(page), 495.0, 30.0);
}

TEST(PageLines, ASmallDrawingBesideALargePaleLetterStays) {
    // Letters are painted over one by one: at the last one the others are already gone, and the
    // drawing is most of what is left around it.
    testing::Canvas canvas({width_px, height_px}, {255, 255, 255});
    const testing::Font font{"DejaVu Sans", 200.0, false, false};
    canvas.write("I", {120.0, 300.0}, font, {215, 215, 215});
    canvas.write("L", {300.0, 300.0}, font, {215, 215, 215});
    canvas.stroke({{{{380.0, 180.0}, {420.0, 180.0}, {420.0, 240.0}, {380.0, 240.0}}, true}}, 4.0,
                  {0, 0, 0});
    const cv::Mat drawn = canvas.picture();
    Page page;
    page.picture = {width_px, height_px, {drawn.datastart, drawn.dataend}};
    page.told.area = {0.06, 0.04};
    page.words = {{139, 154, 159, 300}, {319, 154, 420, 300}};
    EXPECT_NEAR(length_px(page), 200.0, 8.0);
}

}  // namespace
}  // namespace touchline
