#include "vision/prepare/text_boxes.h"

#include "tests/vision/pictures/canvas.h"
#include "tests/vision/pictures/effects.h"
#include "tests/vision/pictures/scenes.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

PageLayout layout_of(const cv::Mat& picture) {
    const LabPicture lab = to_lab(picture);
    return page_layout(ink_of(lab, noise_of(lab)));
}

TEST(PageLayout, LinesAndAFigureWhereTheyAre) {
    for (int kind = 0; kind < 6; ++kind) {
        SCOPED_TRACE("effects " + std::to_string(kind));
        testing::Canvas canvas({700, 600}, {250, 250, 250});
        const testing::Font font{"DejaVu Serif", 24.0, false, false};
        std::vector<cv::Rect> lines;
        for (int i = 0; i < 5; ++i) {
            const std::string text = "The quick brown fox number " + std::to_string(i);
            const cv::Point2d at(60.0, 80.0 + 45.0 * i);
            canvas.write(text, at, font, {20, 20, 20});
            lines.emplace_back(60, static_cast<int>(at.y) - 19,
                               static_cast<int>(canvas.width_of(text, font)), 25);
        }
        canvas.fill({testing::arc({350.0, 450.0}, {150.0, 90.0})}, {160, 60, 20});
        const PageLayout layout =
            layout_of(testing::seen(canvas.picture(), testing::effects_of_kind(kind, kind)));
        ASSERT_EQ(layout.lines.size(), lines.size());
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const double common = (layout.lines[i].box & lines[i]).area();
            EXPECT_GE(common, 0.8 * lines[i].area());
            EXPECT_GE(common, 0.75 * layout.lines[i].box.area());
        }
        ASSERT_EQ(layout.figures.size(), 1U);
        EXPECT_LE(cv::norm(layout.figures[0].tl() - cv::Point(200, 360)), 6.0);
        EXPECT_LE(cv::norm(layout.figures[0].br() - cv::Point(500, 540)), 6.0);
    }
}

TEST(PageLayout, NoTextInADrawing) {
    for (int seed = 0; seed < 20; ++seed) {
        const PageLayout layout = layout_of(testing::line_drawing(seed, {640, 480}));
        EXPECT_LE(layout.lines.size(), 1U) << seed;  // a drawing may have a title
    }
}

TEST(PageLayout, TilesInRowsAreNoText) {
    cv::Mat tiles(600, 600, CV_8UC3, cv::Scalar::all(250));
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 8; ++column) {
            tiles(cv::Rect(60 + 60 * column, 60 + 60 * row, 30, 30)) = cv::Scalar::all(40);
        }
    }
    EXPECT_TRUE(layout_of(tiles).lines.empty());
}

TEST(PageLayout, AnEmptyPageHasNothing) {
    const PageLayout layout = layout_of(cv::Mat(100, 100, CV_8UC3, cv::Scalar::all(250)));
    EXPECT_TRUE(layout.lines.empty());
    EXPECT_TRUE(layout.figures.empty());
}

}  // namespace
}  // namespace touchline
