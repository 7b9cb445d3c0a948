#include "haptics/contact/round_vertex.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double rest_m = 1e-15;  // a pull this small along the arc moves nothing

}  // namespace

double largest_arc_step_rad(double offset_m) {
    constexpr double unfelt_m = 1e-9;
    return offset_m > unfelt_m ? std::numbers::pi / 12.0 : std::numbers::pi / 2.0;
}

Direction turned(Direction n, double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return {c * n.x - s * n.y, s * n.x + c * n.y};
}

double angle_between(Direction n, Direction m, double turn) {
    constexpr double full = 2.0 * std::numbers::pi;
    double angle = std::atan2(turn * cross(n, m), dot(n, m));
    if (angle < 0.0) angle += full;
    return angle > 0.875 * full ? 0.0 : angle;
}

ArcGoal arc_goal(Direction n, Position pull, double offset_m, double to_left_rad,
                 double to_right_rad, double friction) {
    const double sideways = cross(n, pull);  // pull along the arc, left positive
    const double depth = offset_m - dot(n, pull);
    const double distance = norm(pull);
    const bool is_behind = dot(n, pull) < 0.0;
    if (std::abs(sideways) <= std::max(held_by_friction(friction, depth), rest_m) &&
        !(is_behind && friction == 0.0)) {
        return {};
    }
    ArcGoal goal;
    // Exactly behind the vertex both ways are equally good, so take the shorter one.
    if (std::abs(sideways) <= rest_m) {
        goal.turn = to_left_rad < to_right_rad ? 1.0 : -1.0;
    } else {
        goal.turn = sideways > 0.0 ? 1.0 : -1.0;
    }
    const double to_pull = std::abs(std::atan2(sideways, dot(n, pull)));
    const double to_edge = goal.turn > 0.0 ? to_left_rad : to_right_rad;
    double stop = to_pull;
    if (distance > offset_m) {
        stop = std::max(0.0, to_pull - std::acos(offset_m / distance));
        goal.end = ArcGoal::End::free;
    } else if (friction > 0.0) {
        // At angle b before the pull's direction: distance sin b = friction (offset - distance cos
        // b).
        const double lean = std::atan(friction);
        const double sine = offset_m * std::sin(lean) / distance;
        stop = sine < 1.0 ? std::max(0.0, to_pull - (std::asin(sine) - lean)) : 0.0;
    }
    goal.angle_rad = stop;
    if (to_edge < stop) {
        goal.angle_rad = to_edge;
        goal.end = ArcGoal::End::edge;
    }
    return goal;
}

}  // namespace touchline
