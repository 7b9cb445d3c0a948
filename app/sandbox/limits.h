// What a worker may take of the machine, by what it is for.
// Threads: constant data.
#pragma once

#include <cstddef>
#include <cstdint>

namespace touchline {

/// raster: one picture. document: SVG and PDF. ocr: words in a picture. speech: text to sound, for
/// as long as the kiosk lives.
enum class WorkerKind : std::uint8_t { raster, document, ocr, speech };

inline constexpr int worker_kind_count = 4;

struct WorkerLimits {
    std::size_t input_bytes = 0;  // of the file
    std::size_t address_space_bytes = 0;
    unsigned cpu_s = 0;          // 0: no end; the process dies a second later
    std::size_t file_bytes = 0;  // that it can make its output grow to
    double deadline_s = 0.0;     // of the whole work, by the clock on the wall; 0: none
    bool has_threads = false;    // a codec needs them
};

[[nodiscard]] constexpr WorkerLimits limits_of(WorkerKind kind) {
    constexpr std::size_t MiB = std::size_t{1} << 20U;
    switch (kind) {
        case WorkerKind::raster:
            return {64 * MiB, 512 * MiB, 4, 200 * MiB, 6.0, false};
        case WorkerKind::document:
            return {128 * MiB, 1024 * MiB, 15, 200 * MiB, 20.0, true};  // Pango matches fonts so
        case WorkerKind::ocr:
            return {200 * MiB, 1024 * MiB, 30, 16 * MiB, 40.0, false};
        case WorkerKind::speech:
            return {MiB, 256 * MiB, 0, 64 * MiB, 0.0, false};
    }
    return {};
}

}  // namespace touchline
