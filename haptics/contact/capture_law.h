// The force of a line on a hand near it, by distance: the laws of groove, ridge and stay. Each is
// the gradient of a potential and ends smoothly at the capture width. Threads: pure functions.
#pragma once

#include "haptics/contact/proxy_state.h"

namespace touchline {

/// d: distance, w: capture width, K: stiffness.
///   groove  K d (1 - (d/w)^2)^2 towards the line, at most 0.287 K w
///   ridge   the same, away from it
///   stay    K d (1 - (d/w)^8) towards it: stiff nearly to the edge, at most 0.676 K w, so that
///           leaving takes a push
/// 0 from w on. At K 500 N/m and w 3 mm that is 0.43 N and 1.01 N at most.
class CaptureLaw {
  public:
    explicit CaptureLaw(const ContactSettings& settings)
        : mode_(settings.mode),
          stiffness_N_per_m_(settings.stiffness_N_per_m),
          capture_m_(settings.capture_m) {}

    [[nodiscard]] double capture_m() const { return capture_m_; }

    /// The steepest slope of the force over the distance: K, and 8 K where stay gives way.
    [[nodiscard]] double steepest_N_per_m() const {
        return (mode_ == Mode::stay ? 8.0 : 1.0) * stiffness_N_per_m_;
    }

    /// Returns the pull, positive towards the line. Zero if the distance or the capture width is
    /// NaN.
    [[nodiscard]] double pull_N(double distance_m) const {
        if (!(distance_m < capture_m_)) return 0.0;
        const double spring_N = stiffness_N_per_m_ * distance_m;
        const double rest = 1.0 - square_of_share(distance_m);
        if (mode_ == Mode::stay) {
            const double share_4 = (1.0 - rest) * (1.0 - rest);
            return spring_N * (1.0 - share_4 * share_4);
        }
        return (mode_ == Mode::ridge ? -1.0 : 1.0) * spring_N * rest * rest;
    }

    /// The law's potential, >= 0: it is 0 on the line of a groove, and where a ridge ends.
    [[nodiscard]] double energy_J(double distance_m) const {
        const double q = distance_m < capture_m_ ? square_of_share(distance_m) : 1.0;
        const double scale_J = stiffness_N_per_m_ * capture_m_ * capture_m_;
        if (mode_ == Mode::stay) return scale_J * (0.5 * q - 0.1 * q * q * q * q * q);
        const double rest = (1.0 - q) * (1.0 - q) * (1.0 - q);
        return scale_J / 6.0 * (mode_ == Mode::ridge ? rest : 1.0 - rest);
    }

  private:
    [[nodiscard]] double square_of_share(double distance_m) const {
        const double share = distance_m / capture_m_;
        return share * share;
    }

    Mode mode_;
    double stiffness_N_per_m_;
    double capture_m_;
};

}  // namespace touchline
