// A gettext catalogue as people write it. Threads: pure functions but for the file.
#pragma once

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

/// Empty for a file that is not there.
[[nodiscard]] PoFile read_po(const std::string& path);

}  // namespace touchline
