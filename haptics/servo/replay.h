// Runs the ticks of a recording through the servo step again.
// Threads: any one.
#pragma once

#include "config/types/result.h"
#include "haptics/servo/recording.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace touchline {

struct Replay {
    std::size_t first = 0;                  // first tick of the recording that was run
    std::vector<TickRecord> ticks;          // with the outputs they have now
    std::optional<std::size_t> differs_at;  // first tick that is not the same, bit for bit
};

/// `scene_of` returns the scene of a version, built as it was then, or an error that says why it is
/// not available. Fails with one line if the recording holds no start, or if its start comes from
/// another build or does not fit its scene. O(ticks).
[[nodiscard]] Result<Replay> run_again(
    const Recording& recording,
    const std::function<Result<std::shared_ptr<const Scene>>(std::uint64_t version)>& scene_of);

}  // namespace touchline
