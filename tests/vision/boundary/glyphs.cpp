#include "tests/vision/boundary/glyphs.h"

#include "tests/vision/pictures/effects.h"
#include "tests/vision/pictures/scenes.h"

#include <algorithm>
#include <limits>

#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

constexpr double reflected = 0.4;  // of another scene, as in a window: edges, not boundaries
constexpr double glyph_noise_levels = 4.0;

}  // namespace

std::vector<Polyline> glyph(const std::string& character, const Font& font, cv::Point2d centre,
                            double height_px) {
    constexpr double large_px = 2000.0;  // Cairo flattens to 0.1 px of this
    Font large = font;
    large.size_px = large_px;
    std::vector<Polyline> rings = Canvas({8, 8}, {255, 255, 255}).outline_of(character, {}, large);
    constexpr double far = std::numeric_limits<double>::infinity();
    cv::Point2d least(far, far);
    cv::Point2d greatest(-far, -far);
    for (const Polyline& ring : rings) {
        for (const cv::Point2d& p : ring.points) {
            least = {std::min(least.x, p.x), std::min(least.y, p.y)};
            greatest = {std::max(greatest.x, p.x), std::max(greatest.y, p.y)};
        }
    }
    const cv::Point2d middle = 0.5 * (least + greatest);
    const double scale = height_px / std::max(greatest.x - least.x, greatest.y - least.y);
    for (Polyline& ring : rings) {
        for (cv::Point2d& p : ring.points) {
            p = centre + scale * (p - middle);
        }
        // A closed path comes back to its first point; a ring does not repeat it.
        if (cv::norm(ring.points.front() - ring.points.back()) < 1e-6) {
            ring.points.pop_back();
        }
    }
    return rings;
}

const std::vector<std::string>& letters() {
    static const std::vector<std::string> all{"A", "B", "C", "E", "G", "K", "M", "Q",
                                              "R", "S", "X", "a", "e", "g", "2", "&"};
    return all;
}

const std::vector<std::string>& picture_characters() {
    static const std::vector<std::string> all{
        "\u2602", "\u260E", "\u2708", "\u265E", "\u2693", "\u2605", "\u2665", "\u2660",
        "\u265B", "\u265C", "\u2664", "\u2618", "\u2620", "\u262D", "\u2663", "\u266B",
        "\u2702", "\u270D", "\u2709", "\u261E", "\u265F", "\u2744", "\u2766", "\u2698"};
    return all;
}

TruthScene pictogram_scene(int i, cv::Size size) {
    const auto n = static_cast<int>(picture_characters().size());
    Canvas canvas({400, 400}, {0, 0, 0});
    canvas.fill(
        glyph(picture_characters()[static_cast<std::size_t>(i % n)], {}, {200.0, 200.0}, 380.0),
        {255, 255, 255});
    cv::Mat1b silhouette;
    cv::cvtColor(canvas.picture(), silhouette, cv::COLOR_BGR2GRAY);
    const PhotoScene scene = photo_of(silhouette, 100 + i, size);
    cv::Mat picture;
    cv::addWeighted(scene.picture, 1.0 - reflected, photo_scene(900 + i, size).picture, reflected,
                    0.0, picture);
    cv::Mat1b inner;
    cv::erode(scene.truth, inner, cv::getStructuringElement(cv::MORPH_CROSS, {3, 3}));
    return {seen(picture, {.noise_levels = glyph_noise_levels, .seed = i}),
            cv::Mat1b(scene.truth - inner)};
}

}  // namespace touchline::testing
