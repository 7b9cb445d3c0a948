// A visit in a picture of the gallery whose lines are walls, and what the handle feels there: the
// force that the simulated motors make and the true place of the tip. Threads: one.
#pragma once

#include "tests/app/kiosk/blind_visitor.h"
#include "tests/app/kiosk/kiosk_world.h"

#include <string>

namespace touchline {

/// A kiosk that reads the files of pictures beforehand, so that only the virtual clock passes time.
class WallWorld : public KioskWorld {
  public:
    WallWorld() : KioskWorld(false, gallery_without_workers()) {}
};

/// Goes from the start of the kiosk to the picture, by the visitor's keys.
void open_walls(KioskWorld& world, const std::string& picture);

/// Moves the hand straight there, slowly enough for every speed limit.
void lead_hand(KioskWorld& world, Position place_W);

struct FeltWall {
    double stiffness_N_per_m = 0.0;  // added force over added depth behind the proxy
    double most_force_N = 0.0;
};

/// The hand pushes lightly, then aims for `deep`, behind a wall; both times it slides on by
/// `along`. It pushes twice because encoders that round down place the whole wall half a step off;
/// sliding averages their steps. Then the hand goes back to where it was.
[[nodiscard]] FeltWall feel_wall(KioskWorld& world, Position deep, Position along);

}  // namespace touchline
