// What a stick offers, and its form in bytes between two processes.
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

inline constexpr std::size_t most_listed = 10'000;
inline constexpr std::size_t most_listed_folders = 2'000;
inline constexpr std::size_t most_listed_bytes = std::size_t{8} << 20U;  // of names and paths
inline constexpr std::size_t deepest_folder = 8;         // a folder in the root has depth 1
inline constexpr std::size_t longest_name_bytes = 1020;  // 255 characters of UTF-8, as on exFAT

/// A file of a stick. Names are raw bytes: show, say and log them only by names.h.
struct StickEntry {
    StickFileKind kind = StickFileKind::picture;
    std::string folder;  // "DCIM/100CANON"; empty: the root
    std::string name;

    friend bool operator==(const StickEntry&, const StickEntry&) = default;
};

/// What a listing leaves out.
struct StickRest {
    /// How many files of the same kinds were found beyond most_listed, or most_listed_bytes.
    std::uint32_t not_listed = 0;
    bool has_deeper = false;      // there are folders below deepest_folder
    bool has_unreadable = false;  // folders, or names in them, could not be read
    bool is_cut_short = false;    // too many folders or names, or no time for them

    friend bool operator==(const StickRest&, const StickRest&) = default;

    [[nodiscard]] bool is_nothing() const { return *this == StickRest{}; }
};

struct StickListing {
    /// A folder's files, then the contents of its folders, each in natural order.
    std::vector<StickEntry> entries;
    StickRest rest;

    friend bool operator==(const StickListing&, const StickListing&) = default;
};

/// True if it can be the name of a file in a folder: 1 to longest_name_bytes, without '/' and NUL,
/// neither "." nor "..". O(n).
[[nodiscard]] bool is_file_name(std::string_view name);

/// True if it is empty, for the root, or 1 to deepest_folder names of files with '/' between, and
/// not longer than a path may be. O(n).
[[nodiscard]] bool is_folder_path(std::string_view path);

/// O(n). The listing must be one that listing_of() would accept.
[[nodiscard]] std::vector<std::byte> bytes_of(const StickListing& listing);

/// The reverse; the bytes are untrusted. Fails with one line unless every name is valid, every
/// number is in its range and every byte is used. O(n).
[[nodiscard]] Result<StickListing> listing_of(std::span<const std::byte> bytes);

}  // namespace touchline
