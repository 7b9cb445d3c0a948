// Reads a table as programs write it (RFC 4180): quoted fields, any end of line, a byte order mark;
// also with semicolons or tabs between the values, and the decimal comma that goes with those.
// Threads: values and pure functions.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

struct CsvRow {
    std::size_t line = 1;             // where it begins in the text
    std::vector<std::string> fields;  // without quotes; unquoted ones without blanks around
};

struct CsvTable {
    char separator = ',';      // the first row's
    std::vector<CsvRow> rows;  // those that are not blank
};

/// The separator is the one outside of quotes in the first row, or a comma if it has none; a line
/// "sep=;" before it sets it too. Fails with one line that names the text's line: UTF-16, a NUL, an
/// unclosed quote, letters after a closing quote. O(text).
[[nodiscard]] Result<CsvTable> csv_table(std::string_view text);

}  // namespace touchline
