#include "tests/haptics/scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace touchline::scenes {
namespace {

Outline random_ring(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto count = static_cast<int>(8.0 + 72.0 * unit(random));
    const Position centre{0.06 * (unit(random) - 0.5), 0.06 * (unit(random) - 0.5)};
    const double size = 0.005 + 0.02 * unit(random);
    const double roughness = 0.6 * unit(random);
    std::vector<Position> points;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / count;
        const double r = size * (1.0 + roughness * (unit(random) - 0.5));
        points.push_back(centre + r * Position{std::cos(angle), std::sin(angle)});
    }
    return outline(std::move(points), true);
}

Outline random_walk(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto count = static_cast<int>(8.0 + 72.0 * unit(random));
    double heading = 2.0 * std::numbers::pi * unit(random);
    const double bend = 2.0 * unit(random);
    Position p{0.06 * (unit(random) - 0.5), 0.06 * (unit(random) - 0.5)};
    std::vector<Position> points{p};
    for (int i = 1; i < count; ++i) {
        heading += bend * (unit(random) - 0.5);
        p += (0.0002 + 0.002 * unit(random)) * Position{std::cos(heading), std::sin(heading)};
        p = {std::clamp(p.x, -0.05, 0.05), std::clamp(p.y, -0.05, 0.05)};
        points.push_back(p);
    }
    return outline(std::move(points), false);
}

}  // namespace

Outline outline(std::vector<Position> points, bool is_closed) {
    Outline made;
    made.points = std::move(points);
    made.is_closed = is_closed;
    return made;
}

TactileMap map_of(std::vector<Outline> outlines) {
    TactileMap map;
    map.outlines = std::move(outlines);
    return map;
}

Outline circle(double radius_m, int points) {
    std::vector<Position> made;
    for (int i = 0; i < points; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / points;
        made.push_back({radius_m * std::cos(angle), radius_m * std::sin(angle)});
    }
    return outline(std::move(made), true);
}

Outline square(double side_m, int per_side) {
    const double h = 0.5 * side_m;
    const std::vector<Position> corners{{-h, -h}, {h, -h}, {h, h}, {-h, h}};
    std::vector<Position> made;
    for (std::size_t k = 0; k < 4; ++k) {
        for (int i = 0; i < per_side; ++i) {
            const double t = static_cast<double>(i) / per_side;
            made.push_back(corners[k] + t * (corners[(k + 1) % 4] - corners[k]));
        }
    }
    return outline(std::move(made), true);
}

TactileMap rough_ring(unsigned seed, double roughness_m) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::vector<Position> points;
    double wobble_m = 0.0;
    for (int i = 0; i < 512; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 512.0;
        wobble_m = 0.9 * wobble_m + roughness_m * unit(random);
        const double radius_m = 0.03 + 0.004 * std::sin(5.0 * angle) + wobble_m;
        points.push_back(radius_m * Position{std::cos(angle), std::sin(angle)});
    }
    return map_of({outline(points, true)});
}

TactileMap random_map(unsigned seed, int outlines) {
    std::mt19937 random(seed);
    std::vector<Outline> made;
    for (int i = 0; i < outlines; ++i) {
        made.push_back(i % 2 == 0 ? random_ring(random) : random_walk(random));
        if (i % 3 == 1) made.back().points.back() = made[made.size() - 2].points[3];
    }
    return map_of(std::move(made));
}

double distance_m(Position p, const Segment& segment) {
    const Position e = segment.b - segment.a;
    const double length2 = dot(e, e);
    const double t = length2 > 0.0 ? std::clamp(dot(p - segment.a, e) / length2, 0.0, 1.0) : 0.0;
    return norm(p - (segment.a + t * e));
}

}  // namespace touchline::scenes
