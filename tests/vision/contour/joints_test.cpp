// Sharp corners, crossings and joints of strokes, drawn at random, come out as drawn.
// TOUCHLINE_EXHAUSTIVE=1 draws 20 000 (tests/README.md).
#include "tests/vision/pictures/effects.h"
#include "tests/vision/pictures/pen_figures.h"
#include "tests/vision/pictures/pictograms.h"
#include "vision/contour/strokes.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

using testing::PenFigure;
using testing::Polyline;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int everyday = 45;  // ten times as slow
#else
constexpr int everyday = 450;
#endif
constexpr int exhaustive = 20'000;
const cv::Size picture_size(560, 420);
constexpr double least_right = 0.995;
constexpr double near_joint_px = 10.0;

std::vector<Polyline> found_in(const PenFigure& figure, int seed) {
    testing::Canvas canvas(picture_size, {250, 250, 250});
    canvas.stroke(figure.lines, figure.pen, {20, 20, 20});
    const cv::Mat picture =
        testing::seen(canvas.picture(), testing::effects_of_kind(seed % 3, seed));
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

struct Outcome {
    bool hangs_together = false;
    double off_px = 0.0;
};

Outcome outcome_of(int seed) {
    const PenFigure figure = testing::pen_figure(seed, picture_size);
    const std::vector<Polyline> found = found_in(figure, seed);
    const auto drawn = testing::topology_of(figure.lines);
    const auto felt = testing::topology_of(found);
    const double off_px = std::max(testing::farthest_px(figure.lines, found),
                                   testing::farthest_px(found, figure.lines));
    if (!(drawn == felt) || off_px > near_joint_px)
        fmt::print("{}, seed {}, pen {:.1f} px: drawn {}; found {}; {:.1f} px off\n", figure.name,
                   seed, figure.pen.width_px, words_of(drawn), words_of(felt), off_px);
    return {drawn == felt, off_px};
}

/// A pixel is a tenth of a millimetre at the hand.
TEST(Joints, FiguresHangTogetherAsDrawn) {
    const int count = std::getenv("TOUCHLINE_EXHAUSTIVE") != nullptr ? exhaustive : everyday;
    int together = 0;
    int near = 0;
    for (int seed = 0; seed < count; ++seed) {
        const Outcome outcome = outcome_of(seed);
        together += outcome.hangs_together ? 1 : 0;
        near += outcome.off_px <= near_joint_px ? 1 : 0;
    }
    fmt::print("{} figures: {} hang together as drawn, {} lie within a millimetre\n", count,
               together, near);
    EXPECT_GE(together, least_right * count);
    EXPECT_GE(near, least_right * count);
}

}  // namespace
}  // namespace touchline
