// Makes the level of resolution follow the hand's speed, or that of the fastest point of a shape in
// it: coarse while the hand is fast, fine while it is slow. A detail of wavelength lambda crossed
// at speed v is a force of frequency v / lambda; the rule leaves out what is faster than the servo,
// the device and the hand can follow (paper, sections 1 and 5). Other terms bound the level:
// device, proxy, time, perception, topology and the operator. Threads: one, the servo's. No
// allocation, no clock.
#pragma once

#include "config/types/level_terms.h"
#include "config/types/vec2.h"
#include "haptics/contact/contact_machine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace touchline {

/// Holds the peaks of ten slots and of the running one: the window is ten to eleven slots long,
/// whatever the distance between values.
class PeakHold {
  public:
    static constexpr std::size_t slots = 10;

    /// slot > 0, in the unit of `advance` below.
    explicit PeakHold(double slot) : slot_(slot) {}

    /// Adds a value >= 0 that came `advance` > 0 after the one before. Returns the largest in the
    /// window; NaN is ignored.
    double step(double value, double advance) {
        age_ += advance;
        if (age_ >= slot_) begin_slots();
        peaks_[newest_] = std::max(peaks_[newest_], value);
        return std::max(older_, peaks_[newest_]);
    }

    /// Whether a copy made from bytes may be stepped.
    [[nodiscard]] bool is_sound() const { return newest_ < peaks_.size() && slot_ > 0.0; }

  private:
    /// A long advance may outlast several slots; each is emptied as it begins.
    void begin_slots() {
        for (std::size_t i = 0; age_ >= slot_ && i <= slots; ++i) {
            age_ -= slot_;
            newest_ = (newest_ + 1) % peaks_.size();
            peaks_[newest_] = 0.0;
        }
        age_ = std::min(age_, slot_);
        older_ = *std::max_element(peaks_.begin(), peaks_.end());
    }

    double slot_;
    double age_ = 0.0;                       // of the running slot
    std::array<double, slots + 1> peaks_{};  // of the running slot and the ten before it
    std::size_t newest_ = 0;
    double older_ = 0.0;  // largest of the ten
};

/// The inputs of all terms except speed.
struct LevelLimits {
    double spacing_m = 1e-4;       // h0: point spacing of level 0, > 0
    double encoder_step_m = 1e-4;  // smallest motion of the tip that the device can tell, >= 0
    double f_device_Hz = 100.0;    // bandwidth of the device
    double finest = 0.0;           // the operator's bounds; both the same: a fixed level
    double coarsest = 16.0;
    double radius_m = 0.0;  // of the proxy
    double percept = 0.0;   // percept_level() of the curves
    double safe = 16.0;     // coarsest level at which the outlines lie to each other as at level 0
    double cost = 0.0;      // CostTerm

    friend bool operator==(const LevelLimits&, const LevelLimits&) = default;
};

/// Returns the shortest wavelength that level l carries: four points, lambda_l = 4 h0 2^l.
[[nodiscard]] double wavelength_m(const LevelLimits& limits, double level);

/// Returns the highest detail frequency worth rendering: min(f_s / 10, f_device, 100 Hz), f_s = 1 /
/// dt.
[[nodiscard]] double highest_detail_Hz(const LevelLimits& limits, double dt_s);

/// Returns log2(v / (f_max lambda_0)): the level at which v crosses details at exactly f_max;
/// negative for a slow hand. l_speed is the next whole level above.
[[nodiscard]] double speed_level(const LevelLimits& limits, double speed_m_per_s, double dt_s);

/// Returns l_encoder: the finest level whose spacing the encoders can tell, lambda_l >= 4 Delta.
[[nodiscard]] double encoder_level(const LevelLimits& limits);

/// Returns l_radius: the finest level whose spacing is at least an eighth of the proxy's radius; a
/// disc rolls over anything finer.
[[nodiscard]] double radius_level(const LevelLimits& limits);

/// Returns how much of a new velocity enters the 10 Hz low-pass after dt_s.
[[nodiscard]] double low_pass_share(double dt_s);

/// The hand's speed as the rule sees it: the largest |10 Hz low-pass of v| of the last half second,
/// so that a tremor does not switch levels. Starts at rest.
class SpeedMeasure {
  public:
    /// Takes the handle's position after dt_s > 0. Returns the square of the held speed in m^2/s^2:
    /// a root at every tick would cost as much as all the rest.
    double step(Position handle, double dt_s);

    /// Whether a copy made from bytes may be stepped.
    [[nodiscard]] bool is_sound() const { return peak_.is_sound(); }

  private:
    void set_period(double dt_s);

    double dt_s_ = 0.0;
    double per_dt_Hz_ = 0.0;
    double share_ = 0.0;  // of a new velocity in the low-pass
    Position last_;
    bool has_last_ = false;
    Velocity low_pass_;
    PeakHold peak_{0.05};  // seconds a slot; squared speeds
};

/// Combines all terms by choose_level(). The speed term is whole and changes with hysteresis: it
/// coarsens at once, and refines a quarter of an octave later than it coarsened and not within 150
/// ms of its last change. All other terms act at once.
class LevelRule {
  public:
    explicit LevelRule(const LevelLimits& limits);

