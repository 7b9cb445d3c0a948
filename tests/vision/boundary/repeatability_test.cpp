// Other light, noise, blur or JPEG must not change which lines a picture has.
#include "tests/vision/boundary/boundary_score.h"
#include "tests/vision/boundary/degraded.h"
#include "tests/vision/boundary/glyphs.h"
#include "vision/contour/photo_lines.h"

#include <map>
#include <string>

#include <gtest/gtest.h>

namespace touchline::testing {
namespace {

TEST(Repeatability, TheSameLinesUnderOtherLightNoiseBlurAndJpeg) {
    constexpr int kScenes = 8;
    const cv::Size size(320, 240);
    std::map<std::string, BoundaryCounts> counts;
    for (int i = 0; i < kScenes; ++i) {
        const TruthScene scene = pictogram_scene(3 * i, size);
        const cv::Mat1b before = photo_lines(scene.picture, 116.0).edge_strength;
        const std::vector<cv::Mat1b> truth{
            thinned(cv::Mat1b(cv::Mat(before >= BoundarySweep::kAutomatic)))};
        ASSERT_GT(cv::countNonZero(truth[0]), 300) << i;
        for (const Degraded& version : degraded(scene.picture)) {
            const cv::Mat1b after = photo_lines(version.picture, 116.0).edge_strength;
            counts[version.name] += boundary_counts(after, BoundarySweep::kAutomatic, truth);
        }
    }
    for (const auto& [name, count] : counts) {
        EXPECT_GE(count.f(), 0.80) << name;
    }
}

}  // namespace
}  // namespace touchline::testing
