// What a stick offers, and the bytes in which one process tells it to another.
// Threads: values and pure functions.
#pragma once

#include "app/sticks/file_kind.h"
#include "config/types/result.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

inline constexpr std::size_t most_listed = 500;
inline constexpr std::size_t longest_name_bytes = 1020;  // 255 characters of UTF-8, as on exFAT

/// A file that can be asked for. Names are raw bytes: show, say and log them by names.h only.
struct StickEntry {
    StickFileKind kind = StickFileKind::picture;
    std::string folder;  // empty: it lies in the root
    std::string name;

    friend bool operator==(const StickEntry&, const StickEntry&) = default;
};

struct StickListing {
    std::vector<StickEntry> entries;  // root first, then folder by folder, in natural order
    std::uint32_t not_listed = 0;     // files of the same kinds that were found beyond most_listed
    bool is_whole = true;             // false: something was not looked into

    friend bool operator==(const StickListing&, const StickListing&) = default;
};

/// Can it be the name of a file in a folder: 1 to longest_name_bytes, without '/' and NUL, neither
/// "." nor ".."? O(n).
[[nodiscard]] bool is_file_name(std::string_view name);

/// O(n). The listing must be one that listing_of() would accept.
[[nodiscard]] std::vector<std::byte> bytes_of(const StickListing& listing);

/// The other way; the bytes may come from anybody. Fails with one line unless every name is one,
/// every number in its range and every byte used. O(n).
[[nodiscard]] Result<StickListing> listing_of(std::span<const std::byte> bytes);

/// One sentence for what is not shown, "" where all is.
[[nodiscard]] std::string remainder_sentence(const StickListing& listing);

/// One sentence where nothing can be chosen, "" where something can.
[[nodiscard]] std::string nothing_sentence(const StickListing& listing);

}  // namespace touchline
