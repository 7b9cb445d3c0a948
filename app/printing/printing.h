// The kiosk's side of a sheet to take home: a map goes in, and paper comes out of the site's
// printer. Nothing is written to a file.
// Threads: any, each call by itself; it waits for two programs, one after the other.
#pragma once

#include "app/isolation/process/descriptor.h"
#include "app/printing/print_end.h"
#include "config/types/choices.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <stop_token>
#include <string>

namespace touchline {

struct PrintOrder {
    std::string queue;  // of CUPS
    SheetKind kind = SheetKind::a4;
    std::string language;  // its code: of the words and of the braille
};

struct PrintPrograms {
    std::string sheet;         // the path of touchline-sheet
    std::string print;         // of touchline-print
    std::string words_folder;  // of catalogues
};

/// The sheet as CUPS takes it, sealed; made by a worker that is shut in.
[[nodiscard]] Result<Descriptor, PrintEnd> sheet_of(const TactileMap& map, const PrintOrder& order,
                                                    const PrintPrograms& programs);

/// Makes the sheet and prints it. Takes as long as the printer does, at most some four minutes.
/// Once `stop` is requested it returns `out_of_time`: within 0.1 s if the sheet is made, and the
/// program that prints ends by itself; else once it is made, and nothing is printed.
[[nodiscard]] PrintEnd print_map(const TactileMap& map, const PrintOrder& order,
                                 const PrintPrograms& programs, const std::stop_token& stop);

/// Whether the queue is there and takes sheets; removes what an earlier kiosk left in it. Some
/// milliseconds, at most some twenty seconds where CUPS hangs.
[[nodiscard]] PrintEnd check_printer(const std::string& queue, const PrintPrograms& programs,
                                     const std::stop_token& stop);

}  // namespace touchline
