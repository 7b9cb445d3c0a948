// Measures the stability maps, one CSV file a slice; drives the shipped loop over its full
// factorial, and it and others through the torture geometry (loops.csv, scenarios.csv); and writes
// settings.csv: what the loop may render at which rate. Of all lines hash.txt keeps the hashes.
#include "haptics/servo/loop_settings.h"
#include "tests/lab/stability/factorial.h"
#include "tests/lab/stability/maps.h"

#include <cmath>
#include <fstream>

#include <fmt/core.h>

namespace touchline::stability {
namespace {

template <class Case, class Measured>
bool write_all(const std::string& path, std::string_view columns, const std::vector<Case>& cases,
               const std::vector<Measured>& results, std::uint64_t& hash) {
    std::ofstream csv(path);
    csv << "# The same on every machine: tests/lab/stability/run\n" << columns << '\n';
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::string line = csv_line(cases[i], results[i]);
        csv << line << '\n';
        hash = hashed(line, hash);
    }
    if (csv.flush()) return true;
    fmt::print(stderr, "stability_bench: cannot write {}\n", path);
    return false;
}

/// Returns whether all could be written. `unstable`: cells that are unstable below the limits of
/// passivity.
bool measure_maps(const std::string& results, std::uint64_t& hash, int& unstable) {
    for (const Slice& slice : slices()) {
        fmt::print("{:<10} {:4} cells: {}\n", slice.name, slice.cells.size(), slice.title);
        const auto measured = measure_all(slice.cells);
        for (const CellResult& result : measured) unstable += result.unstable_below;
        const std::string path = results + "/" + slice.name + ".csv";
        if (!write_all(path, cell_columns, slice.cells, measured, hash)) return false;
    }
    fmt::print("unstable below the limits of passivity: {}\n", unstable);
    return true;
}

/// Assumes a period of delay, as the loop does.
bool write_settings(const std::string& path) {
    std::ofstream csv(path);
    csv << "# The same on every machine: tests/lab/stability/run\n"
           "profile,rate_Hz,stiffness_N_per_m,largest_N_per_m,damping_Ns_per_m,encoder_mm\n";
    for (const DeviceProfile& profile : all_devices()) {
        for (double rate_Hz = 125.0; rate_Hz < 33000.0; rate_Hz *= std::exp2(0.25)) {
            const LoopSettings settings = loop_settings(profile, 1.0 / rate_Hz, 1.0 / rate_Hz);
            csv << fmt::format("{},{:.6g},{:.5g},{:.5g},{:g},{:.4g}\n", profile.name, rate_Hz,
                               settings.stiffness_N_per_m, settings.largest_stiffness_N_per_m,
                               settings.damping_Ns_per_m, 1e3 * encoder_step_m(profile));
        }
    }
    return static_cast<bool>(csv.flush());
}

/// Returns whether all could be written. `work`: for what is too long to keep.
bool measure_loops(const std::string& results, const std::string& work, std::uint64_t& hash) {
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
    return write_settings(results + "/settings.csv") &&
           write_all(work + "/loops.csv", factorial_columns, loops, measure_all(loops), hash) &&
           write_all(work + "/scenarios.csv", scenario_columns, scenarios, measure_all(scenarios),
                     hash);
}

}  // namespace
}  // namespace touchline::stability

int main(int argc, char** argv) {
    using namespace touchline::stability;
    if (argc != 3) {
        fmt::print(stderr, "usage: stability_bench RESULTS WORK\n");
        return 2;
    }
    const std::string results = argv[1];
    std::uint64_t maps = hashed("");
    std::uint64_t loops = hashed("");
    int unstable = 0;
    if (!measure_maps(results, maps, unstable) || !measure_loops(results, argv[2], loops)) return 1;
    std::ofstream(results + "/hash.txt") << fmt::format("{:016x}\n{:016x}\n", maps, loops);
    return unstable == 0 ? 0 : 1;
}
