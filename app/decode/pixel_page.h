// Private to app/decode: the page of a file that is one picture of pixels.
// Threads: as metadata.h.
#pragma once

#include "app/decode/formats.h"

namespace touchline::decode {

using PixelReader = Result<Stored> (*)(Bytes bytes);

/// What is read, upright, of square pixels, in sRGB, and what the file tells of it. Fails as the
/// reader does, or with another page than 1.
[[nodiscard]] Result<Page> page_by(PixelReader read, Bytes bytes, const PageOrder& order);

}  // namespace touchline::decode
