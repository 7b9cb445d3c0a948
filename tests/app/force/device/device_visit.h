// An emulated board, its driver and a person who hears what is said, on one virtual clock.
#pragma once

#include "app/force/device/procedures.h"
#include "tests/app/force/device/person.h"
#include "tests/machines/sim/board/board_rig.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace touchline {

/// A clock that moves the rig's time on when somebody waits.
class RigClock final : public Clock {
  public:
    RigClock(VirtualTime& time, std::function<void()> after_wait)
        : time_(time), after_wait_(std::move(after_wait)) {}

    [[nodiscard]] std::int64_t now_ns() override { return std::llround(time_.now_s * 1e9); }

    void sleep_until(std::int64_t t_ns) override {
        time_.now_s = std::max(time_.now_s, 1e-9 * static_cast<double>(t_ns));
        after_wait_();
    }

  private:
    VirtualTime& time_;
    std::function<void()> after_wait_;
};

struct DeviceVisit {
    /// `kind`: the kind that the driver assumes; the unit's own profile if null.
    explicit DeviceVisit(const BoardTruth& truth = {}, const Calibration& stored = {},
                         const DeviceProfile* kind = nullptr)
        : person(std::make_shared<Person>(truth.profile)), rig(truth, {}, stored, person) {
        if (kind != nullptr) rig.connect({}, stored, kind);
    }

    Procedure procedure() {
        return {*rig.driver, clock, [this] { return !is_stop_wanted && rig.time.now_s < end_s; },
                [this](const std::string& words) {
                    person->hear(words, rig.time.now_s);
                    follow_hand();
                }};
    }

    /// Takes the handle or lets go of it, as the person wants.
    void follow_hand() {
        if (std::exchange(is_held, person->holds(rig.time.now_s)) == is_held) return;
        rig.board.grip(is_held ? rig.board.truth().hand : no_hand);
    }

    [[nodiscard]] bool was_heard(const std::string& what) const {
        return std::any_of(person->heard.begin(), person->heard.end(),
                           [&](const auto& line) { return line.find(what) != std::string::npos; });
    }

    /// The distance between the true tip and the driver's tip.
    [[nodiscard]] double tip_off_m() {
        const auto angles = rig.tick({});
        const Geometry& arms = rig.driver->frame().profile().geometry;
        const auto pose = angles ? forward(arms, *angles) : std::nullopt;
        const auto truly = forward(arms, rig.board.true_angles());
        return pose && truly ? norm(pose->p_DH - truly->p_DH) : 1.0;
    }

    std::shared_ptr<Person> person;
    BoardRig rig;
    RigClock clock{rig.time, [this] { follow_hand(); }};
    bool is_held = true;
    bool is_stop_wanted = false;
    double end_s = 1e9;
};

}  // namespace touchline
