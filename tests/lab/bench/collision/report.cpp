#include "tests/lab/bench/collision/report.h"

#include <array>
#include <cstdlib>
#include <ctime>
#include <fstream>

namespace touchline::bench {
namespace {

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const std::size_t colon = line.find(": ");
        if (line.rfind("model name", 0) == 0 && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return "unknown processor";
}

std::string load() {
    std::array<double, 3> average{};
    if (getloadavg(average.data(), 3) != 3) return "load unknown";
    return fmt::format("load {:.2f} {:.2f} {:.2f}", average[0], average[1], average[2]);
}

std::string date() {
    std::array<char, 32> text{};
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&now, &parts);
    std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M UTC", &parts);
    return text.data();
}

}  // namespace

CsvFile::CsvFile(const std::string& folder, std::string_view name, std::string_view columns)
    : file_(std::fopen(fmt::format("{}/{}", folder, name).c_str(), "we")) {
    if (!file_) {
        fmt::print(stderr, "cannot write {}/{}\n", folder, name);
        std::exit(EXIT_FAILURE);
    }
    fmt::print(file_.get(), "# {}; {}; {}; GCC {}; the timer's own {:.0f} ns are included\n",
               date(), processor(), load(), __VERSION__,
               ns_per_tick() * static_cast<double>(timer_cost_ticks()));
    line(std::string(columns));
}

void CsvFile::line(const std::string& values) {
    fmt::print(file_.get(), "{}\n", values);
    std::fflush(file_.get());
    fmt::print("{}\n", values);
    std::fflush(stdout);
}

std::string times_of(const HandRun& run) {
    const StepTimes least = step_times(run.least_ticks);
    const StepTimes first = step_times(run.first_ticks);
    return fmt::format("{:.0f},{:.0f},{:.0f},{:.0f}", least.median_ns, least.p99_ns, least.max_ns,
                       first.p99_ns);
}

}  // namespace touchline::bench
