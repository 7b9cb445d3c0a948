// Counts closed shapes and holes: as areas of flat colour, and as wide ink with an outline.

#include "tests/vision/pictures/canvas.h"
#include "tests/vision/pictures/effects.h"
#include "vision/contour/regions.h"
#include "vision/contour/strokes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

using testing::Canvas;
using testing::Font;
using testing::Polyline;

constexpr double any_width_px = 0.01;  // everything is wider: outlines only

/// Counts the shapes and holes of a clean black and white picture, cut at this grey level.
int rings_in(const cv::Mat& picture, int level = 128) {
    cv::Mat grey;
    cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
    cv::Mat label;
    const int shapes = cv::connectedComponents(grey < level, label, 8) - 1;
    const int holes = cv::connectedComponents(grey >= level, label, 4) - 2;  // minus ink and paper
    return shapes + holes;
}

void expect_rings(const cv::Mat& picture, int rings) {
    const LabPicture lab = to_lab(picture);
    const double noise = noise_of(lab);
    for (const std::vector<Chain>& lines :
         {region_lines(lab, noise, any_width_px), stroke_lines(lab, noise, any_width_px)}) {
        EXPECT_EQ(static_cast<int>(lines.size()), rings);
        EXPECT_TRUE(std::ranges::all_of(lines, &Chain::is_closed));
    }
}

TEST(ClosedShapes, GlyphsHaveTheirRings) {
    const std::vector<Font> fonts{{"DejaVu Sans", 0.0, false, false},
                                  {"DejaVu Serif", 0.0, true, false},
                                  {"DejaVu Sans Mono", 0.0, true, false}};
    const std::string letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789&@%#?!";
    int kind = 0;
    int asked = 0;
    for (const Font& font : fonts) {
        for (const char letter : letters) {
            ++kind;
            Font sized = font;
            sized.size_px = 120.0 + 35.0 * (kind % 4);
            SCOPED_TRACE(std::string(1, letter) + " " + font.family + ", kind " +
                         std::to_string(kind));
            const int side = static_cast<int>(1.6 * sized.size_px);
            Canvas canvas({side, side}, {255, 255, 255});
            canvas.write(std::string(1, letter), {0.2 * side, 0.7 * side}, sized, {0, 0, 0});
            const int rings = rings_in(canvas.picture());
            if (rings_in(canvas.picture(), 60) != rings || rings_in(canvas.picture(), 195) != rings)
                continue;  // a gap of less than a pixel: no picture shows it
            ++asked;
            testing::Effects effects = testing::effects_of_kind(kind, kind);
            effects.blur_px = std::min(effects.blur_px, 0.8);
            expect_rings(testing::seen(canvas.picture(), effects), rings);
        }
    }
    EXPECT_GE(asked, 190);
}

// Compression makes grey spots in black ink, which are no colour of their own.
TEST(ClosedShapes, SmallLettersOfAJpegHaveTheirRings) {
    int asked = 0;
    for (const double size_px : {70.0, 95.0}) {
        for (const char letter : std::string("AKMYZgkox27@?")) {
            for (const double shift_px : {0.0, 1.7, 3.4}) {
                SCOPED_TRACE(letter + std::to_string(size_px) + " px, " + std::to_string(shift_px));
                const int side = static_cast<int>(1.6 * size_px);
                Canvas canvas({side, side}, {255, 255, 255});
                canvas.write(std::string(1, letter), {0.2 * side + shift_px, 0.7 * side + shift_px},
                             {"DejaVu Serif", size_px, true, false}, {0, 0, 0});
                const int rings = rings_in(canvas.picture());
                if (rings_in(canvas.picture(), 60) != rings ||
                    rings_in(canvas.picture(), 195) != rings)
                    continue;
                ++asked;
                expect_rings(testing::seen(canvas.picture(), {.jpeg_quality = 50}), rings);
            }
        }
    }
    EXPECT_GE(asked, 70);
}

