#include "app/isolation/process/places.h"

#include <cstdlib>
#include <system_error>

namespace touchline {
namespace {

std::filesystem::path user_folder(const char* variable, const char* in_home, const char* without) {
    const std::string chosen = environment(variable);
    if (!chosen.empty()) return chosen;
    const std::string home = environment("HOME");
    return home.empty() ? std::filesystem::path(without) : std::filesystem::path(home) / in_home;
}

}  // namespace

std::string environment(const char* name) {
    const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
    return value == nullptr ? std::string() : value;
}

std::filesystem::path own_folder() {
    std::error_code error;
    const auto own = std::filesystem::read_symlink("/proc/self/exe", error);
    return error ? std::filesystem::path() : own.parent_path();
}

std::filesystem::path installed_place(const std::string& beside_program,
                                      const std::string& source) {
    const std::filesystem::path own = own_folder();
    const std::filesystem::path installed = (own / beside_program).lexically_normal();
    std::error_code error;
    return !own.empty() && std::filesystem::exists(installed, error)
               ? installed
               : std::filesystem::path(source);
}

std::filesystem::path user_settings_folder() {
    return user_folder("XDG_CONFIG_HOME", ".config", "/etc");
}

std::filesystem::path user_data_folder() {
    return user_folder("XDG_DATA_HOME", ".local/share", "/var/lib");
}

std::string companion(const std::string& name) {
    const std::string chosen = environment("TOUCHLINE_PROGRAMS");
    return ((chosen.empty() ? own_folder() : std::filesystem::path(chosen)) / name).string();
}

}  // namespace touchline
