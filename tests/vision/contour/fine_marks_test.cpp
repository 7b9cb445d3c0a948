// Marks beside areas that are too small for an area of their own.
#include "tests/vision/pictures/canvas.h"
#include "vision/contour/regions.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using testing::Canvas;
using testing::Polyline;

constexpr double thickest_mark_px = 30.0;  // 3 mm
const cv::Scalar ink_bgr(90, 40, 20);

/// Has a black square, which makes the picture one of areas.
struct Sheet {
    Canvas canvas{{900, 650}, cv::Scalar::all(255)};

    Sheet() {
        canvas.fill({{{{40, 40}, {240, 40}, {240, 240}, {40, 240}}, true}}, cv::Scalar::all(0));
    }
};

std::vector<Chain> lines_beside_the_area(const Canvas& canvas) {
    const LabPicture lab = to_lab(canvas.picture());
    std::vector<Chain> lines = region_lines(lab, noise_of(lab), thickest_mark_px);
    std::erase_if(lines, [](const Chain& line) { return line.points.front().at.x < 250.0; });
    return lines;
}

TEST(FineMarks, DashesBesideAnAreaAreOneLine) {
    Sheet sheet;
    Canvas& canvas = sheet.canvas;
    for (int i = 0; i < 10; ++i) {
        const double x = 300.0 + 50.0 * i;
        canvas.stroke({{{{x, 400}, {x + 28.0, 400}}, false}}, 6.0, ink_bgr);
    }
    const std::vector<Chain> lines = lines_beside_the_area(canvas);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines.front().of, LineOf::dashed);
    EXPECT_NEAR(length_of(lines.front()), 478.0, 12.0);
}

TEST(FineMarks, AHairLineBesideAnAreaIsWhole) {
    for (const double width_px : {0.6, 1.0, 1.6}) {
        Sheet sheet;
        Canvas& canvas = sheet.canvas;
        canvas.stroke({testing::arc({570, 330}, {200, 150})}, width_px, ink_bgr);
        const std::vector<Chain> lines = lines_beside_the_area(canvas);
        ASSERT_EQ(lines.size(), 1U) << width_px;
        EXPECT_TRUE(lines.front().is_closed) << width_px;
    }
}

TEST(FineMarks, LettersAndSpecksAreNoLines) {
    Sheet sheet;
    Canvas& canvas = sheet.canvas;
    canvas.write("small words", {300, 300}, {"DejaVu Sans", 28.0}, ink_bgr);
    for (int i = 0; i < 4; ++i)
        canvas.fill({testing::arc({400.0 + 57.0 * i, 500}, {4, 4})}, ink_bgr);
    EXPECT_EQ(lines_beside_the_area(canvas).size(), 0U);
}

}  // namespace
}  // namespace touchline
