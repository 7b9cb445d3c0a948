#include "tests/lab/bench/kiosk/process_tree.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include <fcntl.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

fs::path place_of(pid_t process) {
    return fs::path("/proc") / std::to_string(process);
}

/// The fields of /proc/PID/stat from the third on, for the second may hold blanks. Source: proc(5).
std::vector<double> numbers_of(pid_t process) {
    const std::string text = text_of(place_of(process) / "stat");
    std::istringstream words(text.substr(std::min(text.rfind(')') + 1, text.size())));
    std::string state;
    words >> state;
    return {std::istream_iterator<double>(words), {}};
}

constexpr std::size_t parent_field = 0;
constexpr std::size_t first_time_field = 10;  // utime, stime, cutime, cstime

bool is_figure_worker(pid_t process) {
    return text_of(place_of(process) / "comm").starts_with("touchline-figur");
}

/// The sum that the kernel calls Pss, kB.
double proportional_kB(pid_t process) {
    std::ifstream rows(place_of(process) / "smaps_rollup");
    for (std::string line; std::getline(rows, line);)
        if (line.starts_with("Pss:")) return std::stod(line.substr(4));
    return 0.0;
}

}  // namespace

std::vector<pid_t> tree_of(pid_t root) {
    std::multimap<pid_t, pid_t> children;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        const std::string name = entry.path().filename();
        if (std::isdigit(static_cast<unsigned char>(name.front())) == 0) continue;
        const auto process = static_cast<pid_t>(std::stol(name));
        const std::vector<double> numbers = numbers_of(process);
        if (!numbers.empty()) children.emplace(static_cast<pid_t>(numbers[parent_field]), process);
    }
    std::vector<pid_t> tree{root};
    for (std::size_t i = 0; i < tree.size(); ++i) {
        const auto [from, to] = children.equal_range(tree[i]);
        for (auto at = from; at != to; ++at) tree.push_back(at->second);
    }
    return tree;
}

double processor_time_s(const std::vector<pid_t>& processes) {
    double ticks = 0.0;
    for (const pid_t process : processes) {
        const std::vector<double> numbers = numbers_of(process);
        for (std::size_t i = first_time_field; i < first_time_field + 4 && i < numbers.size(); ++i)
            ticks += numbers[i];
    }
    return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

TreeMemory memory_of(const std::vector<pid_t>& processes) {
    TreeMemory memory;
    for (const pid_t process : processes) {
        double& sum_MB = is_figure_worker(process) ? memory.figure_MB : memory.all_MB;
        sum_MB += proportional_kB(process) / 1024.0;
    }
    return memory;
}

std::vector<std::string> mapped_files(pid_t process) {
    std::ifstream rows(place_of(process) / "maps");
    std::set<std::string> files;
    for (std::string line; std::getline(rows, line);) {
        const std::size_t path = line.find('/');
        if (path != std::string::npos) files.insert(line.substr(path));
    }
    return {files.begin(), files.end()};
}

void forget_cached(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return;
    (void)posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
    ::close(file);
}

}  // namespace touchline
