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

std::filesystem::path installed_or(const std::filesystem::path& beside_programs,
                                   const std::filesystem::path& in_sources) {
    const auto installed = own_folder() / beside_programs;
    std::error_code error;
    const bool is_there = !own_folder().empty() && std::filesystem::exists(installed, error);
    return is_there ? installed.lexically_normal() : in_sources;
}

std::filesystem::path settings_folder() {
    const std::string chosen = environment("XDG_CONFIG_HOME");
    const std::string home = environment("HOME");
    const std::filesystem::path user = !chosen.empty() ? std::filesystem::path(chosen)
                                       : home.empty()  ? std::filesystem::path("/etc")
                                                       : std::filesystem::path(home) / ".config";
    return user / "touchline";
}

std::string companion(const std::string& name) {
    const std::string chosen = environment("TOUCHLINE_PROGRAMS");
    return ((chosen.empty() ? own_folder() : std::filesystem::path(chosen)) / name).string();
}

}  // namespace touchline
