// Sharp corners, crossings and joints of strokes, drawn at random: as drawn they come out.
// TOUCHLINE_EXHAUSTIVE=1 draws 20 000 (tests/README.md).
#include "tests/vision/pictures/effects.h"
#include "tests/vision/pictures/pen_figures.h"
#include "tests/vision/pictures/pictograms.h"
#include "vision/contour/strokes.h"

#include <cstdlib>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using testing::PenFigure;
using testing::Polyline;

constexpr int kEveryday = 450;
constexpr int kExhaustive = 20'000;
const cv::Size kPicture(560, 420);
constexpr double kLeastRight = 0.995;

std::vector<Polyline> found_in(const PenFigure& figure, int seed) {
    testing::Canvas canvas(kPicture, {250, 250, 250});
    canvas.stroke(figure.lines, figure.pen, {20, 20, 20});
    const cv::Mat picture = testing::seen(canvas.picture(), testing::effects_of_kind(seed % 3, seed));
    const LabPicture lab = to_lab(picture);
    std::vector<Polyline> lines;
    for (const Chain& chain : stroke_lines(lab, noise_of(lab), 30.0)) {
        Polyline line{{}, chain.is_closed};
        for (const EdgePoint& point : chain.points)
            line.points.push_back(point.at + cv::Point2d(0.5, 0.5));
        lines.push_back(std::move(line));
    }
    return lines;
}

TEST(Joints, FiguresHangTogetherAsDrawn) {
    const int count = std::getenv("TOUCHLINE_EXHAUSTIVE") != nullptr ? kExhaustive : kEveryday;
    int wrong = 0;
    double worst = 0.0;
    for (int seed = 0; seed < count; ++seed) {
        const PenFigure figure = testing::pen_figure(seed, kPicture);
        const std::vector<Polyline> found = found_in(figure, seed);
        const auto drawn = testing::topology_of(figure.lines);
        const auto felt = testing::topology_of(found);
        const double off_px = std::max(testing::farthest_px(figure.lines, found),
                                       testing::farthest_px(found, figure.lines));
        const double limit_px = 0.5 * figure.pen.width_px + 2.0;
        worst = std::max(worst, off_px / limit_px);
        if (drawn == felt && off_px <= limit_px) continue;
        ++wrong;
        std::printf("%s, seed %d, pen %.1f px, join %d, cap %d: drawn %s; found %s; %.1f px off\n",
                    figure.name.c_str(), seed, figure.pen.width_px, static_cast<int>(figure.pen.join),
                    static_cast<int>(figure.pen.cap), words_of(drawn).c_str(),
                    words_of(felt).c_str(), off_px);
    }
    std::printf("%d of %d as drawn\n", count - wrong, count);
    EXPECT_LE(wrong, (1.0 - kLeastRight) * count);
}

}  // namespace
}  // namespace touchline
