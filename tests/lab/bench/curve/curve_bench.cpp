// Measures the curves and writes what tests/lab/bench/curve/run draws: curve_bench RESULTS WORK.
#include "tests/lab/bench/curve/report.h"

#include <filesystem>
#include <span>

#include <fmt/core.h>

int main(int argc, char** argv) {
    using namespace touchline::bench;
    const std::span<char*> arguments(argv, static_cast<std::size_t>(argc));
    if (arguments.size() != 3) {
        fmt::print(stderr, "usage: curve_bench RESULTS WORK\n");
        return 2;
    }
    const Folders folders{arguments[1], arguments[2]};
    std::filesystem::create_directories(folders.results);
    std::filesystem::create_directories(folders.work);
    for (const auto section : {measure_points, measure_errors, measure_noise, measure_times,
                               plot_levels, plot_sections, paint_boxes}) {
        if (const auto result = section(folders); !result) {
            fmt::print(stderr, "curve_bench: {}\n", result.error().line);
            return 1;
        }
    }
    return 0;
}
