#include "tests/haptics/contact/scenarios/plant.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace touchline::scenarios {

Force limited(Force force, double motors_N) {
    const double size_N = norm(force);
    return size_N > motors_N ? motors_N / size_N * force : force;
}

Trajectory through(const std::vector<Waypoint_mm>& waypoints) {
    std::vector<WaypointPath::Waypoint> points;
    for (const Waypoint_mm& w : waypoints) points.push_back({w.t_s, {w.x_mm * mm, w.y_mm * mm}});
    return [path = WaypointPath(std::move(points))](double t_s) {
        Intention intention = path.at(t_s);
        if (t_s <= 0.0) intention.velocity = {};
        return intention;
    };
}

Trajectory press_and_slide() {
    return through({{0, -30, 10}, {.2, -30, -5}, {.8, 30, -5}, {1.0, 30, 10}, {1.2, 30, 10}});
}

Plant::Plant(const CommonSetUp& set_up, const Trajectory& trajectory)
    : trajectory_(trajectory), dynamics_(set_up.tip, set_up.hand, trajectory(0.0).position) {
    dynamics_.set_velocity(trajectory(0.0).velocity);
}

void Plant::tick(std::size_t k, Force force) {
    constexpr double h_s = tick_s / substeps;
    for (int i = 0; i < substeps; ++i) {
        dynamics_.step(force, trajectory_(static_cast<double>(k) * tick_s + i * h_s), h_s);
    }
}

Polyline flat_line() {
    return {{{-50.0, 0.0}, {50.0, 0.0}}};
}

Polyline polygon(double radius_mm, int vertices) {
    Polyline made{{}, true};
    for (int i = 0; i < vertices; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / vertices;
        made.points_mm.push_back({radius_mm * std::cos(angle), radius_mm * std::sin(angle)});
    }
    return made;
}

TactileMap map_of(const std::vector<Polyline>& polylines) {
    TactileMap map;
    for (const Polyline& polyline : polylines) {
        Outline outline;
        outline.is_closed = polyline.is_closed;
        for (const Position p : polyline.points_mm) outline.points.push_back(mm * p);
        map.outlines.push_back(outline);
    }
    return map;
}

Scene scene_of(const std::vector<Polyline>& polylines, double radius_m,
               const CurveOptions& options) {
    return build_scene(map_of(polylines), options, radius_m).value();
}

}  // namespace touchline::scenarios
