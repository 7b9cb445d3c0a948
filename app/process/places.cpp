#include "app/process/places.h"

#include <cstdlib>
#include <system_error>

namespace touchline {

std::string environment(const char* name) {
    const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
    return value == nullptr ? std::string() : value;
}

std::filesystem::path own_folder() {
    std::error_code error;
    const auto own = std::filesystem::read_symlink("/proc/self/exe", error);
    return error ? std::filesystem::path() : own.parent_path();
}

std::string companion(const std::string& name) {
    const std::string chosen = environment("TOUCHLINE_PROGRAMS");
    return ((chosen.empty() ? own_folder() : std::filesystem::path(chosen)) / name).string();
}

}  // namespace touchline
