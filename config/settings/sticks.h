// Where visitors' files come from. Threads: values and pure functions.
#pragma once

#include "config/types/result.h"

#include <string>
#include <string_view>

namespace touchline {

struct StickSettings {
    /// Empty: USB sticks, through udisks2. Else this folder, an absolute path, takes their place.
    std::string watched_folder;

    friend bool operator==(const StickSettings&, const StickSettings&) = default;
};

/// What the text of a file holds; `name` is that file's, for the error. Malformed, an unknown key
/// or a value that is none: one line with file and line number.
[[nodiscard]] Result<StickSettings> parse_sticks(std::string_view text, std::string_view name);

}  // namespace touchline
