// The ticks of a recording run again through the servo step.
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
    std::size_t first = 0;                  // tick of the recording from which on it was run
    std::vector<TickRecord> ticks;          // as they came out now
    std::optional<std::size_t> differs_at;  // the first of them that is not the same, bit for bit
};

/// `scene_of` gives the scene of a version, built as it was then; nothing: it cannot be had, and
/// the error says why. Fails with one line where the recording holds no start, or one that another
/// build wrote or that does not fit its scene. O(ticks).
[[nodiscard]] Result<Replay> run_again(
    const Recording& recording,
    const std::function<Result<std::shared_ptr<const Scene>>(std::uint64_t version)>& scene_of);

}  // namespace touchline
