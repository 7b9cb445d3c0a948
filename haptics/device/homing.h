// Homing that a blind person can do alone. The encoders have no index, so the board only knows
// where the handle is once it has been told at a known place. The hand goes to the home stop and
// rests, then to a second stop and rests; if the arms then read what they must, force may come. A
// unit that is homed for the first time is measured: from the second stop the hand also goes to the
// left, which tells a linkage from its mirror image, and visits the two stops twice. If a unit of
// another kind would read alike, a question answered with the handle tells them apart, or the place
// to the left if its links differ; if that tells nothing, the unit is refused. No force
// acts meanwhile. The program supplies the words for each step.
// Source: users' reports of Haply devices (wrong home poses, swapped plugs, encoders that turn the
// other way, scales off by per cent and by a fifth). Threads: plain values, one thread.
#pragma once

#include "config/types/calibration.h"
#include "config/types/vec2.h"
#include "haptics/pantograph/kinematics.h"
#include "haptics/pantograph/profile.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace touchline {

/// Measures how long the handle has been held still.
class Stillness {
  public:
    /// band > 0 (rad): a resting hand moves each joint by less, including its encoder's last count.
    explicit Stillness(JointAngles band) : band_(band) {}

    /// Advances one tick of dt_s. Angles that are not finite count as motion.
    void step(JointAngles angles, double dt_s) {
        const JointAngles moved = angles - middle_;
        const bool is_inside = std::abs(moved.x) <= band_.x && std::abs(moved.y) <= band_.y;
        if (!is_inside) middle_ = angles;
        still_s_ = is_inside ? still_s_ + dt_s : 0.0;
    }

    /// Counts anew from the next tick on.
    void start_again() { still_s_ = 0.0; }

    [[nodiscard]] double still_s() const { return still_s_; }

  private:
    JointAngles band_;
    JointAngles middle_;
    double still_s_ = 0.0;
};

/// Units of one kind, as far as two stops tell them from others. The reading between the stops is a
/// turn times a count, so a stop in another place, another encoder or other links may read alike.
struct KnownUnits {
    double turn_rad = 0.0;  // both joints together, from stop to stop
    double scale = 1.0;   // true turn over the turn that a board reports, driven as the chosen kind
    bool are_own = true;  // of the chosen kind
    bool are_straight = false;   // bent arms lie in one line at their stop
    bool have_own_links = true;  // as long as those of the chosen kind
    Geometry links;
    JointAngles at_check;  // rad, where the chosen kind has its check stop
};

/// Returns the units of the chosen kind first, then those of all other kinds but those that differ
/// neither in their links nor in their stops.
[[nodiscard]] std::vector<KnownUnits> known_units(
    const DeviceProfile& chosen, std::span<const DeviceProfile> kinds = device_profiles());

[[nodiscard]] double turn_of_both_rad(JointAngles turn);

/// Returns whether the turn read from stop to stop is at most 2.5 % off that of a unit of the
/// chosen kind and nearer to it than to any other with the same links, leaving aside units that a
/// question tells from it.
[[nodiscard]] bool is_of_kind(const std::vector<KnownUnits>& known, JointAngles read);

/// Whose links a unit has.
enum class LinksOf : std::uint8_t { chosen_kind, other_kind, either };

/// Tells a unit of other links that would read the same turn from stop to stop, and that no
/// question tells from the chosen kind, by a place where no arms of its links, or of the kind's,
/// could be. `turned` is the turn read from the check stop to that place.
[[nodiscard]] LinksOf links_of(const std::vector<KnownUnits>& known, JointAngles read,
                               JointAngles turned);

/// Returns whether a unit whose arms lie differently at their stop would read the same.
[[nodiscard]] bool needs_an_answer(const std::vector<KnownUnits>& known, JointAngles read);

/// Returns whether the arms of the chosen kind lie in one line.
[[nodiscard]] bool are_own_straight(const std::vector<KnownUnits>& known);

/// The two places at which the arms are stopped, and how finely the encoders read there.
struct HomingPlan {
    JointAngles home;     // rad
    JointAngles check;    // rad
    double arm_m = 0.0;   // motor axis to elbow, > 0: misfits are given as motion of the elbow
    JointAngles quantum;  // rad, of one encoder count
    // true: the home stop is the one with the arms stretched, which is alike on all units; false:
    // the check stop is.
    bool is_home_stretched = false;
    std::vector<KnownUnits> known;  // this kind, and all others
};

