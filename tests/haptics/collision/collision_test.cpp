#include "haptics/collision/scene.h"
#include "tests/haptics/collision/trials.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr std::array tried_levels{0.0, 0.1, 0.5, 1.0, 1.9, 2.0, 3.0, 4.6, 9.0};

Scene scene_of(unsigned seed, int outlines) {
    return trials::every_level(scenes::random_map(seed, outlines));
}

std::vector<SegmentRef> all_segments(const CurveSet& curves, double level) {
    std::vector<SegmentRef> all;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        for (int j = 0; j < curves.rendered_count(piece, level); ++j) all.push_back({piece, j});
    }
    return all;
}

Segment segment_at(const CurveSet& curves, SegmentRef ref, double level) {
    return curves.rendered_segment(ref.piece, level, ref.index);
}

class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}

    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(engine_); }

    Position place() { return {0.1 * (unit() - 0.5), 0.1 * (unit() - 0.5)}; }

    /// Returns anything from a long way across the scene to a step of micrometres.
    Motion motion(double level, double radius_m) {
        const Position from = place();
        const double reach = std::pow(10.0, -6.0 * unit());
        return {from, from + reach * (place() - from), radius_m, level, {}};
    }

  private:
    std::mt19937 engine_;
};

/// Returns the first touch over all segments, by the leaf test alone.
Hit brute_force(const CurveSet& curves, const Motion& motion) {
    Hit first;
    for (const SegmentRef ref : all_segments(curves, motion.level)) {
        const auto found =
            touch(motion.from, motion.to, motion.radius_m, segment_at(curves, ref, motion.level));
        if (!found || (first.is_hit && first.clear <= found->fraction)) continue;
        first.is_hit = true;
        first.clear = found->fraction;
        first.segment = ref;
    }
    return first;
}

TEST(CollisionTree, FirstHitEqualsBruteForceAtEveryLevelBlendAndRadius) {
    int hits = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        const Scene scene = scene_of(seed, 5);
        Random random(seed);
        for (int i = 0; i < 400; ++i) {
            const double level = tried_levels[static_cast<std::size_t>(i) % tried_levels.size()];
            const double radius = i % 3 == 0 ? 1e-3 * random.unit() : contact_skin_m;
            const Motion motion = random.motion(level, radius);
            const Hit expected = brute_force(scene.curves, motion);
            const Hit found = scene.tree.first_hit(scene.curves, motion, {});
            ASSERT_EQ(found.is_hit, expected.is_hit) << seed << " " << i;
            if (!found.is_hit) continue;
            ++hits;
            const double way = norm(motion.to - motion.from);
            ASSERT_LE(std::abs(found.clear - expected.clear) * way, approach_tolerance_m);
            // The lowest of the segments touched at the same moment wins.
            ASSERT_LE(found.segment, expected.segment);
            ASSERT_LE((found.touch.fraction - expected.clear) * way, approach_tolerance_m);
        }
    }
    EXPECT_GT(hits, 2000);
}

TEST(CollisionTree, MotionsAimedAtVerticesNeverSlipBetweenTwoSegments) {
    const Scene scene = trials::every_level(scenes::map_of({scenes::circle(0.03, 97)}));
    for (const double level : tried_levels) {
        for (int j = 0; j < scene.curves.rendered_count(0, level); ++j) {
            const Position vertex = scene.curves.rendered_point(0, level, j);
            const Motion through{{0.0001, 0.0002},
                                 2.0 * vertex - Position{0.0001, 0.0002},
                                 contact_skin_m,
                                 level,
                                 {}};
            ASSERT_TRUE(scene.tree.first_hit(scene.curves, through, {}).is_hit);
        }
    }
}

