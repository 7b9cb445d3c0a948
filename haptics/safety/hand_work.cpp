#include "haptics/safety/hand_work.h"

namespace touchline {
namespace {

// A hand explores at less than 3 Hz. Shaking is faster, and its work back and forth would count as
// a hand's wherever the force comes late.
constexpr double smoothing_s = 0.15;
constexpr double settling_s = 0.5;  // after a disturbance
constexpr double stroke_m = 0.002;
constexpr double longest_stroke_s = 2.0;
constexpr double hands_share = 0.5;  // of the work of friction: half of it is an estimate's error
constexpr double together_s = 3.0;

}  // namespace

void HandWork::step(Force force, Position position, double dt_s) {
    if (!is_finite(force) || !is_finite(position) || !(dt_s > 0.0)) return;
    calm_s_ += dt_s;
    since_s_ += dt_s;
    stroke_s_ += dt_s;
    const double share = dt_s / (dt_s + smoothing_s);
    const Position moved = share * (position - place_);
    place_ += moved;
    force_ += share * (force - force_);
    given_J_ += dot(force_, moved);
    const Velocity velocity = along<Velocity>(position - place_, 1.0 / smoothing_s);
    const bool is_over = norm(place_ - from_) >= stroke_m;
    const bool is_calm = calm_s_ >= settling_s;
    if (is_over && is_calm) judge_stroke(velocity);
    if (is_over || !is_calm || stroke_s_ > longest_stroke_s) begin_stroke(velocity);
}

void HandWork::disturb(Position position) {
    if (!is_finite(position)) return;
    place_ = position;
    force_ = {};
    calm_s_ = 0.0;
    begin_stroke({});
}

void HandWork::begin_stroke(Velocity velocity) {
    from_ = place_;
    at_first_ = velocity;
    given_J_ = 0.0;
    stroke_s_ = 0.0;
}

void HandWork::judge_stroke(Velocity velocity) {
    const double gained_J =
        0.5 * tip_.mass_kg * (dot(velocity, velocity) - dot(at_first_, at_first_));
    const double friction_J = tip_.coulomb_N * norm(place_ - from_);
    const double hand_J = gained_J + friction_J - given_J_;
    if (!(hand_J > hands_share * friction_J)) return;
    if (since_s_ < together_s) ++moves_;
    since_s_ = 0.0;
}

}  // namespace touchline
