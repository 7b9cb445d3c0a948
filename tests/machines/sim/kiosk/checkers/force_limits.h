// Checks that no tick tells, and no motor makes, more than the device's limits allow, nor faster.
#pragma once

#include "tests/machines/sim/kiosk/checkers/sight.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace touchline {

class ForceLimitsChecker {
  public:
    explicit ForceLimitsChecker(const DeviceProfile& profile) : limits_(limits_of(profile)) {}

    void look(const TickSight& sight, SimFigures& figures, Findings& findings) {
        const double held_Nm = std::max(std::abs(sight.held.x), std::abs(sight.held.y));
        figures.most_torque_Nm = std::max(figures.most_torque_Nm, held_Nm);
        findings.demand(held_Nm <= limits_.torque_Nm * exactly, "force limits", sight.now_s, [&] {
            return fmt::format("a motor makes {:.5f} N m of {:.5f}", held_Nm, limits_.torque_Nm);
        });
        if (sight.tick == nullptr) return;
        const TickRecord& tick = *sight.tick;
        if (sight.is_first_tick) last_ = {};
        look_at_force(tick, sight.now_s, figures, findings);
        last_ = tick.force;
        was_saturated_ = is_saturated(tick);
    }

  private:
    static constexpr double exactly = 1.0 + 1e-9;
    static constexpr double tick_s = 1e-3;

    [[nodiscard]] bool is_saturated(const TickRecord& tick) const {
        const double most_Nm = std::max(std::abs(tick.torques.x), std::abs(tick.torques.y));
        return most_Nm >= limits_.torque_Nm * (1.0 - 1e-9);
    }

    void look_at_force(const TickRecord& tick, double now_s, SimFigures& figures,
                       Findings& findings) const {
        const double size_N = norm(tick.force);
        findings.demand(is_finite(tick.force) && is_finite(tick.torques), "force limits", now_s,
                        [] { return std::string("a force that is no number"); });
        figures.most_N = std::max(figures.most_N, size_N);
        figures.most_N_share = std::max(figures.most_N_share, size_N / limits_.force_N);
        findings.demand(size_N <= limits_.force_N * exactly, "force limits", now_s,
                        [&] { return fmt::format("{:.4f} N of {:.4f}", size_N, limits_.force_N); });
        const double rise_N = size_N - norm(last_);
        figures.most_rise_N_per_s = std::max(figures.most_rise_N_per_s, rise_N / tick_s);
        findings.demand(
            rise_N <= limits_.rise_N_per_s * tick_s * exactly, "force limits", now_s,
            [&] { return fmt::format("the force grew by {:.4f} N in a tick", rise_N); });
        // The force may leap when it ends, brakes a fast hand, or is fitted to what two motors can
        // make.
        const bool may_leap =
            size_N == 0.0 || tick.limit >= Limit::speed || is_saturated(tick) || was_saturated_;
        if (may_leap) return;
        const double change_N = norm(tick.force - last_);
        figures.most_change_N_per_s = std::max(figures.most_change_N_per_s, change_N / tick_s);
        findings.demand(
            change_N <= limits_.change_N_per_s * tick_s * exactly, "force limits", now_s,
            [&] { return fmt::format("the force changed by {:.4f} N in a tick", change_N); });
    }

    ForceLimits limits_;
    Force last_;
    bool was_saturated_ = false;
};

}  // namespace touchline