    /// Advances one servo tick; dt_s > 0. Returns the wanted level.
    double step(Position handle, double dt_s);

    /// The same if the speed is measured elsewhere: takes its square, >= 0.
    double step_at(double speed2_m2_per_s2, double dt_s);

    /// Acts on level() at once. Unchanged limits cost only a comparison.
    void set_limits(const LevelLimits& limits);

    [[nodiscard]] double level() const { return level_; }

    [[nodiscard]] const LevelTerms& terms() const { return terms_; }

    [[nodiscard]] double speed_m_per_s() const { return std::sqrt(speed2_m2_per_s2_); }

    /// Whether a copy made from bytes may be stepped.
    [[nodiscard]] bool is_sound() const { return measure_.is_sound(); }

  private:
    void adopt_limits();
    void update_speed_term(double dt_s);
    void set_thresholds(double dt_s);

    LevelLimits limits_;
    LevelTerms terms_;
    double level_ = 0.0;
    double dt_s_ = 0.0;  // the period that the thresholds are for; 0: none yet
    // Between these speeds, squared, the speed term stays as it is.
    double refine_below_m2_per_s2_ = 0.0;
    double coarsen_above_m2_per_s2_ = 0.0;
    SpeedMeasure measure_;
    double speed2_m2_per_s2_ = 0.0;
    double since_change_s_ = 1.0;
};

/// The speed of a shape's fastest point as the rule sees it: at most |v| + |w| r, both after a 10
/// Hz low-pass, and the largest of the last half second.
class ShapeSpeed {
  public:
    /// `r_max_m` >= 0 is the largest distance of the shape's points from the point that the hand
    /// holds.
    explicit ShapeSpeed(double r_max_m) : r_max_m_(r_max_m) {}

    /// Takes the handle's position and angle after dt_s > 0. Returns the square of the held speed
    /// in m^2/s^2.
    double step(Position handle, double angle_rad, double dt_s);

  private:
    double r_max_m_;
    Position last_;
    double last_angle_rad_ = 0.0;
    bool has_last_ = false;
    Velocity low_pass_;
    double low_pass_rad_per_s_ = 0.0;
    PeakHold peak_{0.05};  // seconds a slot; squared speeds
};

/// LevelRule at that speed.
class ShapeLevelRule {
  public:
    ShapeLevelRule(const LevelLimits& limits, double r_max_m) : rule_(limits), speed_(r_max_m) {}

    /// Advances one servo tick; dt_s > 0. Returns the wanted level. A pose that is not finite
    /// changes nothing.
    double step(Position handle, double angle_rad, double dt_s) {
        if (!is_finite(handle) || !std::isfinite(angle_rad) || !(dt_s > 0.0)) return rule_.level();
        return rule_.step_at(speed_.step(handle, angle_rad, dt_s), dt_s);
    }

    void set_limits(const LevelLimits& limits) { rule_.set_limits(limits); }

    [[nodiscard]] double speed_m_per_s() const { return rule_.speed_m_per_s(); }

  private:
    LevelRule rule_;
    ShapeSpeed speed_;
};

// l_cost: the finest level that the tick has time for. It comes from counted work, not from time,
// so that a run can be repeated.

/// The work of one tick's contact.
struct Work {
    int boxes = 0;        // opened
    bool is_cut = false;  // a limit of the step ended it: part of the motion is carried over
};

[[nodiscard]] Work work_of(const ContactReport& report);

/// Returns the number of boxes worth three tenths of a period, the share of a tick that contact may
/// take.
[[nodiscard]] int affordable_boxes(double period_s);

/// Coarsens at once to the level above the rendered one if a tick took more than is affordable, or
/// if each of the last four was cut, however few boxes they opened. What a single tick leaves over,
/// the next one makes up. Refines one level at a time, after at least half a second, and only if
/// none of the last 64 ticks was cut and the largest of them stays affordable if each finer level
/// takes twice the work of the one above. If a refinement does not last, the next waits twice as
/// long, up to 8 s.
class CostTerm {
  public:
    /// period_s > 0 is the servo's.
    explicit CostTerm(double period_s);

    /// Advances one tick. The work was done at `rendered_level`, since a change of level may take
    /// several ticks. Returns level().
    double step(const Work& work, double rendered_level);

    /// The level for the next tick: whole, >= 0. A level coarser than the scene's coarsest means
    /// that not even that one is affordable.
    [[nodiscard]] double level() const { return level_; }

    /// Whether a copy made from bytes may be stepped.
    [[nodiscard]] bool is_sound() const { return recent_.is_sound(); }

  private:
    void coarsen(double rendered_level);
    void refine();
    [[nodiscard]] bool can_refine(double most_boxes, double rendered_level) const;

    double period_s_;
    double affordable_;  // boxes a tick
    PeakHold recent_;    // boxes
    double level_ = 0.0;
    double wait_s_;  // before the next refinement
    double since_change_s_ = 0.0;
    bool is_refined_ = false;  // by the last change
    int cut_in_a_row_ = 0;     // ticks, since the last change
};

}  // namespace touchline
