// How printing a sheet ended: what the two programs of this folder and the kiosk tell each other.
// Threads: plain values and pure functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace touchline {

/// After a check alone, `printed` says that the queue is there and takes sheets.
enum class PrintEnd : std::uint8_t {
    printed,
    no_paper,
    needs_hand,   // jammed, a cover is open, ink or toner is empty
    offline,      // the printer is off, or its cable is out
    paused,       // the queue is stopped
    refused,      // the queue takes no sheets, or none of this kind
    unknown,      // CUPS has no such queue
    no_service,   // CUPS does not run, or may not be reached
    no_answer,    // CUPS stopped answering
    failed,       // the printer's own programs gave up, or somebody cancelled the job
    out_of_time,  // the printer took longer than a sheet can take
    not_removed,  // printed, but CUPS keeps the job
    not_cleared,  // nothing was printed: CUPS keeps jobs of before, and would keep this one
    no_sheet,     // no sheet could be made of the picture
    not_started,  // a program of ours is missing or refuses to work
};

inline constexpr int print_end_count = 15;

/// A sheet has far fewer.
inline constexpr std::size_t most_sheet_bytes = std::size_t{64} << 20U;

/// touchline-print's exit status: this and the PrintEnd; 2 for wrong words.
inline constexpr int first_print_status = 100;

[[nodiscard]] constexpr int print_status_of(PrintEnd end) {
    return first_print_status + static_cast<int>(end);
}

/// Nothing for a status that stands for no end.
[[nodiscard]] constexpr std::optional<PrintEnd> print_end_of(int status) {
    const int end = status - first_print_status;
    if (end < 0 || end >= print_end_count) return std::nullopt;
    return static_cast<PrintEnd>(end);
}

/// For the log and for whoever runs the kiosk: what, why and what to do, without a full stop.
[[nodiscard]] std::string_view line_of(PrintEnd end);

}  // namespace touchline
