// Drives the shipped loop over its full factorial, and it and others through the torture geometry.
// Writes loops.csv and scenarios.csv, and settings.csv: what the loop may render at which rate.
#include "haptics/servo/loop_settings.h"
#include "tests/lab/stability/factorial.h"
#include "tests/lab/stability/scenario_loops.h"
#include "tests/lab/stability/slices.h"

#include <cmath>
#include <fstream>

#include <fmt/core.h>

namespace touchline::stability {
namespace {

template <class Case>
bool measure_into(const std::string& path, std::string_view columns, const std::vector<Case>& cases,
                  std::uint64_t& hash) {
    const auto results = measure_all(cases);
    std::ofstream csv(path);
    csv << "# The same on every machine: tests/lab/stability/run\n" << columns << '\n';
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::string line = csv_line(cases[i], results[i]);
        csv << line << '\n';
        hash = hashed(line, hash);
    }
    if (csv.flush()) return true;
    fmt::print(stderr, "stability_loops: cannot write {}\n", path);
    return false;
}

/// Assumes a period of delay, as the loop does.
bool write_settings(const std::string& path) {
    std::ofstream csv(path);
    csv << "# The same on every machine: tests/lab/stability/run\n"
           "profile,rate_Hz,stiffness_N_per_m,largest_N_per_m,damping_Ns_per_m,encoder_mm\n";
    for (const DeviceProfile& profile : device_profiles()) {
        for (double rate_Hz = 125.0; rate_Hz < 33000.0; rate_Hz *= std::exp2(0.25)) {
            const LoopSettings settings = loop_settings(profile, 1.0 / rate_Hz, 1.0 / rate_Hz);
            csv << fmt::format("{},{:.6g},{:.5g},{:.5g},{:g},{:.4g}\n", profile.name, rate_Hz,
                               settings.stiffness_N_per_m, settings.largest_stiffness_N_per_m,
                               settings.damping_Ns_per_m, 1e3 * encoder_step_m(profile));
        }
    }
    return static_cast<bool>(csv.flush());
}

}  // namespace
}  // namespace touchline::stability

int main(int argc, char** argv) {
    using namespace touchline::stability;
    if (argc != 3) {
        fmt::print(stderr, "usage: stability_loops RESULTS WORK\n");
        return 2;
    }
    const std::string results = argv[1];
    const std::string work = argv[2];  // for what is too long to keep
    const auto loops = factorial({0.0, 1.0, 2.0});
    std::vector<ScenarioCase> scenarios;
    for (std::size_t method = 0; method < loop_methods().size(); ++method) {
        for (const double asked : {1.0, 2.0}) {
            const auto cases = scenario_cases(method, asked);
            scenarios.insert(scenarios.end(), cases.begin(), cases.end());
        }
    }
    fmt::print(
        "loops     {:5} runs: the shipped loop by device, period, delay, hand, fault, wall\n",
        loops.size());
    fmt::print("scenarios {:5} runs: torture geometry by the shipped loop and five others\n",
               scenarios.size());
    std::uint64_t hash = hashed("");
    const bool is_done = write_settings(results + "/settings.csv") &&
                         measure_into(work + "/loops.csv", factorial_columns, loops, hash) &&
                         measure_into(work + "/scenarios.csv", scenario_columns, scenarios, hash);
    std::ofstream(results + "/loops_hash.txt") << fmt::format("{:016x}\n", hash);
    return is_done ? 0 : 1;
}
