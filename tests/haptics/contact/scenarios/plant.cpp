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

Polyline cut_line() {
    constexpr int pieces = 100000;
    constexpr double shortest_mm = 1e-6;
    constexpr double piece_mm = (60.0 - pieces / 200 * shortest_mm) / (pieces - pieces / 100);
    Polyline line{{{-50.0, 0.0}, {-30.0, 0.0}}};
    for (int whole = 0, odd = 0, i = 1; i <= pieces; ++i) {
        (i % 100 == 0 ? odd : whole) += 1;
        line.points_mm.push_back({-30.0 + whole * piece_mm + odd / 2 * shortest_mm, 0.0});
    }
    line.points_mm.push_back({50.0, 0.0});
    return line;
}

Polyline strand(double bend, double shift_mm, double begin_mm) {
    constexpr int edges = 128;
    Polyline line;
    for (int i = 0; i <= edges; ++i) {
        const double x = begin_mm + 40.0 * i / edges;
        line.points_mm.push_back({x, bend * (0.2 + 0.02 * x * x) + shift_mm});
    }
    return line;
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
