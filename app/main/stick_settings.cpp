#include "app/main/stick_settings.h"

#include "app/decode/files.h"
#include "app/process/places.h"

#include <filesystem>
#include <system_error>

namespace touchline {
namespace {

std::string settings_file() {
    const std::string chosen = environment("TOUCHLINE_STICKS");
    if (!chosen.empty()) return chosen;
    std::error_code error;
    const auto installed = own_folder() / TOUCHLINE_STICKS_BESIDE_PROGRAM;
    if (std::filesystem::is_regular_file(installed, error))
        return installed.lexically_normal().string();
    return TOUCHLINE_STICKS_SOURCE;
}

}  // namespace

Result<StickSettings> read_stick_settings() {
    const std::string path = settings_file();
    const auto bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    return parse_sticks({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, path);
}

}  // namespace touchline