/// Makes the plan from the profile, or for the unit whose `stop_off` is given (rad).
[[nodiscard]] HomingPlan homing_plan(const DeviceProfile& profile, JointAngles stop_off = {});

enum class HomingStep : std::uint8_t {
    to_home,         // "go to the home stop and hold still"
    to_check,        // "now to the other stop"
    to_left,         // while a unit is measured: "now to the left"
    to_home_again,   // "once more home"
    to_check_again,  // "and once more to the other stop"
    to_answer,       // do bent arms lie in one line? Left means yes, right means no
    done,
};

/// Why the step is where it is. Say it when it changes.
enum class HomingRemark : std::uint8_t {
    none,
    silent,         // the board does not answer for half a second
    not_moved,      // half a minute where it was when the prompt began
    misfit,         // at rest, but not where the stop must be; move on to it
    not_left,       // at rest, but neither to the left nor to the right of the stop
    starting_over,  // it did not fit three times
    no_such_scale,  // the same, since no unit of this kind turns so far: perhaps it is another kind
    other_kind,     // the answer, or the place to the left, belongs to another kind
    either_kind,    // a kind with other links reads the same everywhere: no force would be right
    lost_count,     // the encoders lost counts: the results so far are worth nothing
    reversed,       // the stops came in the wrong order, or the plugs differ: once more
    replugged,      // a known unit reads differently than it did: it is measured anew
    measured,       // found this unit's scale, stops and plugs; store them
};

struct HomingView {
    HomingStep step = HomingStep::to_home;
    HomingRemark remark = HomingRemark::none;
    double held = 0.0;        // 0 ... 1: share of the stillness asked for
    double misfit_m = 0.0;    // at the elbows, in the last check
    double turn_share = 1.0;  // turn read between the stops, over the turn it must be
    int prompts = 0;          // changes whenever a prompt must be spoken, even the same one again
};

class Homing {
  public:
    /// `plan` comes from the profile. `stored` is this unit's calibration; a unit not measured
    /// before is measured now.
    Homing(const HomingPlan& plan, const Calibration& stored);

    /// Advances one tick of dt_s. `read` holds joint angles as bare() gives them, or nothing if the
    /// board does not answer. O(1), no allocation.
    HomingView step(const std::optional<JointAngles>& read, double dt_s);

    /// Counts were missed: starts from the beginning.
    void lose_count() { go(HomingStep::to_home, HomingRemark::lost_count); }

    /// The calibration to drive the board with meanwhile: the profile's encoders, offset 0, scale
    /// 1.
    [[nodiscard]] Calibration bare() const;

    /// The result, once the step is `done`; motors are not looked at.
    [[nodiscard]] const Calibration& calibration() const { return calibration_; }

  private:
    /// How well the turn read from stop to stop fits the turn it must be.
    struct Fit {
        Plugs encoders;         // on the ports where they were found, else on their own
        double scale = 1.0;     // the unit's scale, else the one that makes it fit
        double apart_m = 0.0;   // at the elbows, with that scale
        double misfit_m = 0.0;  // with the unit's scale, else the kind's
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
    void judge_links(JointAngles turn);
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
    JointAngles turned_left_;    // read, from the check stop
    Plugs encoders_;             // as they seem to be in this round
    double scale_ = 1.0;         // likewise
    std::optional<Plugs> seen_;  // difference from the profile in the round before
    Stillness stillness_;
    JointAngles prompted_at_;
    bool has_left_ = false;    // the place where it was when the prompt began
    bool is_prompted_ = true;  // a prompt was just spoken: the hand's motion counts from here
    double since_s_ = 0.0;     // since this prompt
    double silent_s_ = 0.0;
    int misses_ = 0;
    int reversals_ = 0;  // of a known unit, until it fits or is measured anew
    HomingView view_;
};

/// Tells whether the encoders have lost their place while a picture is felt: no unit passes its own
/// stops.
class DriftWatch {
  public:
    /// `plan` is the unit's.
    explicit DriftWatch(const HomingPlan& plan) : plan_(plan) {}

    /// Advances one tick of dt_s with calibrated angles. Returns true from 0.3 s beyond a stop on.
    /// Make a new watch once the handle is homed again.
    bool step(JointAngles angles, double dt_s);

  private:
    HomingPlan plan_;
    double beyond_s_ = 0.0;
    bool has_drifted_ = false;
};

}  // namespace touchline
