// touchline pack: picture packs, for people who make and install them.
// Threads: one.
#pragma once

#include "config/types/result.h"

#include <cstdint>
#include <iosfwd>
#include <string>

namespace touchline {

/// check: every finding about a pack, one sentence per line. import: installs it into the library.
/// export: writes a folder as a zip file.
enum class PackAction : std::uint8_t { check, import, write };

struct PackCommandOptions {
    PackAction action = PackAction::check;
    std::string input;
    std::string output;   // for export
    std::string library;  // for import; empty: the user's
    std::string
        image_language;  // for export: as layered pictures of the IMAGE project; empty: unchanged
    bool takes_older = false;  // for import: also over a newer version
};

/// Fails with one sentence if the pack cannot be used.
[[nodiscard]] Result<void> run_pack(const PackCommandOptions& options, std::ostream& out);

}  // namespace touchline