TEST(ClosedShapes, ClipArtHasItsRings) {
    for (int kind = 0; kind < 36; ++kind) {
        SCOPED_TRACE("kind " + std::to_string(kind));
        cv::RNG random(static_cast<std::uint64_t>(kind) + 99U);
        Canvas canvas({480, 360}, {255, 255, 255});
        for (int cell = 0; cell < 6; ++cell) {  // a shape in each sixth, with 0 to 2 holes
            const cv::Point2d middle(80.0 + 160.0 * (cell % 3), 90.0 + 180.0 * (cell / 3));
            std::vector<Polyline> rings{
                testing::arc(middle, {random.uniform(50.0, 70.0), random.uniform(50.0, 70.0)})};
            for (int hole = random.uniform(0, 3); hole > 0; --hole) {
                rings.push_back(
                    testing::arc(middle + cv::Point2d(hole == 1 ? -22.0 : 22.0, 0.0),
                                 {random.uniform(8.0, 18.0), random.uniform(8.0, 30.0)}));
            }
            canvas.fill(rings, {0, 0, 0});
        }
        expect_rings(testing::seen(canvas.picture(), testing::effects_of_kind(kind, kind)),
                     rings_in(canvas.picture()));
    }
}

TEST(RegionLines, ABorderIsOneLineAndItsPlaceIsRight) {
    for (int kind = 0; kind < 6; ++kind) {
        SCOPED_TRACE("effects " + std::to_string(kind));
        Canvas canvas({400, 300}, {250, 250, 250});
        canvas.fill({testing::arc({200.0, 150.0}, {120.0, 120.0})}, {40, 60, 200});
        canvas.fill({testing::arc({200.0, 150.0}, {60.0, 60.0})}, {200, 160, 40});
        const LabPicture lab =
            to_lab(testing::seen(canvas.picture(), testing::effects_of_kind(kind, kind)));
        const std::vector<Chain> lines = region_lines(lab, noise_of(lab), any_width_px);
        ASSERT_EQ(lines.size(), 2U);
        for (const Chain& line : lines) {
            EXPECT_TRUE(line.is_closed);
            double sum = 0.0;
            double worst = 0.0;
            const double radius = length_of(line) > 550.0 ? 120.0 : 60.0;
            for (const EdgePoint& point : line.points) {
                const double off =
                    distance(point.at + cv::Point2d(0.5, 0.5), {200.0, 150.0}) - radius;
                sum += off;
                worst = std::max(worst, std::abs(off));
            }
            // Half-way in Lab is not quite half-way in light.
            EXPECT_NEAR(sum / static_cast<double>(line.points.size()), 0.0, 0.3);
            EXPECT_LE(worst, 1.0);
        }
    }
}

TEST(RegionLines, ThreeColoursMeetInOnePoint) {
    Canvas canvas({300, 300}, {255, 255, 255});
    canvas.fill({{{{50, 50}, {250, 50}, {250, 150}, {50, 150}}, true}}, {30, 30, 200});
    canvas.fill({{{{50, 150}, {250, 150}, {250, 250}, {50, 250}}, true}}, {200, 120, 30});
    const LabPicture lab = to_lab(canvas.picture());
    const std::vector<Chain> lines = region_lines(lab, noise_of(lab), any_width_px);
    // The border between the two, and the outer ring or its two halves; ends meet ends bit for bit.
    std::vector<cv::Point2d> ends;
    for (const Chain& line : lines) {
        if (!line.is_closed) {
            ends.push_back(line.points.front().at);
            ends.push_back(line.points.back().at);
        }
    }
    ASSERT_GE(ends.size(), 2U);
    for (const cv::Point2d& end : ends) {
        int lines_there = 0;
        for (const Chain& line : lines) {
            lines_there += std::ranges::any_of(
                line.points, [&](const EdgePoint& p) { return p.at == end && p.is_fixed; });
        }
        EXPECT_GE(lines_there, 2);
        EXPECT_NEAR(end.y, 149.5, 0.6);
    }
}

TEST(RegionLines, OneColourHasNoLines) {
    const LabPicture lab = to_lab(cv::Mat(60, 80, CV_8UC3, cv::Scalar(10, 200, 90)));
    EXPECT_TRUE(region_lines(lab, 0.0, 5.0).empty());
    EXPECT_TRUE(stroke_lines(lab, 0.0, 5.0).empty());
}

TEST(RegionLines, OddSizesAreTakenAsTheyAre) {
    for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 40), cv::Size(40, 1), cv::Size(2, 2)}) {
        cv::Mat3b picture(size, cv::Vec3b(255, 255, 255));
        picture(0, 0) = {0, 0, 0};
        const LabPicture lab = to_lab(picture);
        EXPECT_LE(region_lines(lab, 0.0, 5.0).size(), 1U);
        EXPECT_LE(stroke_lines(lab, 0.0, 5.0).size(), 1U);
    }
}

}  // namespace
}  // namespace touchline
