// The benchmark's files: CSV with the machine, its load and the date in the first lines.
// Threads: one.
#pragma once

#include "tests/lab/bench/collision/run.h"
#include "tests/lab/bench/workload.h"

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

namespace touchline::bench {

/// The options of all parts of the benchmark.
struct BenchOptions {
    std::string folder = ".";  // for the CSV files; must exist
    std::size_t steps = 100000;
    std::size_t largest = 1048576;  // edges
    RunLimits limits;
};

[[nodiscard]] constexpr std::string_view name_of(workload::Kind kind) {
    return kind == workload::Kind::radial ? "radial" : "fractal";
}

/// Each line is on the disk as soon as it is written, so that an interrupted run leaves what it
/// had.
class CsvFile {
  public:
    /// Ends the program with one line on stderr if the file cannot be written.
    CsvFile(const std::string& folder, std::string_view name, std::string_view columns);

    /// Writes one line, also to stdout.
    void line(const std::string& values);

  private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    std::unique_ptr<std::FILE, Close> file_;
};

struct BuildCost {
    double ms = 0.0;
    double bytes_per_edge = 0.0;  // held after building
};

/// Builds with make() and measures it.
template <class Make>
[[nodiscard]] auto measured_build(std::size_t edges, const Make& make) {
    using Built = decltype(make());
    const std::size_t held_before = heap_bytes();
    const double begin_s = now_s();
    std::unique_ptr<Built> built(new Built(make()));
    const double ms = (now_s() - begin_s) * 1e3;
    const auto held = static_cast<double>(heap_bytes()) - static_cast<double>(held_before);
    return std::pair(std::move(built), BuildCost{ms, held / static_cast<double>(edges)});
}

/// Returns "median,p99,max,raw p99" of a run, in whole nanoseconds.
[[nodiscard]] std::string times_of(const HandRun& run);

void run_collision(const BenchOptions& options);
void run_scenes(const BenchOptions& options);
void run_growth(const BenchOptions& options);
void run_deadline(const BenchOptions& options);
void run_speed_accuracy(const BenchOptions& options);
void run_front(const BenchOptions& options);

}  // namespace touchline::bench
