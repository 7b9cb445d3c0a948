// The rules for touch over many pictures, at every detail and on two areas, judged by
// touch_rules.h.
#include "tests/vision/simplify/touch_rules.h"

#include "tests/vision/simplify/truth_pictures.h"
#include "vision/simplify/trace.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

namespace touchline::testing {
namespace {

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
constexpr int kEverySo = 7;  // ten times as slow
#else
constexpr int kEverySo = 1;
#endif
constexpr int kKinds = 4;  // letters, pictograms, scenes, strokes: truth_picture() in turn

/// Judges every `stride`-th picture of a kind, or all of them if TOUCHLINE_EXHAUSTIVE is set.
void judge_all(const Area& area, int kind, int stride) {
    // NOLINTNEXTLINE(concurrency-mt-unsafe)
    if (std::getenv("TOUCHLINE_EXHAUSTIVE") != nullptr) stride = 1;
    for (int n = kind; n < kTruthPictures; n += kKinds * stride) {
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
    judge_all({}, GetParam(), kEverySo);
}

TEST_P(TouchRulesOfKind, HoldOnALargeArea) {
    judge_all({0.180, 0.120}, GetParam(), kEverySo);
}

INSTANTIATE_TEST_SUITE_P(TouchRules, TouchRulesOfKind, ::testing::Range(0, kKinds));

}  // namespace
}  // namespace touchline::testing
