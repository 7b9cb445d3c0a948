// The names of parts that no person gave: those of traced lines and of faces, in every language.
// Threads: pure functions.
#pragma once

#include "audio-cues/words/language.h"

#include <optional>
#include <string>
#include <string_view>

namespace touchline {

/// What tracing says of a line (vision/simplify/simplify.h): "dashed line 2, upper left".
struct TracedName {
    std::string kind;    // "dashed line"
    std::string number;  // "2"; empty for the first of its kind and place
    std::string place;   // "upper left"
};

/// Nothing for any other label: a person named the part, or it is a face's. O(label).
[[nodiscard]] std::optional<TracedName> traced_name(std::string_view label);

/// Translates the label that tracing gives a line, or that of a face's part. Returns any other
/// label as it is.
[[nodiscard]] std::string part_name(const std::string& label, const Language& language);

}  // namespace touchline
