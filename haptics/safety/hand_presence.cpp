#include "haptics/safety/hand_presence.h"

#include <algorithm>

namespace touchline {
namespace {

constexpr double window_s = 0.01;
constexpr double telling_m_per_s = 0.07;  // gain in a window: less than 1 N of guidance gives
constexpr double explained = 0.25;        // of the gain: a light hand takes three tenths away
constexpr double off_after_s = 0.03;
constexpr double neutral_longest_s = 0.5;
constexpr double lag_s = 0.003;  // of the measured velocity and of the motors together
constexpr double still_m = 2e-4;
constexpr double still_N = 0.5;
// Friction holds a hand that rests against a wall this still for seconds: with 3 s, a pen grip with
// a tremor of 0.05 mm lost its wall.
constexpr double still_s = 20.0;
constexpr double coasting_s = 0.5;

}  // namespace

bool HandPresence::step(Force force, Velocity velocity, Position position, double dt_s) {
    if (is_off_) {
        look_for_hand(position, dt_s);
        return is_off_;
    }
    is_alone_ = moves_alone(force, velocity, dt_s);
    is_off_ = stands_still(force, position, dt_s) || is_alone_;
    wait_s_ = is_alone_ ? coasting_s : 0.0;
    left_at_ = position;
    return is_off_;
}

bool HandPresence::moves_alone(Force force, Velocity velocity, double dt_s) {
    const Velocity friction =
        along<Velocity>(velocity, tip_.viscous_Ns_per_m) +
        along<Velocity>(norm(velocity) > 0.0 ? direction_of(velocity) : Direction{},
                        tip_.coulomb_N);
    const Velocity now = 1.0 / tip_.mass_kg * (along<Velocity>(force, 1.0) - friction);
    rate_ += dt_s / (dt_s + lag_s) * (now - rate_);
    expected_ += dt_s * rate_;
    window_s_ += dt_s;
    if (window_s_ >= window_s) {
        judge_window(velocity - at_begin_);
        at_begin_ = velocity;
        expected_ = {};
        window_s_ = 0.0;
    }
    return alone_s_ >= off_after_s;
}

void HandPresence::judge_window(Velocity gained) {
    const double expected_m_per_s = norm(expected_);
    if (!(expected_m_per_s > telling_m_per_s)) {
        neutral_s_ += window_s_;
        if (neutral_s_ > neutral_longest_s) alone_s_ = 0.0;
        return;
    }
    neutral_s_ = 0.0;
    const bool is_explained = norm(gained - expected_) <= explained * expected_m_per_s;
    alone_s_ = is_explained ? alone_s_ + window_s_ : 0.0;
}

bool HandPresence::stands_still(Force force, Position position, double dt_s) {
    low_ = {std::min(low_.x, position.x), std::min(low_.y, position.y)};
    high_ = {std::max(high_.x, position.x), std::max(high_.y, position.y)};
    const bool is_still = norm(high_ - low_) <= still_m && norm(force) > still_N;
    if (!is_still) low_ = high_ = position;
    rest_s_ = is_still ? rest_s_ + dt_s : 0.0;
    return rest_s_ >= still_s;
}

void HandPresence::look_for_hand(Position position, double dt_s) {
    if (wait_s_ > 0.0) {
        wait_s_ -= dt_s;
        left_at_ = position;
        return;
    }
    const bool moves = !(norm(position - left_at_) <= still_m + tip_.count_m);
    if (moves) *this = HandPresence(tip_);
}

}  // namespace touchline
