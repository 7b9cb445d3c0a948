// One sheet through CUPS, and nothing of it left there. Only touchline-print includes this.
// Threads: one of the process: libcups keeps the last error for each thread.
#pragma once

#include "app/printing/print_end.h"
#include "config/types/choices.h"

#include <cstddef>
#include <span>
#include <string>

namespace touchline {

inline bool goes_on() {
    return false;
}

/// How long each thing is waited for, in seconds, each > 0.
struct PrintPatience {
    double answer_s = 5.0;    // CUPS, for each answer
    double trouble_s = 8.0;   // a printer that wants paper or a hand, before the job is taken back
    double job_s = 180.0;     // the whole sheet
    double service_s = 10.0;  // a CUPS that is gone with a job of ours, and may come back
    double poll_s = 0.25;
    /// Asked at each poll. True: the program has to end, so the job is taken back at once, and a
    /// CUPS that is gone is not waited for.
    bool (*has_to_end)() = goes_on;
};

struct CupsQueue {
    std::string socket;  // the path of CUPS's own
    std::string name;
};

/// Sends the sheet, waits until the printer is done with it or cannot be, and removes the job from
/// CUPS's spool and history in every case in which CUPS still answers. What an earlier kiosk left
/// there goes first. `kind`: of the sheet; all but one for an embosser, whose bytes go to it as
/// they are, come out on one side, in their own size. The job's title tells nothing of the sheet.
/// Takes at most job_s, and then some answers.
[[nodiscard]] PrintEnd print_by_cups(const CupsQueue& queue, std::span<const std::byte> sheet,
                                     SheetKind kind, const PrintPatience& patience);

/// Says whether the queue is there and takes sheets, and removes the jobs of ours that are left.
[[nodiscard]] PrintEnd check_at_cups(const CupsQueue& queue, const PrintPatience& patience);

}  // namespace touchline
