// The networks that Touchline knows, the job of each, and where it comes from, in one table. Some
// ship with Touchline; without one of the others, the features that need it are left out. Threads:
// any, each call by itself.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace touchline {

struct Network {
    std::string_view name = {};     // on the command line
    std::string_view job = {};      // one sentence: what it does for a visitor
    std::string_view package = {};  // in the npm registry; empty: trained for Touchline
    std::string_view version = {};
    std::string_view package_sha256 = {};
    std::string_view licence = {};    // as its publisher states it
    std::string_view note = {};       // what else a person who installs it should know
    std::string_view input = {};      // what it looks at
    std::string_view converter = {};  // beside app/documents/models/get
    bool ships = false;               // with Touchline: nobody has to get or bring it
    std::string_view file = {};       // the installed file
    std::uint64_t bytes = 0;          // of that file
    std::string_view sha256 = {};     // of that file
};

[[nodiscard]] std::span<const Network> networks();

/// Null for an unknown name.
[[nodiscard]] const Network* network_named(std::string_view name);

/// The network of these bytes, by size and checksum; null for any other bytes, including networks
/// that ship.
[[nodiscard]] const Network* network_of(std::span<const std::byte> bytes,
                                        std::span<const Network> among = networks());

/// The folder of networks that somebody downloaded or brought: TOUCHLINE_MODELS, else
/// touchline/models in the user's data folder.
[[nodiscard]] std::filesystem::path models_folder();

/// The path of its file, whether it exists or not.
[[nodiscard]] std::filesystem::path installed_file(const Network& network);

/// True if its file exists; only reading it tells whether it is whole.
[[nodiscard]] bool is_installed(const Network& network);

/// The file's bytes. Fails with one line that says what to do if it is missing or differs from the
/// table (0.2 s for 44 MB).
[[nodiscard]] Result<std::vector<std::byte>> read_network(const Network& network);

/// The same for a file in another place.
[[nodiscard]] Result<std::vector<std::byte>> read_network(const Network& network,
                                                          const std::filesystem::path& file);

/// Downloads the package of a network that does not ship from its publisher, checks its checksum,
/// rewrites it and puts it into models_folder(): the file appears whole or not at all. Needs the
/// computer's network, npm and Python. Fails with one line. The caller must have shown the licence.
[[nodiscard]] Result<void> get_network(const Network& network);

/// Puts the bytes of a network where Touchline looks for it: whole, or leaving all as it was. Fails
/// with one line.
[[nodiscard]] Result<void> install_network(const Network& network,
                                           std::span<const std::byte> bytes);

/// The networks that look at a photograph: the bytes of their files, which lie elsewhere.
struct PictureNetworks {
    std::span<const std::byte> figure = {};        // empty: it is not installed
    std::span<const std::byte> small_figure = {};  // finds the same, less surely
    std::span<const std::byte> names = {};
    std::span<const std::byte> faces = {};
    std::span<const std::byte> meshes = {};
    std::span<const std::byte> persons = {};
};

/// The same with the bytes in it.
struct PictureNetworkFiles {
    std::vector<std::byte> figure;  // empty: not installed
    std::vector<std::byte> small_figure;
    std::vector<std::byte> names;
    std::vector<std::byte> faces;
    std::vector<std::byte> meshes;
    std::vector<std::byte> persons;

    /// The bytes stay in this object.
    [[nodiscard]] PictureNetworks networks() const {
        return {figure, small_figure, names, faces, meshes, persons};
    }
};

/// Fails with one line that says what to do if one that ships is missing, or any is damaged. Takes
/// 0.3 s.
[[nodiscard]] Result<PictureNetworkFiles> read_picture_networks();

}  // namespace touchline
