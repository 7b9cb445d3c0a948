// The names of a traced picture's lines. Threads: pure function.
#pragma once

#include "audio-cues/words/language.h"

#include <string>

namespace touchline {

/// Translates the label that tracing gives a line by its kind and place (vision/simplify/parts.h),
/// "dashed line 2, upper left", or that of a face's part. Returns any other label as it is: a
/// person named the part.
[[nodiscard]] std::string part_name(const std::string& label, const Language& language);

}  // namespace touchline
