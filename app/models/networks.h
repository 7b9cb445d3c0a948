// The networks that Touchline knows, what each is for, and where it comes from: one table. Some
// ship with Touchline; without one of the others, what needs it is left out. Threads: any, each
// call by itself.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

struct Network {
    std::string_view name = {};     // of the command line
    std::string_view job = {};      // one sentence: what it does for a visitor
    std::string_view package = {};  // of the npm registry
    std::string_view version = {};
    std::string_view package_sha256 = {};
    std::string_view licence = {};    // as its publisher states it
    std::string_view note = {};       // what else somebody who installs it should know
    std::string_view input = {};      // what it looks at
    std::string_view converter = {};  // beside app/models/get
    bool ships = false;               // with Touchline: nobody gets or brings it
    std::string_view file = {};       // as it is installed
    std::uint64_t bytes = 0;          // of that file
    std::string_view sha256 = {};     // of that file
};

[[nodiscard]] std::span<const Network> networks();

/// Null for a name that nobody knows.
[[nodiscard]] const Network* network_named(std::string_view name);

/// Which of these networks the bytes are, by size and checksum; null for any others, those that
/// ship among them.
[[nodiscard]] const Network* network_of(std::span<const std::byte> bytes,
                                        std::span<const Network> among = networks());

/// Where networks lie that somebody got or brought: TOUCHLINE_MODELS, else touchline/models in the
/// user's data folder.
[[nodiscard]] std::filesystem::path models_folder();

/// What is installed with the program: `get`, what rewrites, and in `shipped` the networks that
/// ship.
[[nodiscard]] std::filesystem::path models_of_program();

/// Where its file lies, or would.
[[nodiscard]] std::filesystem::path installed_file(const Network& network);

/// Whether its file is there; whether it is whole is known to who reads it.
[[nodiscard]] bool is_installed(const Network& network);

/// The file's bytes. Fails, with one line that says what to do, where it is absent or is not what
/// the table says (0.2 s for 44 MB).
[[nodiscard]] Result<std::vector<std::byte>> read_network(const Network& network);

/// The same of a file that lies elsewhere.
[[nodiscard]] Result<std::vector<std::byte>> read_network(const Network& network,
                                                          const std::filesystem::path& file);

}  // namespace touchline
