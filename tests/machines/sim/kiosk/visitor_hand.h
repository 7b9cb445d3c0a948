// The hand on the handle: it goes where its owner wants, trembles, is led, or homes the device as
// the words say. Threads: one.
#pragma once

#include "haptics/device/simulated/simulated_pantograph.h"
#include "tests/app/force/device/person.h"

#include <cmath>

namespace touchline {

class VisitorHand final : public IntendedPath {
  public:
    explicit VisitorHand(const DeviceProfile& profile) : person_(profile) {}

    [[nodiscard]] Intention at(double t_s) const override {
        if (is_homing_) return person_.at(t_s);
        Intention intention = course(t_s);
        if (tremor_m_ > 0.0) {
            const double turn = tremor_per_s_ * t_s;
            intention.position += Position{tremor_m_ * std::sin(turn), tremor_m_ * std::cos(turn)};
        }
        return intention;
    }

    /// Goes straight on from where it means to be now.
    void go(Position to, double speed_m_per_s, double now_s) {
        from_ = course(now_s).position;
        to_ = to;
        speed_m_per_s_ = speed_m_per_s;
        since_s_ = now_s;
    }

    /// Yields: it means to be where it is.
    void follow(Position here) { from_ = to_ = here; }

    [[nodiscard]] bool has_arrived(double now_s) const {
        return speed_m_per_s_ * (now_s - since_s_) >= norm(to_ - from_);
    }

    /// 0: no tremor.
    void tremble(double amplitude_m, double Hz) {
        tremor_m_ = amplitude_m;
        tremor_per_s_ = 2.0 * pi * Hz;
    }

    /// Hears the words of homing; empty words end it.
    void hear(const std::string& words, double now_s) {
        if (words.empty() && is_homing_) follow(person_.at(now_s).position);
        is_homing_ = !words.empty();
        if (is_homing_) person_.hear(words, now_s);
        person_.heard.clear();
    }

    /// Returns false while the words of homing have it let go.
    [[nodiscard]] bool holds(double now_s) const { return !is_homing_ || person_.holds(now_s); }

    [[nodiscard]] bool is_homing() const { return is_homing_; }

  private:
    static constexpr double pi = 3.14159265358979323846;

    [[nodiscard]] Intention course(double t_s) const {
        const Position way = to_ - from_;
        const double gone_m = speed_m_per_s_ * std::max(0.0, t_s - since_s_);
        const double length_m = norm(way);
        if (!(gone_m < length_m)) return {to_, {}};
        return {from_ + gone_m / length_m * way, along<Velocity>(way, speed_m_per_s_ / length_m)};
    }

    Person person_;
    Position from_, to_;
    double speed_m_per_s_ = 0.0;
    double since_s_ = 0.0;
    double tremor_m_ = 0.0;
    double tremor_per_s_ = 0.0;
    bool is_homing_ = false;
};

}  // namespace touchline
