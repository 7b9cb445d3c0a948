// Traces every picture of a gallery. Writes a table of numbers, and the paths for the chart.
#include "app/documents/decode/map_svg.h"
#include "app/documents/gallery/gallery.h"
#include "app/force/servo/scene_order.h"
#include "tests/lab/bench/tracing/gallery_trial.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <fmt/os.h>

namespace touchline::bench {
namespace {

void write_path(const std::string& file, std::span<const Position> places) {
    auto out = fmt::output_file(file);
    for (const Position p : places) out.print("{:.2f},{:.2f}\n", 1e3 * p.x, 1e3 * p.y);
}

void write_row(fmt::ostream& csv, const Trial& trial, const char* mode, const TrialResult& r) {
    csv.print("{},{},{:.1f},{:.1f},{:.1f},{:.3f},{:.4f},{},{}\n", mode, trial.name,
              1e3 * trial.length_m, trial.limit_s, r.traced.time_s, 1e3 * r.score.p90_m,
              r.score.covered, r.is_traced ? 1 : 0, r.is_named ? 1 : 0);
}

}  // namespace
}  // namespace touchline::bench

int main(int argc, char** argv) {
    using namespace touchline;
    using namespace touchline::bench;
    if (argc < 2) {
        fmt::print(stderr, "usage: tracing_bench FOLDER [PART-OF-A-NAME]\n");
        return 2;
    }
    const std::string folder = argv[1];
    const std::string wanted = argc > 2 ? argv[2] : "";
    const auto gallery = read_trials(gallery_folder());
    if (!gallery) {
        fmt::print(stderr, "{}\n", gallery.error().line);
        return 1;
    }
    auto csv = fmt::output_file(folder + "/tracing.csv");
    csv.print("mode,picture,length_mm,limit_s,time_s,p90_mm,covered,traced,named\n");
    for (std::size_t i = 0; i < gallery->trials.size(); ++i) {
        const Trial& trial = gallery->trials[i];
        if (trial.name.find(wanted) == std::string::npos) continue;
        write_path(folder + "/" + trial.name + ".outline.csv", gallery->on_outlines[i]);
        for (const auto& [mode, name] : tracings) {
            const TrialResult result = attempt(*gallery, i, mode);
            write_row(csv, trial, name, result);
            write_path(fmt::format("{}/{}.{}.csv", folder, trial.name, name), result.traced.path);
            write_path(fmt::format("{}/{}.{}.way.csv", folder, trial.name, name),
                       result.traced.way);
        }
    }
    return 0;
}
