#include "tests/machines/sim/fault_lines.h"

#include "tests/machines/sim/allocated_bytes.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace touchline {
namespace {

std::string milliseconds(const std::optional<double>& span_s) {
    if (!span_s) return {};
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", 1e3 * *span_s);
    return text;
}

}  // namespace

int open_descriptors(int pid, Sockets sockets) {
    namespace fs = std::filesystem;
    std::error_code error;
    int count = 0;
    const std::string folder = "/proc/" + std::to_string(pid) + "/fd";
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        std::error_code gone;
        const std::string target = fs::read_symlink(entry->path(), gone).string();
        const bool is_socket = target.rfind("socket:", 0) == 0;
        if (!is_socket || sockets == Sockets::counted) ++count;
    }
    return count;
}

Holdings Holdings::now(Sockets sockets) {
    return {open_descriptors(getpid(), sockets), allocated_bytes()};
}

std::string test_name(std::string_view fault) {
    std::string name(fault);
    const auto is_other = [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); };
    std::replace_if(name.begin(), name.end(), is_other, '_');
    return name;
}

void tell(const FaultLine& line) {
    const char* const path = std::getenv("TOUCHLINE_FAULT_LINES");
    if (path == nullptr) return;
    std::ofstream file(path, std::ios::app);
    file << line.way << ';' << line.fault << ';' << line.seed << ';' << milliseconds(line.zero_s)
         << ';' << line.state << ';' << milliseconds(line.back_s) << ';' << line.is_back_by_itself
         << ';' << line.left.descriptors << ';' << line.left.bytes << '\n';
}

std::uint64_t fault_runs(std::uint64_t everyday, std::uint64_t all) {
    return std::getenv("TOUCHLINE_EXHAUSTIVE") != nullptr ? all : everyday;
}

}  // namespace touchline
