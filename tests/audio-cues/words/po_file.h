// Reads a gettext catalogue as people write it. Threads: pure functions except for the file.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

struct PoEntry {
    std::string plural;             // the English plural; empty: not counted
    std::vector<std::string> said;  // one text, or one for each plural form
    bool is_doubtful = false;       // marked "fuzzy"
};

/// Entries by context and English text; the header is ("", "").
using PoFile = std::map<std::pair<std::string, std::string>, PoEntry>;

/// Returns the number of forms of a counted text as the header says; 2, as in English, if it says
/// nothing.
[[nodiscard]] std::size_t plural_forms(const PoFile& file);

/// Returns an empty catalogue if the file does not exist.
[[nodiscard]] PoFile read_po(const std::string& path);

}  // namespace touchline
