// touchline pack: picture packs, for those who make and install them.
// Threads: one.
#pragma once

#include "config/types/result.h"

#include <cstdint>
#include <iosfwd>
#include <string>

namespace touchline {

/// check: everything that can be said of a pack, a sentence a line. import: into the library.
/// export: a folder as a zip file.
enum class PackAction : std::uint8_t { check, import, write };

struct PackCommandOptions {
    PackAction action = PackAction::check;
    std::string input;
    std::string output;          // of export
    std::string library;         // of import; empty: the user's
    std::string image_language;  // of export: as layered pictures of the IMAGE project; empty: not
    bool takes_older = false;    // of import: also over a newer version
};

/// Fails with one sentence where the pack cannot be used.
[[nodiscard]] Result<void> run_pack(const PackCommandOptions& options, std::ostream& out);

}  // namespace touchline
