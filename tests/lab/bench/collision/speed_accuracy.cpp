// What a coarser level or a smaller budget of boxes or of walks costs in force and place, and what
// it saves: the shipped servo step against itself at level 0 without a budget.
#include "tests/lab/bench/collision/brute_force.h"
#include "tests/lab/bench/collision/report.h"
#include "tests/lab/bench/collision/touchline_rows.h"

#include <algorithm>

namespace touchline::bench {
namespace {

constexpr int no_limit = 1 << 24;  // walks: more than any curve has edges

class Trade {
  public:
    Trade(workload::Kind kind, std::size_t edges, const BenchOptions& options, CsvFile& csv)
        : kind_(kind),
          edges_(edges),
          limits_(options.limits),
          csv_(csv),
          points_(workload::curve(kind, edges)),
          positions_(workload::hand(kind, options.steps)),
          scene_(build_scene(workload::map_of(points_), {}, 0.0).value()) {
        const Inside is_inside(points_);
        hand_.positions = positions_;
        for (const Position p : positions_) hand_.is_inside.push_back(is_inside(p));
    }

    void write_levels_and_boxes() {
        FixedLevel exact(scene_, {});
        const HandRun reference = run(exact, hand_, limits_);
        for (int level = 0; level <= scene_.curves.coarsest(); ++level) {
            FixedLevel renderer(scene_, {static_cast<double>(level)});
            write_line("level", level, mean_spacing_m(scene_.curves, level),
                       run(renderer, hand_, limits_), reference);
        }
        const double finest_m = mean_spacing_m(scene_.curves, 0.0);
        for (int boxes = 1; boxes <= 512; boxes *= 2) {
            FixedLevel renderer(scene_, {0.0, boxes});
            write_line("budget", boxes, finest_m, run(renderer, hand_, limits_), reference);
        }
    }

    void write_walks() {
        FixedLevel exact(scene_, {.walks = no_limit});
        const HandRun reference = run(exact, hand_, limits_);
        const double finest_m = mean_spacing_m(scene_.curves, 0.0);
        for (int walks = 16; walks <= 4096; walks *= 2) {
            FixedLevel renderer(scene_, {.walks = walks});
            write_line("walks", walks, finest_m, run(renderer, hand_, limits_), reference);
        }
        write_line("walks", no_limit, finest_m, reference, reference);
    }

  private:
    void write_line(std::string_view series, int value, double spacing_m, const HandRun& done,
                    const HandRun& reference) {
        const Deviation error = deviation(done, reference);
        csv_.line(fmt::format("{},{},{},{},{:.6f},{},{},{:.6f},{:.6f},{:.6f},{:.6f},{}", series,
                              value, name_of(kind_), edges_, spacing_m * 1e3, done.proxies.size(),
                              times_of(done), error.rms_m * stiffness_N_per_m,
                              error.max_m * stiffness_N_per_m, error.rms_m * 1e3, error.max_m * 1e3,
                              std::count(done.is_reset.begin(), done.is_reset.end(), true)));
    }

    workload::Kind kind_;
    std::size_t edges_;
    RunLimits limits_;
    CsvFile& csv_;
    std::vector<Position> points_;
    std::vector<Position> positions_;
    Scene scene_;
    Hand hand_;
};

}  // namespace

void run_speed_accuracy(const BenchOptions& options) {
    CsvFile csv(options.folder, "speed_accuracy.csv",
                "series,value,curve,edges,spacing_mm,steps,median_ns,p99_ns,max_ns,raw_p99_ns,"
                "force_error_rms_N,force_error_max_N,place_error_rms_mm,place_error_max_mm,"
                "slip_offs");
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        Trade trade(kind, 65536, options, csv);
        trade.write_levels_and_boxes();
        trade.write_walks();
    }
    if (options.largest < 1048576) return;
    Trade(workload::Kind::radial, 1048576, options, csv).write_walks();
}

}  // namespace touchline::bench
