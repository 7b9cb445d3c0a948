// What can be wrong with a picture pack, and the sentence for it: what, why, what to do.
// Threads: values and pure functions.
#pragma once

#include "config/types/result.h"

#include <cstdint>
#include <string>
#include <utility>

namespace touchline {

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

}  // namespace touchline
