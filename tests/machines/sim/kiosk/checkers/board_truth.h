// Checks that each motor makes what the servo told in one of its last ticks, or nothing. One motor
// alone may make nothing: the driver completes a cut send with zeros, before the zero of its
// resync.
#pragma once

#include "tests/machines/sim/kiosk/checkers/sight.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace touchline {

class BoardTruthChecker {
  public:
    void look(const TickSight& sight, Findings& findings) {
        if (sight.is_first_tick) told_ = {};
        if (sight.tick != nullptr) told_[next_++ % told_.size()] = sight.tick->torques;
        if (sight.tick == nullptr || sight.held == JointTorques{}) return;
        for (const JointTorques& told : told_)
            if (is_same(told, sight.held)) return;
        findings.demand(false, "board truth", sight.now_s, [&] {
            return fmt::format("motors make {:.5f} and {:.5f} N m, which no tick told",
                               sight.held.x, sight.held.y);
        });
    }

  private:
    static constexpr double duty_step_Nm = 0.123 / 1023.0;

    static bool is_same(double told_Nm, double held_Nm) {
        return held_Nm == 0.0 || std::abs(told_Nm - held_Nm) <= 1.5 * duty_step_Nm;
    }

    static bool is_same(JointTorques told, JointTorques held) {
        return is_same(told.x, held.x) && is_same(told.y, held.y);
    }

    // One command is on its way; a late reply holds the next one back for up to 5 ms.
    std::array<JointTorques, 8> told_{};
    std::size_t next_ = 0;
};

}  // namespace touchline
