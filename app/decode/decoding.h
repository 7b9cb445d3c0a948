// What a worker makes of a file: one page. Only the workers' programs, inside the sandbox
// (app/sandbox), and tests call this.
// Threads: any; no state is kept.
#pragma once

#include "app/decode/file_format.h"
#include "app/decode/page.h"

#include <cstddef>
#include <span>

namespace touchline {

/// Decodes a picture of pixels. Only the first bytes tell the format, never a name. Transparency is
/// laid over white, 16 bits become 8, grey, palettes and CMYK become BGR, colours of another
/// profile become sRGB, an orientation is applied, a TIFF gives its first page, a GIF its first
/// picture. Fails with one line for anything empty, unknown, cut short, damaged or too large, or
/// for a page other than 1. O(bytes + pixels).
[[nodiscard]] Result<Page> decode_raster(std::span<const std::byte> bytes, const PageOrder& order);

/// The same for a picture of a video codec: HEIC, AVIF.
[[nodiscard]] Result<Page> decode_heif(std::span<const std::byte> bytes, const PageOrder& order);

/// Loads the codecs, which are files of their own since Debian 13 and could not be opened inside
/// the sandbox.
void prepare_heif();

/// Draws a page of an SVG or a PDF. Fails likewise.
[[nodiscard]] Result<Page> decode_document(std::span<const std::byte> bytes,
                                           const PageOrder& order);

/// Loads what the libraries of decode_document() read from files at their first use, which they
/// could not do inside the sandbox.
void prepare_documents();

}  // namespace touchline
