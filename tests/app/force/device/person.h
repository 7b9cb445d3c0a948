// A person who does what homing says.
#pragma once

#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/pantograph/kinematics.h"
#include "haptics/pantograph/profile.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string>
#include <vector>

namespace touchline {

/// Goes where the words say, at 0.15 m/s. Threads: hear() from one, the rest from any.
class Person final : public IntendedPath {
  public:
    /// `unit`: has the true stops.
    explicit Person(const DeviceProfile& unit)
        : home_(place(unit, unit.home)),
          check_(place(unit, unit.check.angles)),
          home_place_(unit.home_place),
          check_place_(unit.check.place),
          is_bent_straight_(is_straight(unit)) {
        from_ = to_ = 0.5 * (home_ + check_);
    }

    void hear(const std::string& words, double now_s) {
        const auto is_said = [&](const char* what) {
            return words.find(what) != std::string::npos;
        };
        Position to = to_;
        if (is_said("away from you")) to = stop(StopPlace::away);
        if (is_said("towards you")) to = stop(StopPlace::towards);
        if (is_said("straight to the sides")) to = stop(StopPlace::sideways);
        if (is_said("to the left")) to = takes_right_for_left_ ? right : left;
        if (is_said("one straight line"))
            to = is_bent_straight_ == takes_right_for_left_ ? right : left;
        if (is_said("middle")) to = {};
        go(to, now_s);
        const std::lock_guard lock(mutex_);
        lets_go_ = is_said("et go");
        heard.push_back(words);
    }

    void go(Position to, double now_s) {
        const Position now = at(now_s).position;
        const std::lock_guard lock(mutex_);
        from_ = now;
        to_ = to;
        since_s_ = now_s;
        lets_go_ = false;
    }

    /// Returns false once the person has come to where the words said to let go.
    [[nodiscard]] bool holds(double now_s) const {
        const std::lock_guard lock(mutex_);
        return !lets_go_ || 0.15 * (now_s - since_s_) < norm(to_ - from_) + 0.05;
    }

    /// From now on confuses left and right.
    void mistake_left() { takes_right_for_left_ = true; }

    [[nodiscard]] Intention at(double t_s) const override {
        const std::lock_guard lock(mutex_);
        const Position way = to_ - from_;
        const double gone_m = 0.15 * std::max(0.0, t_s - since_s_);
        if (gone_m >= norm(way)) return {to_, {}};
        return {from_ + along<Position>(direction_of(way), gone_m),
                along<Velocity>(direction_of(way), 0.15)};
    }

    std::vector<std::string> heard;

  private:
    static constexpr Position left{-0.045, 0.0}, right{0.045, 0.0};

    /// Arms that lie straight on each other have no pose: the hand then leans out beyond their
    /// reach.
    static Position place(const DeviceProfile& unit, JointAngles angles) {
        const auto pose = forward(unit.geometry, angles);
        const double reach_m = unit.geometry.proximal_m + unit.geometry.distal_m;
        const Position out{0.5 * unit.geometry.base_m, reach_m + 1e-3};
        return picture_from_device(unit, pose ? pose->p_DH : out);
    }

    /// Returns true if the bent arms feel straight to fingers at their stop.
    static bool is_straight(const DeviceProfile& unit) {
        const bool is_home = unit.home_place != StopPlace::towards;
        return (is_home ? unit.home : unit.check.angles).x > 3.09;
    }

    [[nodiscard]] Position stop(StopPlace place) const {
        return place == home_place_ ? home_ : place == check_place_ ? check_ : to_;
    }

    mutable std::mutex mutex_;
    Position home_, check_, from_, to_;
    StopPlace home_place_, check_place_;
    bool is_bent_straight_;
    double since_s_ = 0.0;
    bool lets_go_ = false;
    bool takes_right_for_left_ = false;
};

}  // namespace touchline
