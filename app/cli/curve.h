// touchline curve: writes the multiresolution curve of a picture or map at one level, as a map.
// Threads: one.
#pragma once

#include "config/types/result.h"
#include "haptics/curve/curve_set.h"

#include <string>

namespace touchline {

struct CurveCommandOptions {
    std::string input;  // picture or map
    bool as_picture = false;
    std::string output;  // OUT.svg
    std::string report;  // REPORT.json; empty: none
    double level = 0.0;
    bool with_boxes = false;
    CurveOptions curves;
};

/// Writes the exact polylines that `feel --level` uses, one path per piece, and the report. Files
/// appear whole or not at all.
[[nodiscard]] Result<void> run_curve(const CurveCommandOptions& options);

}  // namespace touchline
