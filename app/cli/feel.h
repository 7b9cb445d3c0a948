// touchline feel: a recorded or computed hand moves over a map, one servo step per row.
// Threads: one.
#pragma once

#include "config/types/result.h"
#include "haptics/contact/proxy_state.h"
#include "haptics/curve/curve_set.h"

#include <optional>
#include <string>

namespace touchline {

struct FeelOptions {
    std::string input;  // picture or map
    bool as_picture = false;
    std::string path;    // HAND.csv
    std::string output;  // RUN.csv
    std::string probe;   // a map of the held shape; empty: a point
    ContactSettings contact;
    CurveOptions curves;
    std::optional<double> level;  // none: auto
    std::string profile = "2diy-gen3.1";
    std::optional<int> budget_boxes;
    std::optional<double> deadline_us;
    bool with_timing = false;
};

/// Writes RUN.csv whole or not at all.
[[nodiscard]] Result<void> run_feel(const FeelOptions& options);

}  // namespace touchline
