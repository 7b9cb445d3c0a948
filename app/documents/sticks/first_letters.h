// Divides a long list of names by their letters, so that six keys find one of thousands.
// Threads: pure functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace touchline {

/// letters: names that begin with `beginning`. digits: with any digit. other: with a sign of a
/// script that has thousands, or with no letter or digit at all.
enum class LetterKind : std::uint8_t { letters, digits, other };

struct LetterGroup {
    LetterKind kind = LetterKind::letters;
    std::string beginning;          // "B", "IMG2"; empty for the other kinds
    std::vector<std::size_t> rows;  // indices of the names, in their order; never empty

    friend bool operator==(const LetterGroup&, const LetterGroup&) = default;
};

/// Divides these rows of `names` where they first differ: by the first letter in most lists, by the
/// digit after "IMG" in a camera's. The names are files of any bytes; endings, and all signs
/// between letters and digits, do not count. Accents and capitals count only if the language has a
/// letter of its own ("ñ" in Spanish). Names that begin with digits are one group beside those that
/// begin with letters. Returns one group if nothing tells the names apart. Groups are in the
/// language's order, digits first. `language`: a code of ISO 639. O(all names), some milliseconds
/// for 10 000.
[[nodiscard]] std::vector<LetterGroup> letter_groups(std::span<const std::string> names,
                                                     std::span<const std::size_t> rows,
                                                     const std::string& language);

}  // namespace touchline
