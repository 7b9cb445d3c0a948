// Somebody who draws for the visitor of a simulated site: lines, scribbles, dots, a pen that stays
// down, the eraser, and the keys of whoever draws. Threads: one.
#pragma once

#include "tests/machines/sim/kiosk/kiosk_life.h"
#include "tests/machines/sim/kiosk/plan.h"

#include <cstdint>
#include <vector>

namespace touchline {

class SimDrawer {
  public:
    explicit SimDrawer(std::uint64_t seed) : dice_(seed) {}

    /// Acts for one frame.
    void act(KioskLife& life, double now_s);

    /// Strokes that were lifted.
    [[nodiscard]] std::uint64_t strokes() const { return strokes_; }

  private:
    void begin(KioskLife& life, double now_s);
    void begin_stroke(KioskLife& life);
    void go_on(KioskLife& life, double now_s);
    [[nodiscard]] Position somewhere();

    Dice dice_;
    std::vector<Position> way_;  // corners still to go to; empty: the pen is up
    Position at_W_;
    double speed_m_per_s_ = 0.1;
    double moved_s_ = 0.0;
    double next_s_ = 0.0;
    std::uint64_t strokes_ = 0;
};

}  // namespace touchline
