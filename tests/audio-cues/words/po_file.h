// A gettext catalogue as people write it. Threads: pure functions but for the file.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

struct PoEntry {
    std::string plural;             // the English of several; empty: not counted
    std::vector<std::string> said;  // one, or one a form of plural
    bool is_doubtful = false;       // "fuzzy"
};

/// By context and English; the head is ("", "").
using PoFile = std::map<std::pair<std::string, std::string>, PoEntry>;

/// How many forms a counted text has, as the head says: 2 where it says nothing, as in English.
[[nodiscard]] std::size_t plural_forms(const PoFile& file);

/// Empty for a file that is not there.
[[nodiscard]] PoFile read_po(const std::string& path);

}  // namespace touchline
