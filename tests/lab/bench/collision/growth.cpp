// Time and memory of building a scene, against its size.
#include "haptics/collision/scene.h"
#include "tests/lab/bench/collision/report.h"

#include <algorithm>

namespace touchline::bench {
namespace {

constexpr int repeats = 3;

struct Growth {
    BuildCost curves, tree, scene;
};

void keep_least(BuildCost& least, const BuildCost& cost) {
    least.ms = least.bytes_per_edge == 0.0 ? cost.ms : std::min(least.ms, cost.ms);
    least.bytes_per_edge = cost.bytes_per_edge;
}

Growth growth_of(const TactileMap& map, std::size_t edges) {
    Growth least;
    for (int i = 0; i < repeats; ++i) {
        const auto [curves, curve_cost] =
            measured_build(edges, [&] { return CurveSet::build(map, {}).value(); });
        const auto [tree, tree_cost] = measured_build(
            edges, [&curves = *curves] { return CollisionTree::build(curves, 0.0); });
        keep_least(least.curves, curve_cost);
        keep_least(least.tree, tree_cost);
    }
    for (int i = 0; i < repeats; ++i) {
        const auto [scene, cost] =
            measured_build(edges, [&] { return build_scene(map, {}, 0.0).value(); });
        keep_least(least.scene, cost);
    }
    return least;
}

}  // namespace

void run_growth(const BenchOptions& options) {
    CsvFile csv(options.folder, "growth.csv",
                "curve,edges,curves_ms,tree_ms,scene_ms,curves_bytes_per_edge,"
                "tree_bytes_per_edge,scene_bytes_per_edge,scene_s_per_million_edges");
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        for (std::size_t edges = 512; edges <= options.largest; edges *= 2) {
            const Growth found = growth_of(workload::map_of(workload::curve(kind, edges)), edges);
            csv.line(fmt::format("{},{},{:.3f},{:.3f},{:.3f},{:.1f},{:.1f},{:.1f},{:.3f}",
                                 name_of(kind), edges, found.curves.ms, found.tree.ms,
                                 found.scene.ms, found.curves.bytes_per_edge,
                                 found.tree.bytes_per_edge, found.scene.bytes_per_edge,
                                 found.scene.ms * 1e3 / static_cast<double>(edges)));
        }
    }
}

}  // namespace touchline::bench
