#include "tests/vision/pictures/effects.h"
#include "tests/vision/pictures/pictograms.h"
#include "vision/contour/strokes.h"

#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using testing::Canvas;
using testing::Pictogram;
using testing::Polyline;

constexpr double pictogram_units = 24.0;
const cv::Scalar ink(60, 30, 20);

/// How a pictogram lies on a picture: its size, its strokes' width, its turn, its look.
struct Setting {
    double size_px = 120.0;
    double width_units = 1.5;
    double angle_deg = 0.0;
    int effects = 0;
};

std::vector<Setting> settings() {
    return {{120.0, 1.5, 0.0, 0},  {200.0, 1.2, 15.0, 1}, {260.0, 1.5, 33.0, 2},
            {160.0, 1.4, 90.0, 3}, {320.0, 1.0, 7.0, 4},  {220.0, 1.6, 200.0, 5}};
}

double margin_px(const Setting& setting) {
    return 0.35 * setting.size_px;
}

std::vector<Polyline> placed(const Pictogram& pictogram, const Setting& setting) {
    const double scale = setting.size_px / pictogram_units;
    const double middle_px = 0.5 * setting.size_px + margin_px(setting);
    const cv::Point2d middle(middle_px, middle_px);
    const cv::Point2d corner =
        testing::placed({{{-12.0, -12.0}}, false}, middle, scale, setting.angle_deg).points.front();
    std::vector<Polyline> lines;
    for (const Polyline& line : pictogram.lines) {
        lines.push_back(testing::placed(line, corner, scale, setting.angle_deg));
    }
    return lines;
}

std::vector<Chain> traced(const cv::Mat& picture, double greatest_width_px) {
    const LabPicture lab = to_lab(picture);
    return stroke_lines(lab, noise_of(lab), greatest_width_px);
}

/// Converts to Cairo's pixels, whose origin is the corner of the first pixel.
std::vector<Polyline> polylines(const std::vector<Chain>& chains) {
    std::vector<Polyline> lines;
    for (const Chain& chain : chains) {
        Polyline line{{}, chain.is_closed};
        for (const EdgePoint& point : chain.points) {
            line.points.push_back(point.at + cv::Point2d(0.5, 0.5));
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

std::string name_of(const Pictogram& pictogram, const Setting& setting) {
    return pictogram.name + " " + std::to_string(setting.size_px) + " px, effects " +
           std::to_string(setting.effects);
}

double stroke_px(const Setting& setting) {
    return setting.width_units * setting.size_px / pictogram_units;
}

Canvas empty_sheet(const Setting& setting) {
    const int side = static_cast<int>(setting.size_px + 2.0 * margin_px(setting));
    return {{side, side}, {245, 250, 250}};
}

std::vector<Chain> lines_of(const Canvas& sheet, const Setting& setting) {
    return traced(testing::seen(sheet.picture(), testing::effects_of_kind(setting.effects, 3)),
                  2.0 * stroke_px(setting));
}

TEST(StrokeLines, MiddleLinesOfPictogramsWithinHalfAStroke) {
    for (const Setting& setting : settings()) {
        const double width_px = stroke_px(setting);
        for (const Pictogram& pictogram : testing::pictograms()) {
            SCOPED_TRACE(name_of(pictogram, setting));
            const std::vector<Polyline> truth = placed(pictogram, setting);
            Canvas sheet = empty_sheet(setting);
            sheet.stroke(truth, width_px, ink);
            const std::vector<Chain> chains = lines_of(sheet, setting);
            const std::vector<Polyline> lines = polylines(chains);
            EXPECT_LE(testing::farthest_px(truth, lines), 0.5 * width_px);
            EXPECT_LE(testing::farthest_px(lines, truth), 0.5 * width_px);
            for (const Chain& chain : chains) {
                EXPECT_NEAR(chain.width_px, width_px, 0.2 * width_px + 0.7);
            }
        }
    }
}

TEST(StrokeLines, TheBorderOfAHardEdgedShapeHasAStrength) {
    // Its borders lie half-way between two pixels and are all rounded to the paper's.
    cv::Mat3b picture(44, 44, cv::Vec3b::all(250));
    picture(cv::Rect(11, 11, 19, 19)) = cv::Vec3b::all(20);
    const std::vector<Chain> chains = traced(picture, 5.0);
    ASSERT_EQ(chains.size(), 1U);
    for (const EdgePoint& p : chains.front().points) {
        EXPECT_GT(p.strength, 10.0);
    }
}

TEST(StrokeLines, FilledPictogramsGiveTheirOutline) {
    for (const Setting& setting : settings()) {
        const double width_px = stroke_px(setting);
        for (const Pictogram& pictogram : testing::pictograms()) {
            if (!pictogram.lines.front().is_closed) {
                continue;
            }
            SCOPED_TRACE(name_of(pictogram, setting));
            const std::vector<Polyline> truth{placed(pictogram, setting).front()};
            Canvas sheet = empty_sheet(setting);
            sheet.fill(truth, ink);
            const std::vector<Chain> chains = lines_of(sheet, setting);
            ASSERT_EQ(chains.size(), 1U);
            EXPECT_TRUE(chains.front().is_closed);
            EXPECT_EQ(chains.front().width_px, 0.0);
            EXPECT_LE(testing::farthest_px(truth, polylines(chains)), 0.5 * width_px);
            EXPECT_LE(testing::farthest_px(polylines(chains), truth), 0.5 * width_px);
        }
    }
}

}  // namespace
}  // namespace touchline
