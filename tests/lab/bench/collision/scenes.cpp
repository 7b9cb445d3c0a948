// The servo step against the number of outlines, with the same edges in the same places.
#include "tests/lab/bench/collision/report.h"
#include "tests/lab/bench/collision/tiled_spiral.h"
#include "tests/lab/bench/collision/touchline_rows.h"

namespace touchline::bench {
namespace {

constexpr std::size_t edges = 131072;
constexpr std::size_t most_steps = 20000;

template <class Renderer>
void write_row(std::string_view name, std::size_t outlines, const Scene& scene,
               const BuildCost& cost, Renderer renderer, const BenchOptions& options,
               CsvFile& csv) {
    const auto positions = hand_on_spiral(std::min(most_steps, options.steps));
    const Hand hand{positions, std::vector<bool>(positions.size(), false)};
    const HandRun done = run(renderer, hand, options.limits);
    const Verdict verdict = judged(renderer, scene.curves, hand, done);
    std::size_t contacts = 0;
    for (std::size_t i = 0; i < done.proxies.size(); ++i) {
        contacts += norm(done.proxies[i] - positions[i]) > 1e-6 ? 1U : 0U;
    }
    csv.line(fmt::format("{},{},{},{},{},{:.1f},{:.1f},{},{:.3f}", name, outlines, edges,
                         done.proxies.size(), times_of(done), cost.ms, cost.bytes_per_edge,
                         verdict.let_through,
                         static_cast<double>(contacts) / static_cast<double>(done.proxies.size())));
}

}  // namespace

void run_scenes(const BenchOptions& options) {
    CsvFile csv(options.folder, "scenes.csv",
                "row,outlines,edges,steps,median_ns,p99_ns,max_ns,raw_p99_ns,build_ms,"
                "bytes_per_edge,let_through,contact_share");
    for (const std::size_t outlines : {1U, 10U, 100U, 1000U, 10000U}) {
        const TactileMap map = tiled_spiral(edges, outlines);
        const auto [scene, cost] =
            measured_build(edges, [&] { return build_scene(map, {}, 0.0).value(); });
        write_row("Touchline level auto", outlines, *scene, cost, AutoLevel(*scene), options, csv);
        write_row("Touchline level 0", outlines, *scene, cost, FixedLevel(*scene, {}), options,
                  csv);
    }
}

}  // namespace touchline::bench
