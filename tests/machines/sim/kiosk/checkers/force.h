// Checkers of the force: what is told to the motors, what they give the hand, and what becomes of a
// handle that nobody holds.
#pragma once

#include "tests/machines/sim/kiosk/checkers/sight.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace touchline {

/// Checks that no tick tells, and no motor makes, more than the device's limits allow, nor faster.
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

/// Checks what the device gave the hand, beyond what the hand gave it before: no spring stores
/// energy from one moment without force to the next, so the device made all of it.
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

/// Checks that a handle that nobody holds is not driven about, and not pushed for long.
class NoHandChecker {
  public:
    void look(const TickSight& sight, Findings& findings) {
        const double force_N = norm(sight.force_W);
        const bool is_driven =
            !sight.is_hand_on && force_N > driving_N && norm(sight.tip.velocity) > moving_m_per_s;
        driven_s_ = is_driven ? driven_s_ + tick_s : 0.0;
        pushed_s_ = !sight.is_hand_on && force_N > pushing_N ? pushed_s_ + tick_s : 0.0;
        findings.demand(driven_s_ <= longest_drive_s, "no hand", sight.now_s, [&] {
            return fmt::format("{:.2f} N drove a handle that nobody holds for {:.3f} s", force_N,
                               driven_s_);
        });
        findings.demand(pushed_s_ <= longest_push_s, "no hand", sight.now_s, [&] {
            return fmt::format("{:.2f} N pushed a handle that nobody holds for {:.1f} s", force_N,
                               pushed_s_);
        });
    }

  private:
    static constexpr double tick_s = 1e-3;
    static constexpr double driving_N = 0.7;  // less is within the noise of the encoders
    static constexpr double moving_m_per_s = 0.02;
    static constexpr double longest_drive_s = 0.15;  // 30 ms to tell, in windows of 10 ms, 50 ms to
                                                     // fade
    static constexpr double pushing_N = 0.55;
    static constexpr double longest_push_s = 20.2;

    double driven_s_ = 0.0;
    double pushed_s_ = 0.0;
};

}  // namespace touchline
