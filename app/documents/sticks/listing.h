// What a stick offers, in values and in the bytes that carry them between two processes, and why a
// file or a stick is not read.
// Threads: values and pure functions.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// picture: one image. document: pages or vectors. office: counted so that one sentence can ask for
/// PDFs; it is not offered. Only for the operator: pack, of pictures; network, one that Touchline
/// knows (app/documents/models); bundle and house_key, for several kiosks (app/house).
enum class StickFileKind : std::uint8_t {
    picture,
    document,
    office,
    pack,
    network,
    bundle,
    house_key
};

inline constexpr int stick_file_kind_count = 7;

/// Decides by the ending, in any case (file_formats of app/documents/decode/file_format.h); the
/// process that opens a file learns from its first bytes what it really is. Nothing for a file that
/// is not offered, or that is only for the operator.
[[nodiscard]] std::optional<StickFileKind> kind_of_name(std::string_view name);

/// The same for what the operator is offered.
[[nodiscard]] std::optional<StickFileKind> operator_kind_of_name(std::string_view name);

/// True for hidden files and folders, and for those that systems put on sticks for themselves.
[[nodiscard]] bool is_left_out(std::string_view name);

inline constexpr std::size_t most_house_key_bytes = 4096;  // of a file that holds one

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
    int office_files = 0;         // counted by the kiosk among a listing's entries

    friend bool operator==(const StickRest&, const StickRest&) = default;
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

/// The largest listing in bytes: its names and paths, and some bytes for each.
inline constexpr std::size_t most_listing_bytes = std::size_t{9} << 20U;

/// O(n). The listing must be one that listing_of() would accept.
[[nodiscard]] std::vector<std::byte> bytes_of(const StickListing& listing);

/// The reverse; the bytes are untrusted. Fails with one line unless every name is valid, every
/// number is in its range and every byte is used. O(n).
[[nodiscard]] Result<StickListing> listing_of(std::span<const std::byte> bytes);

/// The order is that of touchline-import's exit statuses.
enum class StickRefusal : std::uint8_t {
    gone,  // it was pulled out
    no_such_file,
    no_file,  // a link, a folder, a device: nothing that holds a picture
    too_large,
    empty,
    unreadable,  // an error of the stick or its file system
    locked,      // for another user, as is possible on ext4 and NTFS
    out_of_time,
    not_started,  // the importing program is missing, or its sandbox fails
    out_of_memory,
};

inline constexpr int stick_refusal_count = 10;

/// touchline-import's exit status: this and the StickRefusal; 0 if everything was written, 2 for
/// wrong words.
inline constexpr int first_refusal_status = 80;

/// One sentence: file, why, what to do. `name` comes from names.h, in the form for the listener;
/// empty for the stick as a whole.
[[nodiscard]] std::string sentence_of(StickRefusal refusal, std::string_view name);

}  // namespace touchline
