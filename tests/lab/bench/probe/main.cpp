// A shape in the hand: what a step costs against the edges of the shape and of the scene, and what
// coarser levels cost in place. tests/lab/bench/probe/run calls it.
#include "tests/lab/bench/collision/report.h"
#include "tests/lab/bench/collision/touchline_rows.h"
#include "tests/lab/bench/probe/turning_hand.h"

#include <algorithm>
#include <cmath>

#include <CLI/CLI.hpp>

namespace touchline::bench {
namespace {

constexpr double shape_radius_m = 5e-3;
constexpr int measured_edges = 64;  // of the shape that the bars show
constexpr std::size_t measured_scene = 65536;

Scene scene_of(workload::Kind kind, std::size_t edges) {
    return build_scene(workload::map_of(workload::curve(kind, edges)), {}, 0.0).value();
}

std::string times_of_shape(const TurningRun& run) {
    const StepTimes times = step_times(run.least_ticks);
    return fmt::format("{},{:.0f},{:.0f},{:.0f},{},{}", run.least_ticks.size(), times.median_ns,
                       times.p99_ns, times.max_ns, run.slip_offs, run.boxes_max);
}

/// Times the same hand without a shape and without its angle.
template <class Renderer>
std::string times_of_point(Renderer renderer, workload::Kind kind, const BenchOptions& options) {
    const std::vector<Position> places = workload::hand(kind, options.steps);
    const HandRun run = bench::run(renderer, {places, {}}, options.limits);
    const StepTimes times = step_times(run.least_ticks);
    return fmt::format("{},{:.0f},{:.0f},{:.0f},0,0", run.least_ticks.size(), times.median_ns,
                       times.p99_ns, times.max_ns);
}

void run_steps(const BenchOptions& options) {
    CsvFile csv(
        options.folder, "probe_steps.csv",
        "curve,shape_edges,scene_edges,level,steps,median_ns,p99_ns,max_ns,slip_offs,most_boxes");
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        const std::vector<ProbePose> hand = turning_hand(kind, options.steps);
        for (const std::size_t scene_edges : {512U, 4096U, 65536U, 1048576U}) {
            if (scene_edges > options.largest) continue;
            const Scene scene = scene_of(kind, scene_edges);
            const auto line = [&](int shape_edges, const char* level, const std::string& times) {
                csv.line(fmt::format("{},{},{},{},{}", name_of(kind), shape_edges, scene_edges,
                                     level, times));
            };
            line(0, "auto", times_of_point(AutoLevel(scene), kind, options));
            line(0, "0", times_of_point(FixedLevel(scene, {}), kind, options));
            for (const int edges : {4, 16, measured_edges, 256}) {
                const ProbeShape shape = regular_shape(shape_radius_m, edges);
                const auto timed = [&](std::optional<double> level) {
                    return times_of_shape(
                        run_shape(scene, shape, hand, level, options.limits.passes));
                };
                line(edges, "auto", timed(std::nullopt));
                line(edges, "0", timed(0.0));
            }
        }
    }
}

/// Returns the metres between the shape's places in two runs, ascending, until one slips off: after
/// that they are on different sides of the curve for good.
std::vector<double> apart_m(const TurningRun& run, const TurningRun& reference) {
    std::vector<double> found;
    const std::size_t end = std::min({run.first_slip, reference.first_slip, run.proxies.size()});
    for (std::size_t i = 0; i < end; ++i) {
        found.push_back(norm(run.proxies[i].place() - reference.proxies[i].place()));
    }
    std::sort(found.begin(), found.end());
    return found;
}

void run_accuracy(const BenchOptions& options) {
    CsvFile csv(
        options.folder, "probe_accuracy.csv",
        "curve,level,spacing_mm,median_ns,p99_ns,place_median_mm,place_rms_mm,compared,slip_offs");
    const ProbeShape shape = regular_shape(shape_radius_m, measured_edges);
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        const std::vector<ProbePose> hand = turning_hand(kind, options.steps);
        const Scene scene = scene_of(kind, std::min(measured_scene, options.largest));
        const TurningRun reference = run_shape(scene, shape, hand, 0.0, 1);
        const auto line = [&](const std::string& name, double spacing_m,
                              std::optional<double> level) {
            const TurningRun run = run_shape(scene, shape, hand, level, options.limits.passes);
            const StepTimes times = step_times(run.least_ticks);
            const std::vector<double> apart = apart_m(run, reference);
            double squares = 0.0;
            for (const double m : apart) squares += m * m;
            csv.line(fmt::format("{},{},{:.4f},{:.0f},{:.0f},{:.4f},{:.4f},{},{}", name_of(kind),
                                 name, spacing_m * 1e3, times.median_ns, times.p99_ns,
                                 apart[apart.size() / 2] * 1e3,
                                 std::sqrt(squares / static_cast<double>(apart.size())) * 1e3,
                                 apart.size(), run.slip_offs));
        };
        for (int level = 0; level <= scene.curves.coarsest(); ++level) {
            line(std::to_string(level), mean_spacing_m(scene.curves, level), level);
        }
        line("auto", 0.0, std::nullopt);
    }
}

}  // namespace
}  // namespace touchline::bench

int main(int argc, char** argv) {
    using namespace touchline::bench;
    CLI::App app{"Measures a step with a shape in the hand; writes CSV files."};
    BenchOptions options;
    options.steps = 20000;
    app.add_option("-o,--folder", options.folder, "where the CSV files go")
        ->check(CLI::ExistingDirectory);
    app.add_option("--steps", options.steps, "of the hand, 1 ms each")
        ->check(CLI::Range(1000, 100000));
    app.add_option("--largest", options.largest, "curve (edges)")
        ->check(CLI::IsMember({512, 4096, 65536, 1048576}));
    app.add_subcommand("steps", "edges of the shape and of the scene")->callback([&] {
        run_steps(options);
    });
    app.add_subcommand("accuracy", "levels against place")->callback([&] {
        run_accuracy(options);
    });
    app.require_subcommand(1);
    CLI11_PARSE(app, argc, argv);
    return 0;
}
