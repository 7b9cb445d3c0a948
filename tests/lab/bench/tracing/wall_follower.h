// A hand that follows a wall: it leans on it lightly, slides along, and goes round its ends.
// Threads: plain values. Deterministic.
#pragma once

#include "tests/lab/bench/tracing/follower.h"

#include <cstdint>

namespace touchline::bench {

/// Sweeps until something holds it back, follows that with the wall to its right until it comes to
/// where it has been, and sweeps on.
class WallFollower {
  public:
    WallFollower(const Area& area, Position start);

    /// Does one tick of dt_s > 0. Returns where the hand means to be.
    [[nodiscard]] Intention step(const Touched& touched, double dt_s);

    [[nodiscard]] bool is_on_line() const { return is_following_ && is_touching_; }

    [[nodiscard]] bool is_done() const { return !is_following_ && sweep_.is_over(); }

  private:
    void sweep(const Touched& touched, double dt_s);
    void follow(const Touched& touched, double dt_s);

    Sweep sweep_;
    FeltPath felt_;
    Position meant_;
    Position last_;
    Direction outward_{1.0, 0.0};  // from the wall, as felt
    bool is_following_ = false;
    bool is_touching_ = false;
    double followed_m_ = 0.0;
    double begun_m_ = 0.0;
    double known_m_ = 0.0;
    double lost_m_ = 0.0;
    double stuck_s_ = 0.0;
};

}  // namespace touchline::bench
