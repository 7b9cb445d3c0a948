// Private to app/decode: a grey picture without its large lines (rings, frames, arrows). Tesseract
// takes them for large letters, and the words in them for parts of those.
// Threads: a pure function.
#pragma once

#include <memory>

#include <leptonica/allheaders.h>

namespace touchline::decode {

struct PixRelease {
    void operator()(Pix* pix) const { pixDestroy(&pix); }

    void operator()(Pixa* parts) const { pixaDestroy(&parts); }

    void operator()(Boxa* boxes) const { boxaDestroy(&boxes); }
};

using OwnedPix = std::unique_ptr<Pix, PixRelease>;

/// Lines that reach over a sixth of the longer side become white; what is filled stays. 8 bits a
/// pixel. Where memory ends the picture comes back as it is.
[[nodiscard]] OwnedPix without_shapes(OwnedPix grey);

}  // namespace touchline::decode
