// What a worker may take of the machine, by what it is for.
// Threads: constant data.
#pragma once

#include <cstddef>
#include <cstdint>

namespace touchline {

/// raster: one picture. heif: one picture of a film's codec (HEIC, AVIF), which has threads and
/// waits for them for ever where it gets none. document: SVG and PDF. ocr: words in a picture.
/// speech: one text to sound, for as long as somebody listens. pack: an archive, a recording or a
/// map of a picture pack. trace: the lines of a picture. figure: what a photograph shows, by
/// a network.
enum class WorkerKind : std::uint8_t { raster, heif, document, ocr, speech, pack, trace, figure };

inline constexpr int worker_kind_count = 8;

struct WorkerLimits {
    std::size_t input_bytes = 0;  // of the file
    std::size_t address_space_bytes = 0;
    unsigned cpu_s = 0;          // 0: no end; the process dies a second later
    std::size_t file_bytes = 0;  // that it can make its output grow to
    double deadline_s = 0.0;     // of the whole work, by the clock on the wall; 0: none
    bool has_threads = false;    // a codec needs them: most_worker_threads
    bool reads_fonts = false;    // the system's, while it draws
};

/// That a kind with threads can have, and all that its user starts meanwhile: a codec has one a
/// processor, and three more workers may begin beside it.
inline constexpr unsigned most_worker_threads = 64;

[[nodiscard]] constexpr WorkerLimits limits_of(WorkerKind kind) {
    constexpr std::size_t MiB = std::size_t{1} << 20U;
    switch (kind) {
        case WorkerKind::raster:
            return {.input_bytes = 200 * MiB,
                    .address_space_bytes = 1024 * MiB,
                    .cpu_s = 8,
                    .file_bytes = 200 * MiB,
                    .deadline_s = 10.0};
        case WorkerKind::heif:
            return {.input_bytes = 64 * MiB,
                    .address_space_bytes = 1536 * MiB,  // all of a picture, twice, and stacks
                    .cpu_s = 12,
                    .file_bytes = 200 * MiB,
                    .deadline_s = 15.0,
                    .has_threads = true};
        case WorkerKind::document:
            return {.input_bytes = 128 * MiB,
                    .address_space_bytes = 1024 * MiB,
                    .cpu_s = 8,
                    .file_bytes = 200 * MiB,
                    .deadline_s = 10.0,
                    .has_threads = true,  // Pango matches fonts so
                    .reads_fonts = true};
        case WorkerKind::ocr:
            return {.input_bytes = 200 * MiB,
                    .address_space_bytes = 1024 * MiB,
                    .cpu_s = 30,
                    .file_bytes = 16 * MiB,
                    .deadline_s = 40.0};
        case WorkerKind::speech:
            return {.input_bytes = MiB,
                    .address_space_bytes = 256 * MiB,
                    .cpu_s = 0,
                    .file_bytes = 0,  // it answers by its socket
                    .deadline_s = 0.0};
        case WorkerKind::pack:
            return {.input_bytes = 64 * MiB,
                    .address_space_bytes = 512 * MiB,
                    .cpu_s = 6,
                    .file_bytes = 112 * MiB,
                    .deadline_s = 8.0};
        case WorkerKind::trace:
            return {.input_bytes = 256 * MiB,
                    .address_space_bytes = 1024 * MiB,
                    .cpu_s = 8,
                    .file_bytes = 200 * MiB,
                    .deadline_s = 10.0,
                    .has_threads = true};
        case WorkerKind::figure:
            return {.input_bytes = 320 * MiB,
                    .address_space_bytes = 2048 * MiB,
                    .cpu_s = 60,
                    .file_bytes = 16 * MiB,
                    .deadline_s = 60.0,
                    .has_threads = true};
    }
    return {};
}

}  // namespace touchline
