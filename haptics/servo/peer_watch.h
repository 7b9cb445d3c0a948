// How the servo and the kiosk know that the other is alive: by a count that goes up, and by how
// long it has not. Threads: plain values, one thread each; no clock.
#pragma once

#include <cstdint>

namespace touchline {

/// Says when a peer whose count should go up has been silent for too long. A long step counts for
/// at most longest_step_s: a pause of the whole machine is not the peer's fault.
class PeerWatch {
  public:
    PeerWatch(double silence_s, double longest_step_s)
        : silence_s_(silence_s), longest_step_s_(longest_step_s) {}

    /// Returns true while the peer is lost, which it is until its count first moves.
    [[nodiscard]] bool step(std::uint64_t beats, double dt_s);

  private:
    double silence_s_;
    double longest_step_s_;
    std::uint64_t beats_ = 0;
    double silent_s_ = 0.0;
    bool has_beaten_ = false;
};

/// A share of the force. It falls from 1 to 0 within fade_s once the force is wanted off, and is 1
/// again when it no longer is. A fade that has begun always ends at 0, so that the force comes back
/// by the arm rule.
class ForceShare {
  public:
    static constexpr double fade_s = 0.008;

    /// Returns the share, 0 ... 1.
    [[nodiscard]] double step(bool is_wanted_off, double dt_s);

  private:
    double share_ = 1.0;
};

}  // namespace touchline
