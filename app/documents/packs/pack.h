// A picture pack: maps, their texts and recorded voices, in a folder or a zip file. pack.toml lists
// its contents (README.md shows one). Here are its limits, what can be wrong with it and the
// sentence for that, what it holds, and how it is read and written. Threads: values and pure
// functions, except what reads or writes files, which waits for workers.
#pragma once

#include "config/types/result.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace touchline {

/// Anything beyond is refused before it costs anything.
struct PackLimits {
    std::size_t zip_bytes = std::size_t{64} << 20U;   // of the zip file
    std::size_t files = 500;                          // how many
    std::size_t file_bytes = std::size_t{16} << 20U;  // of one file, unpacked
    std::size_t all_bytes = std::size_t{96} << 20U;   // of all files, unpacked
    std::size_t toml_bytes = std::size_t{1} << 20U;   // of pack.toml
    std::size_t name_bytes = 120;                     // of a file, with its folders
    std::size_t folders = 3;                          // above a file
    std::size_t pictures = 100;
    std::size_t sounds = 400;
    std::size_t languages = 12;
    std::size_t text_bytes = 400;  // of a title or an author
    double sound_s = 60.0;         // of one recording
};

inline constexpr PackLimits pack_limits;

class Language;

/// refusal: the pack is not accepted. gap: it is, but somebody will miss something. hint: it could
/// be easier for a hand.
enum class FindingSeverity : std::uint8_t { refusal, gap, hint };

/// Refusals first, then gaps from no_such_part, then hints from lines_near. touchline-unpack sends
/// their numbers.
enum class FindingKind : std::uint8_t {
    no_such_pack,
    unreadable,
    empty,
    no_zip,
    damaged_zip,
    harmful,
    too_slow,
    no_memory,
    no_worker,
    zip_too_large,
    too_many_files,
    file_too_large,
    all_too_large,
    leads_outside,
    name_not_plain,
    name_too_long,
    too_deep,
    twice,
    link,
    no_file,
    locked,
    nested,
    odd_kind,
    no_pack_toml,
    toml_syntax,
    toml_unknown,
    toml_missing,
    toml_value,
    too_many_named,
    not_in_pack,
    picture_broken,
    sound_unknown,
    sound_broken,
    sound_long,
    sound_form,
    older,
    library_unwritable,
    output_unwritable,
    no_such_part,
    no_title,
    no_description,
    no_part_name,
    title_language,
    description_language,
    part_language,
    lines_near,
    many_parts,
    much_line,
    near_rim,
    no_difficulty,
    other_size,
    same_name,
    not_named,
    quiet_sound,
};

inline constexpr int finding_kind_count = static_cast<int>(FindingKind::quiet_sound) + 1;

struct PackFinding {
    FindingKind kind = FindingKind::harmful;
    std::string file{};  // in the pack, or the pack itself; may be empty
    int line = 0;        // from 1; 0: unknown
    std::string what{};  // what the sentence names: a part, a key, a language, a version
    double value = 0.0;  // the number in the sentence, in its unit

    friend bool operator==(const PackFinding&, const PackFinding&) = default;
};

template <class T>
using PackResult = Result<T, PackFinding>;

[[nodiscard]] constexpr FindingSeverity severity_of(FindingKind kind) {
    if (kind < FindingKind::no_such_part) return FindingSeverity::refusal;
    return kind < FindingKind::lines_near ? FindingSeverity::gap : FindingSeverity::hint;
}

/// "fish.svg, line 12: ...": fit for a screen, a voice and a terminal, whatever name the file has
/// in the pack.
[[nodiscard]] std::string sentence_of(const PackFinding& finding, const Language& language);

[[nodiscard]] inline tl::unexpected<PackFinding> refusal(PackFinding finding) {
    return tl::unexpected<PackFinding>(std::move(finding));
}

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

/// Names are plain and unique, sizes are within pack_limits, and every file that `info` names
/// exists. The contents are not checked yet (check_pack()).
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

/// Reads "1", "1.2" or "1.2.3"; nothing for any other text.
[[nodiscard]] std::optional<PackVersion> version_of(std::string_view text);

/// "1.2.0"
[[nodiscard]] std::string text_of(const PackVersion& version);

/// The title in `language`, else the one without a language, else the first.
[[nodiscard]] const std::string& title_in(const PackInfo& info, const std::string& language);

inline constexpr const char* pack_table_name = "pack.toml";

/// Every field is in its range, names are plain, no picture and no language occurs twice, and every
/// sound belongs to a listed picture. O(n log n).
[[nodiscard]] PackResult<PackInfo> pack_info_of(std::string_view toml);

/// Reading it gives the same PackInfo. O(n).
[[nodiscard]] std::string toml_of(const PackInfo& info);

/// True for two or three letters, and parts of up to eight after hyphens: "de", "pt-BR".
[[nodiscard]] bool is_language_tag(std::string_view tag);

/// Reads a folder and writes it as a zip file for other people (zip_of() of unpacking.h), whole or
/// not at all. With a language, every picture becomes a layered picture of the IMAGE project in it
/// (map_svg.h); everything else stays as it was.
[[nodiscard]] PackResult<void> export_pack(const std::string& folder, const std::string& zip_file,
                                           const std::string& image_language = {});

/// Tells teachers who make a pack whether it can be used, and what would make it better; waits for
/// a worker for each picture and each sound. Refusals first, then gaps, then hints, each in the
/// order of the files. Empty: nothing to say.
[[nodiscard]] std::vector<PackFinding> check_pack(const Pack& pack);

/// read_pack() and check_pack(). A pack that cannot be read gives one finding.
[[nodiscard]] std::vector<PackFinding> check_pack(const std::string& path);

/// True if there is no refusal among them.
[[nodiscard]] bool can_be_used(const std::vector<PackFinding>& findings);

}  // namespace touchline
