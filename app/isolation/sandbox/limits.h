// The limits of each kind of worker.
// Threads: constant data.
#pragma once

#include <array>
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

/// In the order of the kinds: input, memory, processor time, output, deadline, threads, fonts.
inline constexpr std::array<WorkerLimits, worker_kind_count> limits_of_kinds = [] {
    constexpr std::size_t MiB = std::size_t{1} << 20U;
    return std::array<WorkerLimits, worker_kind_count>{{
        {200 * MiB, 1024 * MiB, 8, 200 * MiB, 10.0, false, false},
        {64 * MiB, 1536 * MiB, 12, 200 * MiB, 15.0, true, false},  // all of it, twice, and stacks
        {128 * MiB, 1024 * MiB, 8, 200 * MiB, 10.0, true, true},   // Pango matches fonts in threads
        {200 * MiB, 1024 * MiB, 30, 16 * MiB, 40.0, false, false},
        {MiB, 256 * MiB, 0, 0, 0.0, false, false},  // speech answers on its socket
        {64 * MiB, 512 * MiB, 6, 112 * MiB, 8.0, false, false},
        {256 * MiB, 1024 * MiB, 8, 200 * MiB, 10.0, true, false},
        {320 * MiB, 2048 * MiB, 60, 16 * MiB, 60.0, true, false},
    }};
}();

/// Nothing is allowed for what is no kind.
[[nodiscard]] constexpr WorkerLimits limits_of(WorkerKind kind) {
    const auto index = static_cast<std::size_t>(kind);
    return index < limits_of_kinds.size() ? limits_of_kinds[index] : WorkerLimits{};
}

}  // namespace touchline
