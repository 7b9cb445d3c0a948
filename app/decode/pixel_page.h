// Private to app/decode: the page of a file that is one picture of pixels.
// Threads: as metadata.h.
#pragma once

#include "app/decode/formats.h"

namespace touchline::decode {

struct PixelReader {
    Result<Picture> (*read)(Bytes bytes) = nullptr;
    bool is_turning = false;  // it gives the picture upright
};

/// What is read, upright, in sRGB, and what the file tells of it. Fails as the reader does, or with
/// another page than 1.
[[nodiscard]] Result<Page> page_by(const PixelReader& reader, Bytes bytes, const PageOrder& order);

}  // namespace touchline::decode
