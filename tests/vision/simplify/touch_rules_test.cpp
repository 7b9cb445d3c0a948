// The rules for touch over many pictures, at every detail and on two areas, judged by
// touch_rules.h.
#include "tests/vision/simplify/touch_rules.h"

#include "tests/vision/pictures/canvas.h"
#include "vision/simplify/trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

// Pictures whose outlines are known: glyphs of a font, pictograms, overlapping shapes, strokes. All
// coordinates are in pixels of the picture, from the upper left corner of the upper left pixel.

struct TruthPicture {
    std::string name;
    cv::Mat pixels;                               // 8-bit BGR
    std::vector<std::vector<cv::Point2d>> rings;  // closed outlines, if known
};

/// The number of pictures: glyphs, pictograms, scenes and strokes in turn.
constexpr int truth_pictures = 320;

constexpr int samples_per_px = 4;  // samples per pixel, each way

using Ring = std::vector<cv::Point2d>;

/// Fills rings by the even-odd rule, area-averaged, over a picture.
void fill(cv::Mat3b& picture, const std::vector<Ring>& rings, cv::Scalar ink) {
    cv::Mat1b fine(samples_per_px * picture.rows, samples_per_px * picture.cols, uchar{0});
    std::vector<std::vector<cv::Point>> corners;
    constexpr int fixed_point_bits = 8;
    for (const Ring& ring : rings) {
        corners.emplace_back();
        for (const cv::Point2d& p : ring) {
            const cv::Point2d at =
                (p * samples_per_px - cv::Point2d(0.5, 0.5)) * (1 << fixed_point_bits);
            corners.back().emplace_back(static_cast<int>(std::lround(at.x)),
                                        static_cast<int>(std::lround(at.y)));
        }
    }
    cv::fillPoly(fine, corners, cv::Scalar(255), cv::LINE_8, fixed_point_bits);
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

/// Returns the n-th picture, the same on every call; 0 <= n < truth_pictures.
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

/// Returns a ring of the truth in W.
std::vector<Position> in_w(const std::vector<cv::Point2d>& ring, const Trace& trace,
                           cv::Size picture) {
    std::vector<Position> points;
    for (const cv::Point2d& p : ring) {
        points.push_back({1000.0 * (p.x - picture.width / 2.0) / trace.report.pixels_per_metre,
                          1000.0 * (picture.height / 2.0 - p.y) / trace.report.pixels_per_metre});
    }
    return points;
}

double around_mm(const std::vector<Position>& ring) {
    double sum = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        sum += norm(ring[(i + 1) % ring.size()] - ring[i]);
    return sum;
}

double least_apart_mm(const std::vector<Position>& a, const std::vector<Position>& b) {
    double least = 1e9;
    for (const Position& p : a) {
        for (const Position& q : b) least = std::min(least, norm(p - q));
    }
    return least;
}

/// Counts the rings of the truth that a map of these rules must show one by one: long enough, and
/// clear of all others.
int clear_rings(const std::vector<std::vector<Position>>& rings, const TouchRules& rules) {
    int count = 0;
    for (const auto& ring : rings) {
        const bool is_clear = std::ranges::all_of(rings, [&](const auto& other) {
            return &other == &ring || least_apart_mm(ring, other) > 1.3 * rules.gap_mm;
        });
        count += is_clear && around_mm(ring) > 1.4 * rules.stroke_mm &&
                         around_mm(ring) > 6.0 * rules.gap_mm
                     ? 1
                     : 0;
    }
    return count;
}

/// Returns the rings that lie in no other.
std::vector<std::vector<Position>> outer_of(const std::vector<std::vector<Position>>& rings) {
    std::vector<std::vector<Position>> outer;
    for (const auto& ring : rings) {
        const Position p = ring.front();
        const bool is_inside = std::ranges::any_of(rings, [&](const auto& other) {
            int crossings = 0;
            for (std::size_t i = 0; i < other.size() && &other != &ring; ++i) {
                const Position a = other[i];
                const Position b = other[(i + 1) % other.size()];
                if ((a.y > p.y) != (b.y > p.y) &&
                    p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
                    ++crossings;
                }
            }
            return crossings % 2 == 1;
        });
        if (!is_inside) outer.push_back(ring);
    }
    return outer;
}

void judge(const TruthPicture& picture, const Trace& trace, int detail, const Area& area) {
    TouchRules rules = touch_rules(detail, area);
    double longest_mm = 0.0;
    for (const Outline& outline : trace.map.outlines) {
        longest_mm = std::max(longest_mm, length_of(outline));
    }
    if (longest_mm < rules.stroke_mm) rules.stroke_mm = 0.5 * longest_mm;  // nothing is long enough
    for (const std::string& fault : faults_of(trace.map, rules)) ADD_FAILURE() << fault;
    std::vector<std::vector<Position>> rings;
    for (const auto& ring : picture.rings) {
        rings.push_back(in_w(ring, trace, picture.pixels.size()));
    }
    if (rings.empty()) return;
    const auto outer = outer_of(rings);
    const auto& longest = *std::ranges::max_element(outer, {}, around_mm);
    if (around_mm(longest) > rules.stroke_mm && around_mm(longest) < rules.line_mm) {
        // The rest are ends of parts too short to be strokes of their own.
        EXPECT_GT(covered_share(longest, trace.map, rules.gap_mm + 1.0), 0.75);
    }
    const int expected = clear_rings(detail <= 2 ? outer : rings, rules);
    EXPECT_GE(trace.map.outlines.size(), static_cast<std::size_t>(std::min(expected, 2)));
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int every_so = 7;  // ten times as slow
#else
constexpr int every_so = 1;
#endif
constexpr int kinds = 4;  // letters, pictograms, scenes, strokes: truth_picture() in turn

/// Judges every `stride`-th picture of a kind, or all of them if TOUCHLINE_EXHAUSTIVE is set.
void judge_all(const Area& area, int kind, int stride) {
    // NOLINTNEXTLINE(concurrency-mt-unsafe)
    if (std::getenv("TOUCHLINE_EXHAUSTIVE") != nullptr) stride = 1;
    for (int n = kind; n < truth_pictures; n += kinds * stride) {
        const TruthPicture picture = truth_picture(n);
        const auto found = find_lines(picture.pixels, {.area = area});
        ASSERT_TRUE(found) << picture.name << ": " << found.error().line;
        for (int detail = 1; detail <= 5; ++detail) {
            SCOPED_TRACE(picture.name + ", number " + std::to_string(n) + ", detail " +
                         std::to_string(detail));
            const auto trace = trace_lines(*found, {.area = area, .detail = detail});
            ASSERT_TRUE(trace) << trace.error().line;
            judge(picture, *trace, detail, area);
        }
    }
}

class TouchRulesOfKind : public ::testing::TestWithParam<int> {};

TEST_P(TouchRulesOfKind, HoldOnTheSmallArea) {
    judge_all({}, GetParam(), every_so);
}

TEST_P(TouchRulesOfKind, HoldOnALargeArea) {
    judge_all({0.180, 0.120}, GetParam(), every_so);
}

INSTANTIATE_TEST_SUITE_P(TouchRules, TouchRulesOfKind, ::testing::Range(0, kinds));

}  // namespace
}  // namespace touchline::testing
