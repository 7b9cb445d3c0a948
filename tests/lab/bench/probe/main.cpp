// A shape in the hand: what a step costs against the edges of the shape and of the scene, and what
// coarser levels cost in place. tests/lab/bench/probe/run calls it.
#include "haptics/pantograph/profile.h"
#include "haptics/probe/probe_proxy.h"
#include "haptics/resolution/level_rule.h"
#include "tests/lab/bench/collision/report.h"
#include "tests/lab/bench/collision/run.h"
#include "tests/lab/bench/collision/touchline_rows.h"
#include "tests/lab/bench/workload.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include <CLI/CLI.hpp>

namespace touchline::bench {
namespace {

struct TurningRun {
    std::vector<std::uint64_t> least_ticks;  // of each step with the hand at the shape, least of
                                             // all passes
    std::vector<ProbePose> proxies;          // of each step
    std::size_t slip_offs = 0;
    std::size_t first_slip = SIZE_MAX;  // step
    std::size_t boxes_max = 0;
};

constexpr double step_s = 1e-3;

constexpr double clear_of_curve_m = 0.08;  // from the middle: both curves end before 60 mm

/// Returns a pose clear of the curve, in the direction of the hand.
ProbePose taken_up(const ProbePose& hand) {
    const double share = clear_of_curve_m / std::hypot(hand.x_m, hand.y_m);
    return {hand.x_m * share, hand.y_m * share, hand.angle_rad};
}

/// Returns the hand of the peer workload, turning to and fro by up to a quarter of a turn, at most
/// 3.2 rad/s.
std::vector<ProbePose> turning_hand(workload::Kind kind, std::size_t steps) {
    std::vector<ProbePose> poses;
    poses.reserve(steps);
    for (const Position at : workload::hand(kind, steps)) {
        const double t_s = step_s * static_cast<double>(poses.size());
        const double angle_rad = 1.1 * std::sin(1.7 * t_s) + 0.4 * std::sin(3.1 * t_s);
        poses.push_back({at.x, at.y, angle_rad});
    }
    return poses;
}

/// Returns a regular polygon round the hand.
ProbeShape regular_shape(double radius_m, int edges) {
    const auto corner = [&](int i) {
        const double angle_rad = 2.0 * std::numbers::pi * (i % edges) / edges;
        return Position{radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad)};
    };
    std::vector<Segment> outline;
    for (int i = 0; i < edges; ++i) outline.push_back({corner(i), corner(i + 1)});
    return ProbeShape::build(std::move(outline), 0.0).value();
}

/// Runs the shape over the hand, at a level or, without one, at the level that its speed sets. A
/// hand more than slip_m from its shape has slipped off: the shape starts again from outside the
/// curve, untimed until it is at the hand.
TurningRun run_shape(const Scene& scene, const ProbeShape& shape,
                     const std::vector<ProbePose>& hand, std::optional<double> level, int passes) {
    std::vector<std::uint64_t> least(hand.size(), UINT64_MAX);
    TurningRun run;
    ProbeProxy proxy;
    for (int pass = 0; pass < passes; ++pass) {
        ShapeLevelRule rule(limits_of(scene.curves), shape.r_max_m());
        proxy.reset(shape, scene, taken_up(hand.front()), level.value_or(0.0));
        bool is_at_hand = false;
        for (std::size_t i = 0; i < hand.size(); ++i) {
            const ProbePose& at = hand[i];
            const std::uint64_t begin = ticks();
            const double wanted =
                level ? *level : rule.step({at.x_m, at.y_m}, at.angle_rad, step_s);
            const ProbeReport report = proxy.step(at, wanted, {}, {});
            const std::uint64_t cost = ticks() - begin;
            const bool is_near = norm(report.pose.place() - at.place()) <= slip_m;
            const bool is_slip = is_at_hand && !is_near;
            if (is_at_hand) least[i] = std::min(least[i], cost);
            if (is_slip) proxy.reset(shape, scene, taken_up(at), wanted);
            is_at_hand = is_near;
            if (pass > 0) continue;
            run.proxies.push_back(report.pose);
            run.slip_offs += is_slip ? 1U : 0U;
            if (is_slip) run.first_slip = std::min(run.first_slip, i);
            run.boxes_max = std::max(run.boxes_max, static_cast<std::size_t>(report.boxes));
        }
    }
    std::erase(least, UINT64_MAX);
    run.least_ticks = std::move(least);
    return run;
}

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
