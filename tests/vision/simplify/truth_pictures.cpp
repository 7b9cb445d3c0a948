#include "tests/vision/simplify/truth_pictures.h"

#include "tests/vision/pictures/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

constexpr int kFiner = 4;  // samples per pixel, each way

using Ring = std::vector<cv::Point2d>;

/// Fills rings by the even-odd rule, area-averaged, over a picture.
void fill(cv::Mat3b& picture, const std::vector<Ring>& rings, cv::Scalar ink) {
    cv::Mat1b fine(kFiner * picture.rows, kFiner * picture.cols, uchar{0});
    std::vector<std::vector<cv::Point>> corners;
    constexpr int kShift = 8;
    for (const Ring& ring : rings) {
        corners.emplace_back();
        for (const cv::Point2d& p : ring) {
            const cv::Point2d at = (p * kFiner - cv::Point2d(0.5, 0.5)) * (1 << kShift);
            corners.back().emplace_back(static_cast<int>(std::lround(at.x)),
                                        static_cast<int>(std::lround(at.y)));
        }
    }
    cv::fillPoly(fine, corners, cv::Scalar(255), cv::LINE_8, kShift);
    cv::Mat1b covered;
    cv::resize(fine, covered, picture.size(), 0.0, 0.0, cv::INTER_AREA);
    for (int y = 0; y < picture.rows; ++y) {
        for (int x = 0; x < picture.cols; ++x) {
            for (int c = 0; c < 3; ++c) {
                const double part = covered(y, x) / 255.0;
                picture(y, x)[c] =
                    cv::saturate_cast<uchar>((1.0 - part) * picture(y, x)[c] + part * ink[c]);
            }
        }
    }
}

void spoil(cv::Mat3b& picture, cv::RNG& random) {
    const double blur_px = random.uniform(0.0, 1.2);
    if (blur_px > 0.3) cv::GaussianBlur(picture, picture, {}, blur_px);
    cv::Mat3s noise(picture.size());
    random.fill(noise, cv::RNG::NORMAL, 0.0, random.uniform(0.0, 5.0));
    cv::add(picture, noise, picture, cv::noArray(), CV_8U);
}

std::vector<Ring> glyph_rings(const std::string& font, const std::string& letter, double size) {
    const Font bold{.family = font, .size_px = size, .is_bold = true};
    std::vector<Ring> rings;
    for (const Polyline& ring : Canvas({8, 8}, {}).outline_of(letter, {}, bold)) {
        rings.push_back(ring.points);
    }
    return rings;
}

/// Moves rings to the middle of a picture, where they fill at most `share` of it.
void place(std::vector<Ring>& rings, cv::Size size, double share) {
    cv::Point2d low(1e9, 1e9);
    cv::Point2d high(-1e9, -1e9);
    for (const Ring& ring : rings) {
        for (const cv::Point2d& p : ring) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    }
    const double scale =
        share * std::min(size.width / (high.x - low.x), size.height / (high.y - low.y));
    for (Ring& ring : rings) {
        for (cv::Point2d& p : ring) {
            p = (p - 0.5 * (low + high)) * scale + 0.5 * cv::Point2d(size.width, size.height);
        }
    }
}

Ring star(cv::Point2d centre, double radius, int points, double depth, double turn) {
    Ring ring;
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = turn + std::numbers::pi * i / points;
        const double r = i % 2 == 0 ? radius : depth * radius;
        ring.emplace_back(centre.x + r * std::cos(angle), centre.y + r * std::sin(angle));
    }
    return ring;
}

/// A smooth closed shape with some waves.
Ring blob(cv::Point2d centre, double radius, cv::RNG& random) {
    const int waves = random.uniform(2, 7);
    const double depth = random.uniform(0.0, 0.35);
    const double turn = random.uniform(0.0, 6.0);
    const double stretch = random.uniform(0.5, 1.0);
    Ring ring;
    for (int i = 0; i < 240; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 240;
        const double r = radius * (1.0 + depth * std::sin(waves * angle + turn)) / (1.0 + depth);
        ring.emplace_back(centre.x + r * std::cos(angle), centre.y + stretch * r * std::sin(angle));
    }
    return ring;
}

