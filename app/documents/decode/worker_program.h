// What the workers' programs share, and what those that decode make of a file: one page. The kiosk
// starts each for one piece of work; it closes its sandbox, and only then reads the first byte.
// Only they and tests decode. Threads: decoding any, no state is kept; a program has one.
#pragma once

#include "app/documents/decode/file_format.h"
#include "app/documents/decode/page.h"
#include "app/isolation/sandbox/limits.h"
#include "config/types/result.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace touchline {

struct WorkerProgram {
    WorkerKind kind = WorkerKind::raster;
    /// Runs before the sandbox closes, while only the system's files can be read; may be empty.
    std::function<void()> prepare;
    /// Turns its input into its answer. An error line becomes a refusal.
    std::function<Result<std::vector<std::byte>>(std::span<const std::byte>)> work;
};

/// Does not return.
[[noreturn]] void run_worker_program(const WorkerProgram& program);

/// Ends a program that the kiosk did not start.
[[noreturn]] void refuse_to_run(const char* program);

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

/// A program that decodes one page of one file.
struct Decoder {
    void (*prepare)() = nullptr;  // runs before the sandbox closes, reads only the system's files
    Result<Page> (*decode)(std::span<const std::byte> bytes, const PageOrder& order) = nullptr;
};

inline constexpr Decoder raster_decoder{nullptr, decode_raster};
inline constexpr Decoder heif_decoder{prepare_heif, decode_heif};
inline constexpr Decoder document_decoder{prepare_documents, decode_document};

/// The main() of a decoder. Does not return.
[[noreturn]] void run_decode_program(const Decoder& decoder, int argc, char** argv);

}  // namespace touchline
