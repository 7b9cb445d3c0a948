// The benchmark's command line; tests/lab/bench/collision/run calls it.
#include "tests/lab/bench/collision/report.h"

#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
    using namespace touchline::bench;
    CLI::App app{"Measures Touchline's servo step beside other structures; writes CSV files."};
    BenchOptions options;
    const auto part = [&](const std::string& name, const std::string& what,
                          void (*measure)(const BenchOptions&)) {
        app.add_subcommand(name, what)->callback([&options, measure] { measure(options); });
    };
    app.add_option("-o,--folder", options.folder, "where the CSV files go")
        ->check(CLI::ExistingDirectory);
    app.add_option("--steps", options.steps, "of the hand, 1 ms each")
        ->check(CLI::Range(10000, 100000));
    app.add_option("--largest", options.largest, "curve (edges)")
        ->check(CLI::IsMember({512, 4096, 65536, 1048576}));
    app.add_option("--first-pass", options.limits.first_pass_s,
                   "seconds after which the first pass of a row stops early")
        ->check(CLI::PositiveNumber);
    part("collision", "all rows on the two curves", run_collision);
    part("scenes", "1 to 10 000 outlines", run_scenes);
    part("growth", "building against size", run_growth);
    part("deadline", "budgets of time and boxes", run_deadline);
    part("accuracy", "levels and budgets against force and place", run_speed_accuracy);
    part("front", "queries from the top, from the grid and of a kept front", run_front);
    app.require_subcommand(1);
    CLI11_PARSE(app, argc, argv);
    return 0;
}
