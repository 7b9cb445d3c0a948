// A visit that runs in a picture of the house, lines being walls, and what the handle feels there:
// the force that the simulated motors make and the place where the tip truly is.
// Threads: one.
#pragma once

#include "tests/app/kiosk/blind_visitor.h"
#include "tests/app/kiosk/kiosk_world.h"

#include <string>

namespace touchline {

/// Files of pictures are read beforehand, so that time is the virtual clock's alone.
class WallWorld : public KioskWorld {
  public:
    WallWorld() : KioskWorld(false, gallery_without_workers()) {}
};

/// From the start of the house to the picture, by the visitor's keys.
void open_walls(KioskWorld& world, const std::string& picture);

/// The hand goes straight there, slowly enough for every limit of speed.
void lead_hand(KioskWorld& world, Position place_W);

struct FeltWall {
    double stiffness_N_per_m = 0.0;  // what more force more depth behind the proxy meets
    double most_force_N = 0.0;
};

/// A hand that pushes lightly, then means to be at `deep`, behind a wall; there it slides on by
/// `along`. Two pushes, for encoders that round down tell the whole wall half a step off; sliding
/// averages their steps. Then it goes back to where it was.
[[nodiscard]] FeltWall feel_wall(KioskWorld& world, Position deep, Position along);

}  // namespace touchline
