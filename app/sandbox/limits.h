// The limits of each kind of worker.
// Threads: constant data.
#pragma once

#include <cstddef>
#include <cstdint>

namespace touchline {

/// raster: one picture. heif: one picture of a video codec (HEIC, AVIF), which has threads and
/// waits for them forever if it gets none. document: SVG and PDF. ocr: words in a picture. speech:
/// speaks one text, for as long as somebody listens. pack: an archive, a recording or a map of a
/// picture pack. trace: the lines of a picture. figure: what a photograph shows, by a network.
enum class WorkerKind : std::uint8_t { raster, heif, document, ocr, speech, pack, trace, figure };

inline constexpr int worker_kind_count = 8;

struct WorkerLimits {
    std::size_t input_bytes = 0;  // of the input file
    std::size_t address_space_bytes = 0;
    unsigned cpu_s = 0;          // 0: no limit; the process dies a second later
    std::size_t file_bytes = 0;  // to which it can make its output grow
    double deadline_s = 0.0;     // for the whole work, by the wall clock; 0: none
    bool has_threads = false;    // a codec needs them: most_worker_threads
    bool reads_fonts = false;    // the system's fonts, while it draws
};

/// The most threads of a kind that has threads, with everything that its user starts meanwhile: a
/// codec has one per processor, and three more workers may start beside it.
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
                    .has_threads = true,  // Pango needs them to match fonts
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
                    .file_bytes = 0,  // it answers on its socket
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
