// The benchmark's files: CSV with the machine, its load and the date in the first lines.
// Threads: one.
#pragma once

#include "tests/bench/collision/run.h"
#include "tests/bench/workload.h"

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

namespace touchline::bench {

/// What all parts of the benchmark are run with.
struct BenchOptions {
    std::string folder = ".";  // for the CSV files; must be there
    std::size_t steps = 100000;
    std::size_t largest = 1048576;  // edges
    RunLimits limits;
};

[[nodiscard]] constexpr std::string_view name_of(workload::Kind kind) {
    return kind == workload::Kind::radial ? "radial" : "fractal";
}

/// Lines are on the disk as soon as they are written, so that a run that is broken off leaves what
/// it had.
class CsvFile {
  public:
    /// Ends the program with one line on stderr where the file cannot be written.
    CsvFile(const std::string& folder, std::string_view name, std::string_view columns);

    /// One line; also shown on stdout.
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

/// "median,p99,max,raw p99" of a run, whole nanoseconds.
[[nodiscard]] std::string times_of(const HandRun& run);

void run_collision(const BenchOptions& options);
void run_scenes(const BenchOptions& options);
void run_growth(const BenchOptions& options);
void run_deadline(const BenchOptions& options);
void run_speed_accuracy(const BenchOptions& options);
void run_front(const BenchOptions& options);

}  // namespace touchline::bench
