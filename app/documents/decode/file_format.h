// What a file is, by its first bytes, and which worker may open which page of it.
// Threads: values and pure functions.
#pragma once

#include "app/isolation/sandbox/limits.h"
#include "config/types/choices.h"
#include "config/types/result.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// office: a document of a word processor, in any of its forms. archive: other files packed.
enum class FileFormat : std::uint8_t {
    unknown,
    png,
    jpeg,
    webp,
    tiff,
    gif,
    bmp,
    pnm,
    heif,
    svg,
    pdf,
    office,
    archive
};

/// What is known of a format besides its first bytes.
struct FormatFacts {
    FileFormat format = FileFormat::unknown;
    WorkerKind worker = WorkerKind::raster;  // the kind that opens it
    std::array<std::string_view, 15> endings =
        {};  // of the files that a stick offers; may be fewer
};

/// A new format has a row here, a signature in file_format.cpp and a reader. Drawn files (SVG, PDF)
/// need more libraries than pixels do; files of a video codec (HEIC, AVIF) need others, and
/// threads.
inline constexpr std::array file_formats{
    FormatFacts{FileFormat::png, WorkerKind::raster, {"png", "apng"}},
    FormatFacts{FileFormat::jpeg, WorkerKind::raster, {"jpg", "jpeg", "jpe", "jfif"}},
    FormatFacts{FileFormat::webp, WorkerKind::raster, {"webp"}},
    FormatFacts{FileFormat::tiff, WorkerKind::raster, {"tif", "tiff"}},
    FormatFacts{FileFormat::gif, WorkerKind::raster, {"gif"}},
    FormatFacts{FileFormat::bmp, WorkerKind::raster, {"bmp", "dib"}},
    FormatFacts{FileFormat::pnm, WorkerKind::raster, {"pnm", "pbm", "pgm", "ppm"}},
    FormatFacts{FileFormat::heif, WorkerKind::heif, {"heic", "heif", "avif", "hif"}},
    FormatFacts{FileFormat::svg, WorkerKind::document, {"svg", "svgz"}},
    FormatFacts{FileFormat::pdf, WorkerKind::document, {"pdf"}},
    // Its worker says that it cannot be opened.
    FormatFacts{FileFormat::office,
                WorkerKind::raster,
                {"doc", "docx", "docm", "odt", "rtf", "ppt", "pptx", "odp", "xls", "xlsx", "ods",
                 "odg", "numbers", "pages", "key"}}};

/// The format whose files end so, in small letters and without the dot; null for none.
[[nodiscard]] constexpr const FormatFacts* format_ending_in(std::string_view ending) {
    const auto* const found = std::ranges::find_if(file_formats, [ending](const auto& facts) {
        return std::ranges::find(facts.endings, ending) != facts.endings.end();
    });
    return ending.empty() || found == file_formats.end() ? nullptr : found;
}

/// The first bytes tell the format; a name tells nothing. O(1).
[[nodiscard]] FileFormat format_of(std::span<const std::byte> bytes);

struct PageOrder {
    int page = 1;               // 1 ... max_pages
    int dpi = 150;              // for documents without pixels of their own, 30 ... 600
    LanguageTag language = {};  // of an SVG's words, if it has them in several
};

/// The kind of worker that opens the file, by its first bytes.
[[nodiscard]] WorkerKind kind_of(std::span<const std::byte> bytes);

/// The program that opens files of a kind.
[[nodiscard]] std::string program_for(WorkerKind kind);

/// What a worker gets on its command line; work_in() reads the same back.
struct DecodeWork {
    WorkerKind kind = WorkerKind::raster;
    PageOrder order;
};

[[nodiscard]] std::vector<std::string> arguments_of(const DecodeWork& work);
[[nodiscard]] Result<DecodeWork> work_in(std::span<const std::string> arguments);

}  // namespace touchline
