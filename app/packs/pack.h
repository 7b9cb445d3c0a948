// A picture pack: maps, their texts and recorded voices, in a folder or a zip file. pack.toml lists
// its contents (README.md shows one). Threads: values, except read_pack, which reads files and
// waits for a worker.
#pragma once

#include "app/packs/pack_finding.h"

#include <compare>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace touchline {

/// A text in one language; an empty language serves every other one.
struct LanguageText {
    std::string language;
    std::string text;

    friend bool operator==(const LanguageText&, const LanguageText&) = default;
};

/// "1.2" and "1.2.0" are the same. Each number from 0 to 9999.
struct PackVersion {
    int major = 0;
    int minor = 0;
    int patch = 0;

    friend auto operator<=>(const PackVersion&, const PackVersion&) = default;
};

struct PackPicture {
    std::string file;               // "fish.svg", in the pack
    std::optional<int> difficulty;  // 1 (easy) ... 5; none: what the picture says about itself

    friend bool operator==(const PackPicture&, const PackPicture&) = default;
};

enum class SoundText : std::uint8_t { title, description, part };

/// A recording of one text of one picture.
struct PackSound {
    std::string file;
    std::string picture;  // a file of PackPicture
    std::string language;
    SoundText says = SoundText::description;
    std::string part;  // the id of an outline, if a part's name is said

    friend bool operator==(const PackSound&, const PackSound&) = default;
};

/// The contents of pack.toml.
struct PackInfo {
    std::string id;                   // a to z, digits and hyphens: the same in every version
    std::vector<LanguageText> title;  // at least one
    std::string author;
    std::string licence;
    PackVersion version;
    std::vector<std::string> languages;  // every text should be in each; at least one
    std::vector<PackPicture> pictures;   // in the order of the list; at least one
    std::vector<PackSound> sounds;

    friend bool operator==(const PackInfo&, const PackInfo&) = default;
};

struct PackFile {
    std::string name;  // plain_names.h
    std::vector<std::byte> bytes;

    friend bool operator==(const PackFile&, const PackFile&) = default;
};

/// Names are plain and unique, sizes are within pack_limits.h, and every file that `info` names
/// exists. The contents are not checked yet (pack_check.h).
struct Pack {
    PackInfo info;
    std::vector<PackFile> files;  // sorted by name, pack.toml among them

    friend bool operator==(const Pack&, const Pack&) = default;
};

/// Reads a folder or a zip file. touchline-unpack unpacks zip files inside the sandbox. If a folder
/// holds nothing but one folder, reads that one. Leaves out what Macs and Windows put into folders
/// (__MACOSX, .DS_Store, Thumbs.db).
[[nodiscard]] PackResult<Pack> read_pack(const std::string& path);

/// The same for a zip file's bytes.
[[nodiscard]] PackResult<Pack> read_pack(std::span<const std::byte> zip);

/// Null if it is not in the pack. O(log files).
[[nodiscard]] const PackFile* find_file(const Pack& pack, const std::string& name);

/// "1.2.0"
[[nodiscard]] std::string text_of(const PackVersion& version);

/// The title in `language`, else the one without a language, else the first.
[[nodiscard]] const std::string& title_in(const PackInfo& info, const std::string& language);

}  // namespace touchline
