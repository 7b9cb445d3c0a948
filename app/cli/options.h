// The command line of touchline. Stable: scripts rely on it (app/README.md lists it).
// Threads: one.
#pragma once

#include "config/types/result.h"

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

struct KioskArguments {
    bool in_window = false;           // false: full screen
    std::vector<std::string> files;   // pictures, and folders of them, to offer as a stick would
    std::optional<double> measure_s;  // run this long, print ticks and frames, and end
    /// A library of packs that is offered instead of the gallery and the user's packs; empty: none.
    std::string tried_library = {};
};

struct TourArguments {
    std::string input;  // picture or map
    bool as_picture = false;
    std::string output;  // RUN.png
};

/// The two commands that need more than files. main passes them in, so that everything else runs
/// without a display.
struct Programs {
    std::function<int(const KioskArguments&)> kiosk;
    std::function<Result<void>(const TourArguments&)> tour;
};

/// Exit status: 0 done, 1 the input could not be used (one line on `err`), 2 wrong usage.
[[nodiscard]] int run_command_line(const std::vector<std::string>& arguments,
                                   const Programs& programs, std::ostream& out, std::ostream& err);

}  // namespace touchline
