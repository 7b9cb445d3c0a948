// What a worker makes of a file: one page. Only its programs call this, shut in (app/sandbox), and
// tests.
// Threads: any; no state is kept.
#pragma once

#include "app/decode/page.h"
#include "app/decode/page_order.h"

#include <cstddef>
#include <span>

namespace touchline {

/// A picture of pixels. The format is told by the first bytes, never by a name. Transparency lies
/// over white, 16 bits become 8, grey, palettes and CMYK become BGR, colours of another profile
/// become sRGB, an orientation is applied, a TIFF gives its first page, a GIF its first picture.
/// Fails with one line for anything empty, unknown, cut short, damaged, too large, or with another
/// page than 1. O(bytes + pixels).
[[nodiscard]] Result<Page> decode_raster(std::span<const std::byte> bytes, const PageOrder& order);

/// Likewise a picture that a codec of films made: HEIC, AVIF.
[[nodiscard]] Result<Page> decode_heif(std::span<const std::byte> bytes, const PageOrder& order);

/// Loads the codecs, which are files of their own since Debian 13: shut in they could not be
/// opened.
void prepare_heif();

/// A page of what is drawn: SVG, PDF. Fails likewise.
[[nodiscard]] Result<Page> decode_document(std::span<const std::byte> bytes,
                                           const PageOrder& order);

/// Loads what the libraries of decode_document() read from files at their first use: shut in they
/// could not.
void prepare_documents();

}  // namespace touchline
