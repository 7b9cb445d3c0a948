// Homing that a person who cannot see does alone. The encoders have no index, so the board only
// knows where the handle is once it was told so at a known place. The hand goes to the home stop
// and rests; goes to a second stop and rests; if the arms read there what they must, force may
// come. A unit that is homed for the first time is measured: from the second stop the hand also
// goes to the left, which tells a linkage from its mirror image, and the two stops are visited
// twice; where a unit of another kind would read alike, a question that is answered with the handle
// tells them apart. No force acts meanwhile. Words for each step are the program's business.
// Source: users' reports of Haply devices (wrong home poses, swapped plugs, encoders that turn the
// other way, scales off by per cent and by a fifth). Threads: plain values, one thread.
#pragma once

#include "config/types/calibration.h"
#include "config/types/vec2.h"
#include "haptics/device/known_units.h"
#include "haptics/device/stillness.h"
#include "haptics/pantograph/profile.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace touchline {

/// The two places at which the arms are stopped, and how finely they are read there.
struct HomingPlan {
    JointAngles home;     // rad
    JointAngles check;    // rad
    double arm_m = 0.0;   // motor axis to elbow, > 0: misfits are told as motion of the elbow
    JointAngles quantum;  // rad, of one encoder count
    // true: the home stop is the one with the arms stretched, which is alike on all units;
    // false: the check stop is
    bool is_home_stretched = false;
    std::vector<KnownUnits> known;  // of this kind, and others of the same links
};

/// As the profile has them, or as the unit does whose `stop_off` is given (rad).
[[nodiscard]] HomingPlan homing_plan(const DeviceProfile& profile, JointAngles stop_off = {});

enum class HomingStep : std::uint8_t {
    to_home,         // "go to the home stop and hold still"
    to_check,        // "now to the other stop"
    to_left,         // unit measured: "now to the left"
    to_home_again,   // "once more home"
    to_check_again,  // "and once more to the other stop"
    to_answer,       // whether bent arms lie in one line: yes to the left, no to the right
    done,
};

/// Why the step is where it is, to be said when it changes.
enum class HomingRemark : std::uint8_t {
    none,
    silent,         // the board does not answer for half a second
    not_moved,      // half a minute where it was when the words began
    misfit,         // still, but not where the stop must be; move on to it
    not_left,       // still, but neither to the left nor to the right of the stop
    starting_over,  // it did not fit three times
    no_such_scale,  // the same, for no unit of this kind turns so far: perhaps it is of another
    other_kind,     // the answer was that of another kind
    lost_count,     // of the encoders: what was found is worth nothing
    reversed,       // the stops came the wrong way round, or the plugs are otherwise: once more
    replugged,      // a known unit answers otherwise than it did: it is measured anew
    measured,       // scale, stops and plugs of this unit were found; they are to be stored
};

struct HomingView {
    HomingStep step = HomingStep::to_home;
    HomingRemark remark = HomingRemark::none;
    double held = 0.0;        // 0 ... 1: share of the stillness asked for
    double misfit_m = 0.0;    // of the elbows at the last check
    double turn_share = 1.0;  // of the turn that they must make between the stops, as they read
    int prompts = 0;          // changes whenever words are to be said, be they the same again
};

class Homing {
  public:
    /// `plan`: the profile's. `stored`: of this unit; it is measured unless it was.
    Homing(const HomingPlan& plan, const Calibration& stored);

    /// One tick of dt_s later: joint angles as bare() gives them, nothing when the board does not
    /// answer. O(1), no allocation.
    HomingView step(const std::optional<JointAngles>& read, double dt_s);

    /// Counts were missed: from the beginning.
    void lose_count() { go(HomingStep::to_home, HomingRemark::lost_count); }

    /// What the board is to be driven with meanwhile: encoders as the profile has them, offset 0,
    /// scale 1.
    [[nodiscard]] Calibration bare() const;

    /// What was found, once the step is `done`; motors are not looked at.
    [[nodiscard]] const Calibration& calibration() const { return calibration_; }

  private:
    /// How a turn from stop to stop reads as that which it must be.
    struct Fit {
        Plugs encoders;         // on the ports where they were found, else on their own
        double scale = 1.0;     // that of the unit, else the one that makes it fit
        double apart_m = 0.0;   // of the elbows, with that scale
        double misfit_m = 0.0;  // with that of the unit, else the kind's
    };

    void miss_reading(double dt_s);
    void watch(JointAngles read, double dt_s);
    void say_again();
    void lose_patience();
    void rest(JointAngles read);
    void rest_at_home(JointAngles read);
    void rest_at_check(JointAngles read);
    void check_known(const Plugs& fitting);
    void rest_at_left(JointAngles read);
    void rest_at_home_again(JointAngles read);
    void rest_at_check_again(JointAngles read);
    void rest_at_answer(JointAngles read);
    void measure();
    void advance(HomingStep step);
    void go(HomingStep step, HomingRemark remark);
    void miss(double misfit_m);
    void finish(HomingRemark remark);
    [[nodiscard]] double elbow_m(JointAngles turn) const;
    [[nodiscard]] JointAngles wanted_turn() const;
    [[nodiscard]] Fit fit_of(JointAngles turn) const;
    [[nodiscard]] bool does_fit(const Fit& fit, JointAngles turn) const;
    [[nodiscard]] std::optional<bool> is_left(JointAngles read) const;

    HomingPlan plan_;
    Calibration calibration_;
    JointAngles read_at_home_;
    JointAngles read_at_check_;
    Plugs encoders_;             // as they seem in this round
    double scale_ = 1.0;         // likewise
    std::optional<Plugs> seen_;  // what was otherwise than the profile in the round before
    Stillness stillness_;
    JointAngles prompted_at_;
    bool has_left_ = false;    // the place where it was when the words began
    bool is_prompted_ = true;  // words were just said: how far the hand moves counts from here
    double since_s_ = 0.0;     // these words
    double silent_s_ = 0.0;
    int misses_ = 0;
    int reversals_ = 0;  // of a known unit, until it fits or is measured anew
    HomingView view_;
};

/// Whether the encoders have lost their place while a picture is felt: no unit passes its own
/// stops.
class DriftWatch {
  public:
    /// Of the unit.
    explicit DriftWatch(const HomingPlan& plan) : plan_(plan) {}

    /// One tick of dt_s later, angles after calibration. True from 0.3 s beyond a stop on, until
    /// the handle is homed again: a new watch.
    bool step(JointAngles angles, double dt_s);

  private:
    HomingPlan plan_;
    double beyond_s_ = 0.0;
    bool has_drifted_ = false;
};

}  // namespace touchline
