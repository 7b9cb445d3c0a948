// The way from a camera's still to a map, stage by stage.
#pragma once

#include <string>
#include <vector>

namespace touchline::bench {

/// Processor milliseconds of one thread, over all runs.
struct StageTime {
    std::string stage;
    double least_ms = 0.0;
    double median_ms = 0.0;
};

/// Makes a still of 12 megapixels, shapes before a rough background, as a JPEG of quality 90 as a
/// USB camera sends it. Decodes it, classes it, finds its lines and simplifies them at each detail.
/// The last row is the whole way at once. Needs at least one run.
[[nodiscard]] std::vector<StageTime> still_stages(int runs);

}  // namespace touchline::bench
