// A person who does what homing says.
#pragma once

#include "haptics/device/hand.h"
#include "haptics/pantograph/kinematics.h"
#include "haptics/pantograph/profile.h"

#include <algorithm>
#include <mutex>
#include <string>
#include <vector>

namespace touchline {

/// Goes where the words say, 0.15 m/s. Threads: hear() from one, at() from any.
class Person final : public IntendedPath {
  public:
    explicit Person(const DeviceProfile& profile)
        : home_(place(profile, profile.home)), check_(place(profile, profile.check.angles)) {
        from_ = to_ = 0.5 * (home_ + check_);
    }

    void hear(const std::string& words, double now_s) {
        Position to = to_;
        if (words.find("away from you") != std::string::npos) to = home_;
        if (words.find("towards you") != std::string::npos) to = check_;
        go(to, now_s);
        heard.push_back(words);
    }

    void go(Position to, double now_s) {
        const Position now = at(now_s).position;
        const std::lock_guard lock(mutex_);
        from_ = now;
        to_ = to;
        since_s_ = now_s;
    }

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
    static Position place(const DeviceProfile& profile, JointAngles angles) {
        return picture_from_device(profile, forward(profile.geometry, angles).value().p_DH);
    }

    mutable std::mutex mutex_;
    Position home_, check_, from_, to_;
    double since_s_ = 0.0;
};

}  // namespace touchline
