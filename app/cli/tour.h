// touchline tour: a simulated hand explores a picture or map on a simulated pantograph, through the
// production servo step, on a virtual clock. It needs no display and gives the same bits every
// time.
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
    bool is_lifted = false;  // between outlines, nothing is felt
};

/// The result of a tour.
struct TourRun {
    std::vector<TourTick> ticks;
    double period_s = 0.0;
    int outlines = 0;  // how many the map has
    int visited = 0;   // how many the hand visited
    double contact_s = 0.0;
    double mean_force_N = 0.0;  // on the hand, while in contact
    double largest_force_N = 0.0;
};

/// A pen grip explores every outline of the map in wall mode, with the level set by hand speed.
/// `scene` must belong to the map, and its map_version must not be 0.
[[nodiscard]] TourRun take_tour(const TactileMap& map, const Scene& scene);

/// In words, a sentence or two per line.
[[nodiscard]] std::vector<std::string> describe_tour(const TourRun& run);

/// Writes the picture of the tour whole or not at all, and prints the result.
[[nodiscard]] Result<void> run_tour(const TourArguments& arguments);

}  // namespace touchline
