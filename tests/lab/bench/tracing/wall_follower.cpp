#include "tests/lab/bench/tracing/wall_follower.h"

#include <algorithm>
#include <cmath>

namespace touchline::bench {
namespace {

constexpr double sweep_m_per_s = 0.15;
constexpr double follow_m_per_s = 0.06;
constexpr double touch_N = 0.05;
constexpr double hold_N = 0.25;     // a wall, in a sweep
constexpr double press_m = 0.0016;  // half a newton for a pen grip
constexpr double round_m = 0.0016;  // the radius of the way round an end
constexpr double lost_after_m = 0.02;
constexpr double known_reach_m = 0.0015;
constexpr double known_enough_m = 0.006;
constexpr double recent_m = 0.02;
constexpr double all_m = 1e9;
constexpr double turn_s = 0.02;

}  // namespace

WallFollower::WallFollower(const Area& area, Position start)
    : sweep_(area), meant_(start), last_(start) {}

Intention WallFollower::step(const Touched& touched, double dt_s) {
    is_touching_ = norm(touched.force) > touch_N;
    if (is_following_) {
        follow(touched, dt_s);
    } else {
        sweep(touched, dt_s);
    }
    last_ = touched.handle;
    return {meant_, {}};
}

void WallFollower::sweep(const Touched& touched, double dt_s) {
    constexpr double longest_lean_m = 0.006;
    constexpr double patience_s = 0.3;
    if (sweep_.is_over()) return;
    const bool is_wall = norm(touched.force) > hold_N && sweep_.is_inside(touched.handle);
    if (is_wall && !felt_.is_known(touched.handle, 0.003, all_m)) {
        is_following_ = true;
        outward_ = direction_of(touched.force);
        begun_m_ = followed_m_;
        known_m_ = lost_m_ = 0.0;
        return;
    }
    const Position left = sweep_.goal() - touched.handle;
    // A wall that it knows is in its way, so it takes the next row.
    stuck_s_ = is_wall ? stuck_s_ + dt_s : 0.0;
    if (norm(left) < 0.003 || stuck_s_ > patience_s) {
        sweep_.arrive();
        stuck_s_ = 0.0;
        return;
    }
    meant_ += along<Position>(direction_of(left), sweep_m_per_s * dt_s);
    const Position lean = meant_ - touched.handle;
    if (norm(lean) > longest_lean_m)
        meant_ = touched.handle + along<Position>(direction_of(lean), longest_lean_m);
}

void WallFollower::follow(const Touched& touched, double dt_s) {
    const Position moved = touched.handle - last_;
    const double way_m = norm(moved);
    if (is_touching_) {
        const Direction felt = direction_of(touched.force);
        const double share = std::min(1.0, dt_s / turn_s);
        outward_ = direction_of(outward_ + share * (felt - outward_));
        lost_m_ = 0.0;
        followed_m_ += way_m;
        felt_.add(touched.handle, followed_m_);
    } else {
        // Goes round the end that it slid off: the wall is where its right hand points.
        const double angle = -follow_m_per_s / round_m * dt_s;
        outward_ = direction_of(outward_ + angle * left_of(outward_));
        lost_m_ += way_m;
    }
    const Direction ahead = left_of(outward_);
    meant_ = touched.handle + along<Position>(ahead, 0.0016) - along<Position>(outward_, press_m);
    const bool is_known = felt_.is_known(touched.handle, known_reach_m, begun_m_) ||
                          felt_.is_known(touched.handle, known_reach_m, followed_m_ - recent_m);
    known_m_ = is_known ? known_m_ + way_m : 0.0;
    if (known_m_ > known_enough_m || lost_m_ > lost_after_m || !sweep_.is_inside(touched.handle))
        is_following_ = false;
}

}  // namespace touchline::bench
