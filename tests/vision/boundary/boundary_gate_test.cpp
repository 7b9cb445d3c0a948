// Boundaries of pictograms before photo-like backgrounds, counted as the Berkeley benchmark does.
#include "tests/vision/boundary/boundary_score.h"
#include "tests/vision/boundary/glyphs.h"
#include "vision/contour/photo_lines.h"

#include <gtest/gtest.h>

namespace touchline::testing {
namespace {

TEST(BoundaryGate, PictogramsBeforeClutterAreFound) {
    const cv::Size size(320, 240);
    BoundarySweep sweep;
    for (int i = 0; i < static_cast<int>(picture_characters().size()); ++i) {
        const TruthScene scene = pictogram_scene(i, size);
        const auto found = photo_lines(scene.picture, 116.0);
        sweep.add(found.edge_strength, {scene.boundary});
    }
    EXPECT_GE(sweep.automatic().f(), 0.71);  // the mirrored scenes' own edges keep it below 0.75
    EXPECT_GE(sweep.best().f(), 0.73);
}

}  // namespace
}  // namespace touchline::testing
