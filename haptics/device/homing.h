// Homing that a person who cannot see does alone. The encoders have no index, so the board only
// knows where the handle is once it was told so at a known place. The hand goes to the home stop
// and rests; goes to a second stop and rests; if the arms read there what they must, force may
// come. A unit that is homed for the first time has its scale measured: the two stops are visited
// twice. No force acts meanwhile. Words for each step are the program's business. Source: users'
// reports of Haply devices (wrong home poses, swapped plugs, scales off by per cent). Threads:
// plain values, one thread.
#pragma once

#include "config/types/calibration.h"
#include "config/types/vec2.h"
#include "haptics/device/stillness.h"
#include "haptics/pantograph/profile.h"

#include <cstdint>
#include <optional>

namespace touchline {

/// The two places at which the arms are stopped, and how finely they are read there.
struct HomingPlan {
    JointAngles home;     // rad
    JointAngles check;    // rad
    double arm_m = 0.0;   // motor axis to elbow, > 0: misfits are told as motion of the elbow
    JointAngles quantum;  // rad, of one encoder count
};

[[nodiscard]] HomingPlan homing_plan(const DeviceProfile& profile);

enum class HomingStep : std::uint8_t {
    to_home,         // "go to the home stop and hold still"
    to_check,        // "now to the other stop"
    to_home_again,   // scale measured: "once more home"
    to_check_again,  // "and once more to the other stop"
    done,
};

/// Why the step is where it is, to be said when it changes.
enum class HomingRemark : std::uint8_t {
    none,
    silent,         // the board does not answer for half a second
    not_moved,      // half a minute where it was when the words began
    misfit,         // still, but not where the stop must be; move on to it
    starting_over,  // it did not fit three times
    lost_count,     // of the encoders: what was found is worth nothing
    reversed,       // the stops came the wrong way round, or the plugs are swapped: once more
    swapped,        // the arms answer for each other: the motor plugs are swapped; set the
                    // board up anew with the calibration as it is now, then go on
    measured,       // the scale of this unit was measured; it is to be stored
};

struct HomingView {
    HomingStep step = HomingStep::to_home;
    HomingRemark remark = HomingRemark::none;
    double held = 0.0;      // 0 ... 1: share of the stillness asked for
    double misfit_m = 0.0;  // of the elbows at the last check
    int prompts = 0;        // changes whenever words are to be said, be they the same again
};

class Homing {
  public:
    /// `stored`: of this unit; nothing when it was never homed.
    Homing(const HomingPlan& plan, const std::optional<Calibration>& stored);

    /// One tick of dt_s later: joint angles as bare() gives them, nothing when the board does not
    /// answer. O(1), no allocation.
    HomingView step(const std::optional<JointAngles>& read, double dt_s);

    /// Counts were missed: from the beginning.
    void lose_count() { go(HomingStep::to_home, HomingRemark::lost_count); }

    /// What the board is to be driven with meanwhile: offset 0, scale 1.
    [[nodiscard]] Calibration bare() const;

    /// What was found, once the step is `done`.
    [[nodiscard]] const Calibration& calibration() const { return calibration_; }

  private:
    void finish(HomingRemark remark);
    void miss_reading(double dt_s);
    void watch(JointAngles read, double dt_s);
    void rest(JointAngles read);
    void rest_at_home(JointAngles read);
    void rest_at_check(JointAngles read);
    void rest_at_home_again(JointAngles read);
    void go(HomingStep step, HomingRemark remark);
    void miss(double misfit_m);
    void cross();
    [[nodiscard]] double elbow_m(JointAngles turn) const;

    HomingPlan plan_;
    bool is_scale_known_;
    Calibration calibration_;
    JointAngles read_at_home_;
    JointAngles read_at_check_;
    Stillness stillness_;
    JointAngles prompted_at_;
    bool has_left_ = false;    // the place where it was when the words began
    bool is_prompted_ = true;  // words were just said: how far the hand moves counts from here
    double since_s_ = 0.0;     // these words
    double silent_s_ = 0.0;
    int misses_ = 0;
    int crossings_ = 0;  // in a row
    HomingView view_;
};

/// Whether the encoders have lost their place while a picture is felt: no unit passes its own
/// stops.
class DriftWatch {
  public:
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
