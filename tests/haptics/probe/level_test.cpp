// A change of level under a shape: no line passes through an edge on its way, and the level gets
// there.

#include "tests/exact/orientation.h"
#include "tests/haptics/probe/hands.h"
#include "tests/haptics/probe/swept_judge.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Follows lines that run straight from one level to the next of the same octave, in small steps,
/// against edges that stand still.
bool does_cut(const CurveSet& curves, double from, double to, const ProbeShape& shape,
              const ProbePose& pose) {
    constexpr int parts = 8;
    const int finer = static_cast<int>(std::floor(std::min(from, to)));
    const ProbePlacement placed(pose);
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        for (int k = 0; k < parts; ++k) {
            const double w0 = from - finer + (to - from) * k / parts;
            const double w1 = from - finer + (to - from) * (k + 1) / parts;
            const RenderedPiece before = curves.blend(piece, finer, std::clamp(w0, 0.0, 1.0));
            const RenderedPiece after = curves.blend(piece, finer, std::clamp(w1, 0.0, 1.0));
            for (int j = 0; j < before.segment_count(); ++j) {
                const Segment a = before.segment(j);
                const Segment b = after.segment(j);
                if (norm(a.a - pose.place()) > shape.r_max_m() + 0.005) continue;
                for (const Segment& edge : shape.edges()) {
                    const Segment at = placed(edge);
                    if (exact::meet(at.a, at.b, a.a, b.a) || exact::meet(at.a, at.b, b.a, b.b)) {
                        return true;
                    }
                }
            }
        }
    }
    return false;
}

TEST(ProbeLevel, ChangesWithoutALinePassingThroughAndArrives) {
    std::size_t changes = 0;
    std::size_t changes_in_contact = 0;
    std::size_t ticks_behind = 0;
    std::size_t ticks = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const Scene scene =
            build_scene(scenes::rough_ring(static_cast<unsigned>(seed), 3e-4), {}, 0.0).value();
        const double coarsest = scene.curves.coarsest();
        ASSERT_GE(coarsest, 2.0);
        const ProbeShape shape = any_shape(seed % 6);
        RestlessHand hand(seed);
        ProbeProxy proxy;
        proxy.reset(shape, scene, hand.step(), 0.0);
        std::vector<ProbePose> path;
        proxy.record_path(&path);
        ProbeReport last;
        const std::size_t steps = trials::count(1500, 20000);
        for (std::size_t k = 0; k < steps; ++k) {
            const double wanted = std::min(coarsest, static_cast<double>((k / 100) % 4));
            const double before = proxy.rendered_level();
            const ProbePose start = proxy.pose();
            const ProbeReport report = proxy.step(hand.step(), wanted, {}, {});
            ++ticks;
            if (report.level != wanted) ++ticks_behind;
            const SweptJudge judge(scene.curves, report.level, shape.edges());
            if (report.is_placed) {
                ASSERT_TRUE(judge.is_clear(proxy.pose())) << seed << " " << k;
            }
            if (last.is_placed && report.level != before) {
                ++changes;
                changes_in_contact += last.contact_count > 0 ? 1 : 0;
                ASSERT_LE(std::abs(report.level - before), 0.5);
                const bool stayed = judge.is_free(path) &&
                                    !does_cut(scene.curves, before, report.level, shape, start);
                if (!stayed) {
                    // It made room: the first stretch of the path is at the old level.
                    const SweptJudge old(scene.curves, before, shape.edges());
                    ASSERT_GE(path.size(), 2U);
                    ASSERT_TRUE(old.is_free(std::span(path).first(2))) << seed << " " << k;
                    ASSERT_FALSE(does_cut(scene.curves, before, report.level, shape, path[1]))
                        << seed << " " << k;
                    ASSERT_TRUE(judge.is_free(std::span(path).subspan(1))) << seed << " " << k;
                }
            } else if (last.is_placed) {
                ASSERT_TRUE(judge.is_free(path)) << seed << " " << k;
            }
            last = report;
        }
    }
    EXPECT_GT(changes, 100U);
    EXPECT_GT(changes_in_contact, 30U);
    EXPECT_LT(ticks_behind, ticks / 3);
    RecordProperty("ticks_behind", std::to_string(ticks_behind));
}

}  // namespace
}  // namespace touchline
