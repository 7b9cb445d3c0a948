// Private to app/decode: the page of a file that holds one picture of pixels.
// Threads: as metadata.h.
#pragma once

#include "app/decode/formats.h"

namespace touchline::decode {

using PixelReader = Result<Stored> (*)(Bytes bytes);

/// The picture, upright, with square pixels, in sRGB, and what the file says about it. Fails as the
/// reader does, or for a page other than 1.
[[nodiscard]] Result<Page> page_by(PixelReader read, Bytes bytes, const PageOrder& order);

}  // namespace touchline::decode
