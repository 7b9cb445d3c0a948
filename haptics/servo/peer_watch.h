// What the servo and the kiosk know of each other's life: a count that goes up, and how long it has
// not. Threads: plain values, one thread each; no clock.
#pragma once

#include <cstdint>

namespace touchline {

/// Says when a peer whose count should go up has been silent for too long. A long step counts for
/// no more than longest_step_s: what stops the whole machine is no fault of the peer.
class PeerWatch {
  public:
    PeerWatch(double silence_s, double longest_step_s)
        : silence_s_(silence_s), longest_step_s_(longest_step_s) {}

    /// True while the peer is lost. From the start it is, until its count first moves.
    [[nodiscard]] bool step(std::uint64_t beats, double dt_s);

  private:
    double silence_s_;
    double longest_step_s_;
    std::uint64_t beats_ = 0;
    double silent_s_ = 0.0;
    bool has_beaten_ = false;
};

/// A share of the force, from 1 to 0 within fade_s once it is wanted off, and all of it again when
/// it no longer is. A fade that has begun ends at 0, so that the force always comes back by the arm
/// rule.
class ForceShare {
  public:
    static constexpr double fade_s = 0.008;

    /// 0 ... 1.
    [[nodiscard]] double step(bool is_wanted_off, double dt_s);

  private:
    double share_ = 1.0;
};

}  // namespace touchline
