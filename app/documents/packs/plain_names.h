// Plain names of files in a pack, which every system and every packing program writes the same way.
// Threads: pure functions.
#pragma once

#include "app/documents/packs/pack.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace touchline {

/// Checks folders and a file with '/' between: letters a to z, digits, blank, dot, hyphen,
/// underscore. No part begins with a dot or a blank, or ends with one. Returns nothing if the name
/// is plain. The bytes may be anything, NUL too. O(n).
[[nodiscard]] std::optional<FindingKind> trouble_with_name(std::string_view name);

/// A refusal of a file, or of the pack if `file` is empty, with the number that its sentence
/// mentions: the limit in pack_limits that was exceeded; 0 for other kinds.
[[nodiscard]] tl::unexpected<PackFinding> refused(FindingKind kind, const std::string& file = {});

enum class PackFileKind : std::uint8_t { table, picture, sound, text, other };

/// The kind by the name's ending; touchline-unpack compares it with the contents.
[[nodiscard]] PackFileKind kind_by_name(std::string_view name);

/// Tells by name and first bytes why a file may not be in a pack: it is a packed file, or of a kind
/// that no pack holds. Returns nothing if it may. O(1).
[[nodiscard]] std::optional<FindingKind> trouble_with_file(std::string_view name,
                                                           std::span<const std::byte> bytes);

/// True for files that operating systems put into folders on their own.
[[nodiscard]] bool is_litter(std::string_view name);

}  // namespace touchline