TEST(CollisionTree, AMotionThatOnlyMovesAwayOrAlongATouchedLineIsClear) {
    const auto map = scenes::map_of({scenes::outline({{-0.01, 0}, {0, 0}, {0.01, 0}}, false)});
    const Scene scene = trials::every_level(map);
    const Position on{0.001, contact_skin_m};
    for (const Position to : {Position{0.005, contact_skin_m}, Position{0.001, 0.02},
                              Position{-0.009, contact_skin_m}, on}) {
        EXPECT_FALSE(
            scene.tree.first_hit(scene.curves, {on, to, contact_skin_m, 0.0, {}}, {}).is_hit);
    }
    const Hit through =
        scene.tree.first_hit(scene.curves, {on, {0.001, -0.01}, contact_skin_m, 0.0, {}}, {});
    EXPECT_TRUE(through.is_hit);
    EXPECT_EQ(through.clear, 0.0);
    EXPECT_NEAR(through.touch.normal.y, 1.0, 1e-15);
}

/// The paper's definition: nodes that do not hold the handle although their parent does, cut off at
/// `level`.
void paper_section(const Scene& scene, Position handle, int level, int piece, int at, int j,
                   std::vector<ErrorBox>& out) {
    const ErrorBox box = scene.tree.box(scene.curves, piece, at, j);
    bool holds = true;
    for (std::size_t k = 0; k < 4; ++k) {
        const Position side = box.corners[(k + 1) % 4] - box.corners[k];
        holds = holds && cross(side, handle - box.corners[k]) >= 0.0;
    }
    if (!holds || at <= level) {
        out.push_back(box);
        return;
    }
    for (int child = 2 * j; child < std::min(2 * j + 2, scene.curves.segment_count(piece, at - 1));
         ++child) {
        paper_section(scene, handle, level, piece, at - 1, child, out);
    }
}

TEST(CollisionTree, BoundarySectionIsThePapers) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Scene scene = scene_of(seed, 3);
        Random random(seed);
        for (const int level : {0, 1, 2}) {
            const Position handle = random.place();
            std::vector<ErrorBox> expected;
            for (int piece = 0; piece < static_cast<int>(scene.curves.pieces().size()); ++piece) {
                const int coarsest =
                    scene.curves.pieces()[static_cast<std::size_t>(piece)].coarsest;
                for (int j = 0; j < scene.curves.segment_count(piece, coarsest); ++j) {
                    paper_section(scene, handle, level, piece, coarsest, j, expected);
                }
            }
            std::vector<ErrorBox> section;
            scene.tree.boundary_section(scene.curves, handle, level, section);
            const auto order = [](const ErrorBox& a, const ErrorBox& b) {
                return std::tie(a.piece, a.level, a.index) < std::tie(b.piece, b.level, b.index);
            };
            std::sort(section.begin(), section.end(), order);
            std::sort(expected.begin(), expected.end(), order);
            ASSERT_EQ(section.size(), expected.size());
            for (std::size_t i = 0; i < section.size(); ++i) {
                ASSERT_FALSE(order(section[i], expected[i]) || order(expected[i], section[i]));
            }
        }
    }
}

TEST(CollisionTree, AThousandOutlinesHangUnderOneHierarchy) {
    std::vector<Outline> many;
    for (int i = 0; i < 1000; ++i) {
        const Position at{0.003 * (i % 32) - 0.048, 0.003 * (i / 32) - 0.048};
        many.push_back(
            scenes::outline({at, at + Position{0.001, 0.0}, at + Position{0.001, 0.001}}, true));
    }
    const Scene scene = trials::every_level(scenes::map_of(std::move(many)));
    const Hit hit = scene.tree.first_hit(
        scene.curves, {{-0.0475, -0.0485}, {-0.0475, 0.05}, contact_skin_m, 0.0, {}}, {});
    EXPECT_TRUE(hit.is_hit);
    EXPECT_EQ(scene.curves.pieces()[static_cast<std::size_t>(hit.segment.piece)].outline, 0);
    EXPECT_LT(hit.boxes, 60);
}

}  // namespace
}  // namespace touchline
