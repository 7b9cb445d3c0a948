// The servo step and its queries beside other structures, with the same curves, hand, judge and
// flags.
#include "tests/lab/bench/collision/brute_force.h"
#include "tests/lab/bench/collision/crossing.h"
#include "tests/lab/bench/collision/grid.h"
#include "tests/lab/bench/collision/peers.h"
#include "tests/lab/bench/collision/queries.h"
#include "tests/lab/bench/collision/report.h"
#include "tests/lab/bench/collision/touchline_rows.h"

#include <algorithm>
#include <array>
#include <limits>

namespace touchline::bench {
namespace {

constexpr std::string_view columns =
    "row,group,curve,edges,steps,stopped,median_ns,p99_ns,max_ns,raw_p99_ns,build_ms,"
    "bytes_per_edge,entered,let_through,slip_offs,contact_share,mean_gap_mm,max_gap_mm,"
    "max_jump_N_per_ms,spacing_mm,force_error_rms_N,force_error_max_N,coarser_steps";

/// Writes all rows for one curve.
class CurveRows {
  public:
    CurveRows(workload::Kind kind, std::size_t edges, const BenchOptions& options, CsvFile& csv)
        : kind_(kind),
          edges_(edges),
          limits_(options.limits),
          csv_(csv),
          points_(workload::curve(kind, edges)),
          positions_(workload::hand(kind, options.steps)),
          is_inside_(points_) {
        judged_hand_.positions = positions_;
        free_hand_.positions = positions_;
        for (const Position p : positions_) judged_hand_.is_inside.push_back(is_inside_(p));
    }

    void write() {
        write_touchline();
        write_grid();
        write_peer<RTree>("R-tree (Boost.Geometry)");
        write_peer<AabbTree>("AABB tree (CGAL)");
        write_brute_force();
        write_box2d();
    }

  private:
    void write_touchline() {
        const TactileMap map = workload::map_of(points_);
        const auto [scene, cost] =
            measured_build(edges_, [&] { return build_scene(map, {}, 0.0).value(); });
        FixedLevel exact(*scene, {});
        const HandRun exact_run = run(exact, judged_hand_, limits_);
        write_own("Touchline level 0", *scene, cost, exact_run, exact_run,
                  judged(exact, scene->curves, judged_hand_, exact_run));
        AutoLevel automatic(*scene);
        const HandRun auto_run = run(automatic, judged_hand_, limits_);
        write_own("Touchline level auto", *scene, cost, auto_run, exact_run,
                  judged(automatic, scene->curves, judged_hand_, auto_run));
        const FinestLevel tree(*scene);
        write_crossing("Touchline", tree, cost);
        write_nearest("Touchline", tree, cost);
    }

    void write_own(std::string_view name, const Scene& scene, const BuildCost& cost,
                   const HandRun& own, const HandRun& exact, Verdict verdict) {
        const Deviation error = deviation(own, exact);
        auto& levels = verdict.levels;
        const auto middle = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() / 2);
        std::nth_element(levels.begin(), middle, levels.end());
        // A proxy on a coarser curve may be inside the finest one, so its ways are judged instead.
        write_line(name, "step", own, cost,
                   fmt::format(",{},{},{:.6f},{:.6f},{:.6f},{}", verdict.let_through,
                               felt(behaviour(own, judged_hand_, is_inside_)),
                               mean_spacing_m(scene.curves, *middle) * 1e3,
                               error.rms_m * stiffness_N_per_m, error.max_m * stiffness_N_per_m,
                               verdict.coarser));
    }

    template <class Structure>
    void write_peer(std::string_view name) {
        const ClosedCurve curve = points_;
        const auto [tree, cost] = measured_build(edges_, [&] { return Structure(curve); });
        write_proxy(name, *tree, cost);
        write_crossing(name, *tree, cost);
        write_nearest(name, *tree, cost);
    }

    void write_grid() {
        const double edges_per_cell = best_edges_per_cell();
        const auto [grid, cost] =
            measured_build(edges_, [&] { return Grid(points_, edges_per_cell); });
        write_proxy("uniform grid", *grid, cost);
        write_crossing("uniform grid", *grid, cost);
    }