Ring any_shape(cv::Point2d centre, double radius, cv::RNG& random) {
    return random.uniform(0, 2) == 0 ? blob(centre, radius, random)
                                     : star(centre, radius, random.uniform(2, 9),
                                            random.uniform(0.35, 1.0), random.uniform(0.0, 6.0));
}

TruthPicture glyph(int n, cv::RNG& random) {
    const std::array<std::string, 3> fonts{"DejaVu Sans", "DejaVu Serif", "DejaVu Sans Mono"};
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabdefghijkmnpqrtuy0123456789&?%@";
    const std::string letter(1, letters[static_cast<std::size_t>(n * 7) % letters.size()]);
    const std::string& font = fonts[static_cast<std::size_t>(n) % fonts.size()];
    TruthPicture picture{fmt::format("{} {}", font, letter), {}, glyph_rings(font, letter, 200.0)};
    const cv::Size size(n % 2 == 0 ? 320 : 480, n % 2 == 0 ? 240 : 300);
    place(picture.rings, size, random.uniform(0.6, 0.92));
    cv::Mat3b pixels(size, cv::Vec3b::all(245));
    fill(pixels, picture.rings, cv::Scalar(20, 10, 30));
    spoil(pixels, random);
    picture.pixels = pixels;
    return picture;
}

/// Two or three shapes side by side, some with a hole and something in it.
TruthPicture pictogram(int n, cv::RNG& random) {
    const cv::Size size(440, 320);
    TruthPicture picture{fmt::format("pictogram {}", n), {}, {}};
    const int count = random.uniform(1, 4);
    for (int i = 0; i < count; ++i) {
        const double radius = random.uniform(0.5, 0.95) * std::min(160.0, 220.0 / count);
        const cv::Point2d centre(440.0 * (i + 0.5) / count, random.uniform(140.0, 180.0));
        picture.rings.push_back(any_shape(centre, radius, random));
        for (const double inner : {0.3, 0.12}) {
            if (random.uniform(0, 3) > 0) {
                picture.rings.push_back(blob(centre, inner * radius, random));
            }
        }
    }
    cv::Mat3b pixels(size, cv::Vec3b(230, 240, 250));
    fill(pixels, picture.rings, cv::Scalar(random.uniform(0, 120), random.uniform(0, 120), 60));
    spoil(pixels, random);
    picture.pixels = pixels;
    return picture;
}

/// Shapes over each other: outlines that meet and cross.
TruthPicture scene(int n, cv::RNG& random) {
    cv::Mat3b pixels(300, 420, cv::Vec3b::all(static_cast<uchar>(random.uniform(100, 200))));
    const int count = random.uniform(3, 9);
    for (int i = 0; i < count; ++i) {
        const cv::Point2d centre(random.uniform(0.0, 420.0), random.uniform(0.0, 300.0));
        fill(pixels, {any_shape(centre, random.uniform(25.0, 130.0), random)},
             cv::Scalar(random.uniform(0, 256), random.uniform(0, 256), random.uniform(0, 256)));
    }
    spoil(pixels, random);
    return {fmt::format("scene {}", n), pixels, {}};
}

/// Thin strokes that cross.
TruthPicture strokes(int n, cv::RNG& random) {
    cv::Mat3b pixels(300, 400, cv::Vec3b::all(240));
    const int count = random.uniform(2, 8);
    for (int i = 0; i < count; ++i) {
        std::vector<cv::Point> points;
        const int corners = random.uniform(2, 6);
        for (int k = 0; k < corners; ++k) {
            points.emplace_back(random.uniform(10, 390), random.uniform(10, 290));
        }
        cv::polylines(pixels, points, random.uniform(0, 3) == 0, cv::Scalar::all(30),
                      random.uniform(2, 9), cv::LINE_AA);
    }
    spoil(pixels, random);
    return {fmt::format("strokes {}", n), pixels, {}};
}

}  // namespace

TruthPicture truth_picture(int n) {
    cv::RNG random(static_cast<std::uint64_t>(7919 * n + 1));
    switch (n % 4) {
        case 0:
            return glyph(n / 4, random);
        case 1:
            return pictogram(n, random);
        case 2:
            return scene(n, random);
        default:
            return strokes(n, random);
    }
}

}  // namespace touchline::testing
