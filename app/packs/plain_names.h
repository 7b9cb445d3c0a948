// Names of files in a pack: what every system and every program that packs writes the same way.
// Threads: pure functions.
#pragma once

#include "app/packs/pack_finding.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace touchline {

/// Folders and a file with '/' between: letters a to z, digits, blank, dot, hyphen, underscore;
/// nothing begins with a dot or a blank or ends with one. Nothing: it is so. Any bytes may be
/// given, NUL too. O(n).
[[nodiscard]] std::optional<FindingKind> trouble_with_name(std::string_view name);

/// For telling which two names are one where capitals do not count. O(n).
[[nodiscard]] std::string folded(std::string_view name);

enum class PackFileKind : std::uint8_t { table, picture, sound, text, other };

/// By its ending, which touchline-unpack compares with the contents.
[[nodiscard]] PackFileKind kind_by_name(std::string_view name);

/// What a file of a pack may not be, by its name and its first bytes: a packed file, a kind that no
/// pack holds. Nothing: it may. O(1).
[[nodiscard]] std::optional<FindingKind> trouble_with_file(std::string_view name,
                                                           std::span<const std::byte> bytes);

/// What operating systems put into folders on their own.
[[nodiscard]] bool is_litter(std::string_view name);

}  // namespace touchline
