// The texts that a curator writes beside pictures: lines of "key: value". Threads: pure functions.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

struct CuratorLine {
    int line = 0;       // from 1
    std::string key;    // one blank between words, as it was written
    std::string value;  // one line; never empty
};

struct CuratorTexts {
    std::vector<CuratorLine> lines;   // in their order
    std::vector<std::string> faults;  // one sentence each, with the file and the line
};

/// A line that begins with a blank goes on with the value before it; empty lines and lines that
/// begin with # are left out. A byte order mark and any ends of lines are taken. `name`: of the
/// file. Faults: no UTF-8, no colon, no value, a key twice, a value of more than
/// longest_curator_bytes. O(bytes).
[[nodiscard]] CuratorTexts curator_texts(const std::string& name, std::span<const std::byte> bytes);

inline constexpr std::size_t longest_curator_bytes = 4000;  // all that is ever said in one go

/// "boat.txt, line 3: ..."; without a line, "boat.txt: ...".
[[nodiscard]] std::string curator_fault(const std::string& name, int line, std::string_view what);

}  // namespace touchline
