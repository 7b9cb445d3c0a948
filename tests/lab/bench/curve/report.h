// Where the bench's results go: tables as CSV for charts, and as words for readers.
// Threads: one.
#pragma once

#include "config/types/result.h"

#include <string>
#include <vector>

namespace touchline::bench {

struct Folders {
    std::string results;  // pictures, kept
    std::string work;  // NAME.md: the text between the marks of the README; NAME.csv, .dat: to plot
};

/// Rows of cells under a header, all with the same number of cells.
struct Table {
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;

    [[nodiscard]] std::string csv() const;
    [[nodiscard]] std::string markdown() const;
};

[[nodiscard]] Result<void> write_csv(const Folders& folders, const std::string& name,
                                     const Table& table);

/// Writes the section `name` of the README, wrapped at 110 columns unless it is a table.
[[nodiscard]] Result<void> write_words(const Folders& folders, const std::string& name,
                                       const std::string& text);

/// Returns "a", "a and b", "a, b and c".
[[nodiscard]] std::string list_in_words(const std::vector<std::string>& items);

}  // namespace touchline::bench
