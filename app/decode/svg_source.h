// Private to app/decode: the text of an SVG file.
// Threads: pure functions.
#pragma once

#include "app/decode/formats.h"

#include <string>

namespace touchline::decode {

/// The text is in UTF-8, or in whatever one-byte code the file declares: unpacked where it is
/// packed (gzip), of UTF-16 the same in UTF-8 without its declaration. Fails with one line for what
/// is damaged, more than 64 MB when unpacked, or no SVG. O(text).
[[nodiscard]] Result<std::string> svg_text(Bytes bytes);

}  // namespace touchline::decode
