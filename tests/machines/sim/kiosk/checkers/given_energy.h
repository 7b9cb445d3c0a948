// Checks what the device gave the hand, beyond what the hand gave it before: no spring stores
// energy from one moment without force to the next, so the device made all of it.
#pragma once

#include "tests/machines/sim/kiosk/checkers/sight.h"

#include <algorithm>

#include <fmt/format.h>

namespace touchline {

class GivenEnergyChecker {
  public:
    void look(const TickSight& sight, SimFigures& figures, Findings& findings) {
        const Position moved = sight.tip.position - place_;
        place_ = sight.tip.position;
        const double work_J = dot(force_, moved);
        force_ = sight.force_W;
        // Guidance is meant to give energy; nobody answers for what a broken link holds.
        const bool is_begun_anew =
            sight.is_led || sight.is_send_hanging || norm(force_) < no_force_N;
        if (is_begun_anew) {
            since_s_ = sight.now_s;
            given_J_ = 0.0;
            return;
        }
        given_J_ += work_J;
        const double spans = std::max(1.0, sight.now_s - since_s_);
        figures.most_given_J = std::max(figures.most_given_J, given_J_ / spans);
        findings.demand(given_J_ <= most_J_per_s * spans, "given energy", sight.now_s, [&] {
            return fmt::format("{:.4f} J given in {:.3f} s", given_J_, sight.now_s - since_s_);
        });
    }

  private:
    static constexpr double no_force_N = 0.02;
    static constexpr double most_J_per_s = 0.05;

    Position place_;
    Force force_;
    double since_s_ = 0.0;  // last moment without force
    double given_J_ = 0.0;
};

}  // namespace touchline