    /// Returns the fastest of four cell sizes in a short trial before the run, by median times 99th
    /// percentile.
    [[nodiscard]] double best_edges_per_cell() const {
        constexpr std::size_t trial_steps = 20000;
        Hand trial = judged_hand_;
        trial.positions = trial.positions.first(std::min(trial_steps, positions_.size()));
        double best = 1.0;
        double least = std::numeric_limits<double>::infinity();
        for (const double edges_per_cell : {1.0, 2.0, 4.0, 8.0}) {
            const Grid grid(points_, edges_per_cell);
            PlaneProxy proxy(grid, points_);
            const StepTimes times = step_times(run(proxy, trial, limits_).least_ticks);
            if (times.median_ns * times.p99_ns < least) best = edges_per_cell;
            least = std::min(least, times.median_ns * times.p99_ns);
        }
        return best;
    }

    void write_brute_force() {
        const BruteForce brute(points_);
        write_proxy("brute force", brute, {});
        write_crossing("brute force", brute, {});
    }

    void write_box2d() {
        const ClosedCurve curve = points_;
        auto [scene, cost] = measured_build(edges_, [&] { return Box2dScene(curve); });
        write_crossing("Box2D 2.4 ray cast", *scene, cost);
        if (can_box2d_follow(edges_)) {
            const HandRun pushed = run(*scene, judged_hand_, limits_);
            write_judged("Box2D 2.4 whole step (0.5 mm disc)", pushed, cost);
        }
    }

    template <class Structure>
    void write_proxy(std::string_view name, const Structure& structure, const BuildCost& cost) {
        PlaneProxy proxy(structure, points_);
        write_judged(fmt::format("plain proxy over {}", name), run(proxy, judged_hand_, limits_),
                     cost);
    }

    template <class Structure>
    void write_crossing(std::string_view name, const Structure& structure, const BuildCost& cost) {
        CrossingQuery query(structure);
        write_line(name, "crossing", run(query, free_hand_, limits_), cost, ",,,,,,,,,,");
    }

    template <class Structure>
    void write_nearest(std::string_view name, const Structure& structure, const BuildCost& cost) {
        NearestQuery query(structure);
        write_line(name, "nearest", run(query, free_hand_, limits_), cost, ",,,,,,,,,,");
    }

    void write_judged(std::string_view name, const HandRun& done, const BuildCost& cost) {
        const Behaviour found = behaviour(done, judged_hand_, is_inside_);
        write_line(name, "step", done, cost, fmt::format("{},,{},,,,", found.entered, felt(found)));
    }

    [[nodiscard]] static std::string felt(const Behaviour& found) {
        return fmt::format("{},{:.4f},{:.3f},{:.3f},{:.3f}", found.slip_offs, found.contact_share,
                           found.mean_gap_m * 1e3, found.largest_gap_m * 1e3, found.largest_jump_N);
    }

    void write_line(std::string_view name, std::string_view group, const HandRun& done,
                    const BuildCost& cost, std::string_view rest) {
        csv_.line(fmt::format("{},{},{},{},{},{},{},{:.2f},{:.1f},{}", name, group, name_of(kind_),
                              edges_, done.proxies.size(), done.is_stopped ? "yes" : "no",
                              times_of(done), cost.ms, cost.bytes_per_edge, rest));
    }

    workload::Kind kind_;
    std::size_t edges_;
    RunLimits limits_;
    CsvFile& csv_;
    std::vector<Position> points_;
    std::vector<Position> positions_;
    Inside is_inside_;
    Hand judged_hand_, free_hand_;
};

}  // namespace

void run_collision(const BenchOptions& options) {
    CsvFile csv(options.folder, "collision.csv", columns);
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        for (const std::size_t edges : {512U, 4096U, 65536U, 1048576U}) {
            if (edges <= options.largest) CurveRows(kind, edges, options, csv).write();
        }
    }
}

}  // namespace touchline::bench
