#include "app/cli/tour.h"
#include "haptics/curve/spacing.h"

#include <algorithm>
#include <cmath>

namespace touchline {

namespace {

constexpr double route_step_m = 0.0005;
constexpr std::size_t normal_reach = 4;   // route points on either side: the normal spans +-2 mm
constexpr std::size_t walked_twice = 10;  // route points, at the end of a closed outline
constexpr std::size_t off_the_end = 8;    // route points: pressing at an end, a hand slips round it
constexpr std::size_t look_ahead = 16;    // route points in which the proxy's place is sought
constexpr double longest_wait_s = 3.0;    // for the force to come on
constexpr double arrival_m = 0.001;       // this near, the hand has arrived ...
constexpr double arrival_s = 0.5;         // ... or never will
constexpr double over_the_edge_m = 0.005;  // the device reaches a little beyond the drawing area
constexpr double least_force_N = 0.05;     // a smaller force has no usable direction
constexpr double press_share = 0.8;        // of a small outline's radius

/// Positive when the closed outline runs counter-clockwise.
double signed_area_m2(const std::vector<Position>& points) {
    double twice = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
        twice += cross(points[i], points[(i + 1) % points.size()]);
    return twice / 2.0;
}

/// The radius of a circle; the width of something long.
double mean_radius_m(std::vector<Position> points) {
    const double area_m2 = std::abs(signed_area_m2(points));
    points.push_back(points.front());
    return 2.0 * area_m2 / polyline_length_m(points);
}

std::vector<Position> places_along(const Outline& outline) {
    std::vector<Position> line = outline.points;
    if (outline.is_closed) line.push_back(line.front());
    const double steps = std::round(polyline_length_m(line) / route_step_m);
    std::vector<Position> places = resample(line, static_cast<std::size_t>(std::max(steps, 8.0)));
    if (outline.is_closed) places.pop_back();
    return places;
}

bool is_left_outward(const Outline& outline) {
    return !outline.is_closed || signed_area_m2(outline.points) < 0.0;
}

}  // namespace

std::vector<RoutePoint> route_along(const Outline& outline) {
    const std::vector<Position> places = places_along(outline);
    const std::size_t count = places.size();
    const auto place = [&](std::size_t i, std::size_t back, std::size_t ahead) {
        if (outline.is_closed) return places[(i + count - back + ahead) % count];
        return places[std::min(std::max(i, back) - back + ahead, count - 1)];
    };
    const std::size_t reach = std::min(normal_reach, count / 4);
    const std::size_t length = outline.is_closed ? count + std::min(walked_twice, count) : count;
    std::vector<RoutePoint> route;
    for (std::size_t i = 0; i < length; ++i) {
        const Direction left = left_of(direction_of(place(i, 0, reach) - place(i, reach, 0)));
        route.push_back({place(i, 0, 0), is_left_outward(outline) ? left : -left});
    }
    return route;
}

Explorer::Explorer(const TactileMap& map, const Scene& scene, const ExplorerOptions& options)
    : map_(map), scene_(scene), options_(options) {
    if (map_.outlines.empty()) {
        phase_ = Phase::done;
        return;
    }
    take_outline();
    lift_to_next_place();
    if (phase_ == Phase::travel) hand_.position = beside(route_[at_]);
}

void Explorer::take_outline() {
    const Outline& outline = map_.outlines[outline_];
    route_ = route_along(outline);
    turn_ = is_left_outward(outline) ? -1.0 : 1.0;
    press_m_ = options_.press_m;
    if (outline.is_closed)
        press_m_ = std::min(press_m_, press_share * mean_radius_m(outline.points));
    at_ = outline.is_closed ? 0 : std::min(off_the_end, route_.size() / 3);
    is_visited_ = false;
}

void Explorer::next_outline() {
    if (++outline_ == map_.outlines.size())
        phase_ = Phase::done;
    else
        take_outline();
}

Position Explorer::beside(const RoutePoint& point) const {
    return point.on + along<Position>(point.outward, options_.clearance_m);
}

/// True for a place in the hand's reach where the outline itself is the nearest thing, so that the
/// hand will touch it.
bool Explorer::is_open_place(const RoutePoint& point) const {
    const Position place = beside(point);
    if (std::abs(place.x) > map_.area.width_m / 2.0 + over_the_edge_m ||
        std::abs(place.y) > map_.area.height_m / 2.0 + over_the_edge_m)
        return false;
    const double nearest_m = 0.9 * options_.clearance_m;
    return scene_.tree.closest_point(scene_.curves, place, 0.0, nearest_m).segment.piece < 0;
}

/// Lifts the hand to the first place from here on where the outline can be reached, or goes on to
/// the next outline.
void Explorer::lift_to_next_place() {
    phase_ = Phase::travel;
    waited_s_ = 0.0;
    while (phase_ != Phase::done) {
        while (at_ < route_.size() && !is_open_place(route_[at_])) ++at_;
        if (at_ < route_.size()) return;
        next_outline();
    }
}

/// Moves the intention straight towards the target; true once it has arrived.
bool Explorer::move_to(Position target, double speed_m_per_s, double dt_s) {
    const Position way = target - hand_.position;
    const double step_m = speed_m_per_s * dt_s;
    if (norm(way) <= step_m) {
        hand_ = {target, {}};
        return true;
    }
    const Direction ahead = direction_of(way);
    hand_.position += along<Position>(ahead, step_m);
    hand_.velocity = along<Velocity>(ahead, speed_m_per_s);
    return false;
}

void Explorer::step(const Felt& felt, double dt_s) {
    switch (phase_) {
        case Phase::travel:
            travel(felt, dt_s);
            break;
        case Phase::settle:
            settle(felt, dt_s);
            break;
        case Phase::approach: {
            const Position beyond = route_[at_].on - along<Position>(route_[at_].outward, press_m_);
            if (move_to(beyond, options_.approach_m_per_s, dt_s)) phase_ = Phase::follow;
            break;
        }
        case Phase::follow:
            follow(felt, dt_s);
            break;
        case Phase::leave:
            leave(dt_s);
            break;
        case Phase::done:
            break;
    }
}

/// The map turns on again only after it was off and the hand is at the place for it.
void Explorer::travel(const Felt& felt, double dt_s) {
    const Position target = beside(route_[at_]);
    if (!move_to(target, options_.travel_m_per_s, dt_s)) return;
    waited_s_ += dt_s;
    if (felt.map_force == MapForce::off && norm(felt.proxy - target) < arrival_m) {
        phase_ = Phase::settle;
        waited_s_ = 0.0;
    } else if (waited_s_ > arrival_s) {
        ++at_;
        lift_to_next_place();
    }
}

void Explorer::settle(const Felt& felt, double dt_s) {
    waited_s_ += dt_s;
    if (waited_s_ > longest_wait_s) phase_ = Phase::done;  // the servo refuses to make force
    if (felt.map_force != MapForce::on) return;
    phase_ = Phase::approach;
    outward_ = route_[at_].outward;
    free_s_ = 0.0;
    if (!is_visited_) ++visited_;
    is_visited_ = true;
}

/// Pushes against what it feels and moves at right angles to that, as a person follows an edge.
/// Around corners the felt direction turns, and the path with it.
void Explorer::follow(const Felt& felt, double dt_s) {
    note_progress(felt.proxy);
    if (at_ + 1 == route_.size()) {
        phase_ = Phase::leave;
        off_ = felt.proxy + along<Position>(outward_, options_.clearance_m);
        return;
    }
    if (is_lost(felt, dt_s)) {
        ++at_;
        lift_to_next_place();
        return;
    }
    turn_to(felt, dt_s);
    const Direction ahead = turn_ * left_of(outward_);
    const Position lead = hand_.position - felt.proxy;
    const double too_shallow_m = dot(lead, outward_) + press_m_;
    const double inward_m_per_s = std::clamp(too_shallow_m / options_.reaction_s,
                                             -options_.follow_m_per_s, options_.follow_m_per_s);
    const double pace_m_per_s =
        felt.is_in_contact ? options_.follow_m_per_s : options_.search_m_per_s;
    const double ahead_m_per_s = dot(lead, ahead) < options_.leash_m ? pace_m_per_s : 0.0;
    hand_.velocity =
        along<Velocity>(ahead, ahead_m_per_s) - along<Velocity>(outward_, inward_m_per_s);
    hand_.position += along<Position>(hand_.velocity, dt_s);
}

/// Outward is where the force points; without a force, the outline's own outside.
void Explorer::turn_to(const Felt& felt, double dt_s) {
    const bool tells = felt.is_in_contact && norm(felt.force) > least_force_N;
    const Direction now = tells ? direction_of(felt.force) : route_[at_].outward;
    const double share = std::min(dt_s / options_.reaction_s, 1.0);
    outward_ = direction_of(outward_ + share * (now - outward_));
}

void Explorer::note_progress(Position proxy) {
    const std::size_t last = std::min(at_ + look_ahead, route_.size() - 1);
    std::size_t nearest = at_;
    for (std::size_t i = at_; i <= last; ++i) {
        if (norm(proxy - route_[i].on) < norm(proxy - route_[nearest].on)) nearest = i;
    }
    at_ = nearest;
}

bool Explorer::is_lost(const Felt& felt, double dt_s) {
    free_s_ = felt.is_in_contact ? 0.0 : free_s_ + dt_s;
    return free_s_ > options_.lost_s || norm(felt.proxy - route_[at_].on) > options_.lost_m;
}

void Explorer::leave(double dt_s) {
    if (!move_to(off_, options_.approach_m_per_s, dt_s)) return;
    next_outline();
    if (phase_ != Phase::done) lift_to_next_place();
}

}  // namespace touchline
