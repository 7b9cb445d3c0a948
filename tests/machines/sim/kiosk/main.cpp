// kiosk_sim: runs simulated sites, seed after seed.
#include "tests/machines/sim/kiosk/sim_report.h"
#include "tests/machines/sim/kiosk/simulation.h"

#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <opencv2/core.hpp>

namespace touchline {
namespace {

struct Wanted {
    PlanOptions plan;
    std::uint64_t seeds = 1;
    bool shrinks = false;
    bool tells_plan = false;
    std::string hashes;   // file
    std::string figures;  // file
};

void tell(const Plan& plan, const SimFailure& failure) {
    fmt::print("{}", text_of(plan));
    fmt::print("FAILED at {:.3f} s: {}: {}\n", failure.at_s, failure.checker, failure.words);
    fmt::print("again: kiosk_sim --seed {} --span {:.0f}{}\n", plan.options.seed,
               plan.options.span_s, plan.options.is_plain ? " --plain" : "");
    std::fflush(stdout);
}

int run(const Wanted& wanted) {
    SimFigures all;
    std::ofstream hashes(wanted.hashes);
    for (std::uint64_t i = 0; i < wanted.seeds; ++i) {
        PlanOptions options = wanted.plan;
        options.seed += i;
        const Plan plan = make_plan(options);
        if (wanted.tells_plan) fmt::print("{}", text_of(plan));
        const SimFigures figures = simulate(plan);
        for (const std::uint64_t hash : figures.hashes)
            hashes << fmt::format("{} {:016x}\n", options.seed, hash);
        all.add(figures);
        if (!figures.failure) continue;
        tell(plan, *figures.failure);
        if (wanted.shrinks) fmt::print("smallest:\n{}", text_of(shrunk(plan)));
    }
    fmt::print("{}", lines_of(all));
    if (!wanted.figures.empty()) std::ofstream(wanted.figures) << stored(all);
    return all.failed_seeds == 0 ? 0 : 1;
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    cv::setNumThreads(1);
    touchline::Wanted wanted;
    CLI::App app("Simulates whole houses around a kiosk, each from its seed.");
    app.add_option("--seed", wanted.plan.seed, "the first seed");
    app.add_option("--seeds", wanted.seeds, "so many, one after the other");
    app.add_option("--span", wanted.plan.span_s, "of each house, in seconds");
    app.add_option("--until", wanted.plan.until_s, "no fault begins later, in seconds");
    app.add_option("--faults", wanted.plan.faults, "kinds that may come, a bit each");
    app.add_flag("--plain", wanted.plan.is_plain, "no drawing, printer or braille display");
    app.add_flag("--shrink", wanted.shrinks, "of a failure: the fewest faults that still fail");
    app.add_flag("--plan", wanted.tells_plan, "tell what is planned");
    app.add_option("--hashes", wanted.hashes, "a file for the hash of each second");
    app.add_option("--figures", wanted.figures, "a file for the figures, to be gathered");
    CLI11_PARSE(app, argc, argv);
    return touchline::run(wanted);
}
