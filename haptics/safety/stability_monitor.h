// Watches whether the loop rings, and softens the wall until it does not. Changes the stiffness
// under the hand in ramps, and books their energy. Threads: one, the servo's. Plain values; no
// allocation.
#pragma once

#include "config/types/vec2.h"

#include <cstdint>

namespace touchline {

struct MonitorLimits {
    double ripple_N = 0.1;   // rms of a force that swings to and fro at 20 to 300 Hz, three times
                             // in 0.1 s, while the loop gives ...
    double ripple_W = 2e-4;  // ... more than this to the hand: texture that is scanned takes
    double energy_J = 0.01;  // given to the hand beyond what the spring held, forgotten in 1 s: a
                             // sound loop comes to 3 mJ, but for hits from 1 m/s on
};

enum class Ringing : std::uint8_t { none, ripple, energy };

/// The spring's gain, 1 while all is well. A cut halves it within 20 ms, at most every 0.1 s and
/// not below an eighth; it comes back by 5 % of the whole a second.
class StabilityMonitor {
  public:
    explicit StabilityMonitor(const MonitorLimits& limits = {}) : limits_(limits) {}

    struct Tick {
        Force force;               // on the hand, after all limits
        Position moved;            // the handle since the tick before
        double stored_J = 0.0;     // in the spring now
        bool is_continued = true;  // false: contact was dropped, nothing is to be compared
        double turning_J = 0.0;    // given to the hand by a torque, since the tick before
    };

    /// `dt_s` > 0. A tick that is not finite or not continued starts the watch anew but keeps the
    /// gain. Returns the gain to use.
    double step(const Tick& tick, double dt_s);

    [[nodiscard]] double gain() const { return gain_; }

    /// Why the last cut was made.
    [[nodiscard]] Ringing cause() const { return cause_; }

    [[nodiscard]] std::uint64_t cuts() const { return cuts_; }

  private:
    void begin_anew();
    void count_swings(Force ripple, double dt_s);
    [[nodiscard]] Ringing found() const;
    void cut(Ringing cause);

    MonitorLimits limits_;
    Force force_;  // of the tick before
    double stored_J_ = 0.0;
    bool has_before_ = false;
    Force slow_;             // force below 20 Hz
    Force fast_;             // force below 300 Hz
    Force rest_;             // of that beyond slow_, what is below 20 Hz still
    Force swing_;            // the last swing of the ripple that was large enough
    double swings_ = 0.0;    // to and fro, forgotten in 0.1 s
    double recent_J_ = 0.0;  // given to the hand, forgotten in 0.1 s
    double generated_J_ = 0.0;
    double since_cut_s_ = 1.0;
    double goal_ = 1.0;
    double gain_ = 1.0;
    Ringing cause_ = Ringing::none;
    std::uint64_t cuts_ = 0;
};

/// A wall that gets stiffer does work on a hand that presses it, so stiffness rises by at most 5 %
/// of itself a second. It falls so fast that the hand loses 15 N a second: at once if nothing
/// presses.
class StiffnessRamp {
  public:
    explicit StiffnessRamp(double stiffness_N_per_m) : stiffness_N_per_m_(stiffness_N_per_m) {}

    /// Advances one tick towards `wanted_N_per_m` with the spring stretched by depth_m. Values that
    /// are not finite or not positive change nothing. Returns the stiffness to use.
    double step(double wanted_N_per_m, double depth_m, double dt_s);

    [[nodiscard]] double stiffness_N_per_m() const { return stiffness_N_per_m_; }

    /// The energy that the changes have put into the spring so far: the sum of 1/2 dK depth^2.
    [[nodiscard]] double booked_J() const { return booked_J_; }

  private:
    double stiffness_N_per_m_;
    double booked_J_ = 0.0;
};

}  // namespace touchline
