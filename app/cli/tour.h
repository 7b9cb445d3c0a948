// touchline tour: a simulated hand explores a picture or map on a simulated pantograph, through the
// production servo step, on a virtual clock. No display, and the same bits every time.
// Threads: one.
#pragma once

#include "app/cli/command_line.h"
#include "config/types/hand_state.h"
#include "config/types/result.h"
#include "haptics/collision/scene.h"

#include <string>
#include <vector>

namespace touchline {

/// One tick of a tour.
struct TourTick {
    HandState hand;
    bool is_lifted = false;  // between outlines, nothing to be felt
};

/// What a tour came to.
struct TourRun {
    std::vector<TourTick> ticks;
    double period_s = 0.0;
    int outlines = 0;  // in the map
    int visited = 0;   // outlines that the hand went to
    double contact_s = 0.0;
    double mean_force_N = 0.0;  // on the hand, while in contact
    double largest_force_N = 0.0;
};

/// A pen grip explores every outline of the map in wall mode, level by hand speed. `scene` must be
/// that of the map, its map_version not 0.
[[nodiscard]] TourRun take_tour(const TactileMap& map, const Scene& scene);

/// In words, a sentence or two a line.
[[nodiscard]] std::vector<std::string> describe_tour(const TourRun& run);

/// Writes the picture of the tour whole or not at all and prints what it came to.
[[nodiscard]] Result<void> run_tour(const TourArguments& arguments);

}  // namespace touchline
