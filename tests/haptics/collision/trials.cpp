#include "tests/haptics/collision/trials.h"

#include "tests/haptics/scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace touchline::trials {
namespace {

constexpr std::size_t most_segments = 64;

Outline ring(Random& random, std::size_t points) {
    const Position centre = 0.5 * random.place();
    const double size_m = random.decade(-4.0, -1.6);
    const double roughness = random.unit();
    std::vector<Position> made;
    for (std::size_t i = 0; i < points; ++i) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
        const double r = size_m * (1.0 + roughness * (random.unit() - 0.5));
        made.push_back(centre + r * Position{std::cos(angle), std::sin(angle)});
    }
    return scenes::outline(std::move(made), true);
}

Outline walk(Random& random, std::size_t points) {
    double heading = 2.0 * std::numbers::pi * random.unit();
    const double bend = 4.0 * random.unit();
    const double step_m = random.decade(-5.0, -2.5);
    std::vector<Position> made{0.5 * random.place()};
    while (made.size() < points) {
        heading += bend * (random.unit() - 0.5);
        const double length_m = step_m * (0.1 + random.unit());
        made.push_back(made.back() + length_m * Position{std::cos(heading), std::sin(heading)});
    }
    return scenes::outline(std::move(made), random.below(4) == 0);
}

/// Gives points twice in a row and visits earlier points again.
Outline repeated(Random& random, std::size_t points) {
    std::vector<Position> made{random.place()};
    while (made.size() < points) {
        const std::size_t earlier = random.below(made.size());
        made.push_back(random.below(3) == 0 ? made[earlier] : random.place());
        if (random.below(3) == 0) made.push_back(made.back());
    }
    return scenes::outline(std::move(made), random.below(2) == 0);
}

/// Takes any points: crosses itself wherever it can.
Outline scribble(Random& random, std::size_t points) {
    const double size = random.decade(-3.0, 0.0);
    const Position centre = 0.5 * random.place();
    std::vector<Position> made;
    while (made.size() < points) made.push_back(centre + size * random.place());
    return scenes::outline(std::move(made), random.below(2) == 0);
}

/// Corners on a grid of a power of two: edges on one line, on top of each other and back on
/// themselves, and crossings at grid points, all exact.
Outline on_grid(Random& random, std::size_t points) {
    const double cell_m = std::ldexp(1.0, -8 - static_cast<int>(random.below(6)));
    const auto coordinate = [&] { return cell_m * (static_cast<double>(random.below(9)) - 4.0); };
    const bool is_rectilinear = random.below(2) == 0;
    std::vector<Position> made{{coordinate(), coordinate()}};
    while (made.size() < points) {
        Position next{coordinate(), coordinate()};
        if (is_rectilinear) {
            const bool is_level = random.below(2) == 0;
            (is_level ? next.y : next.x) = is_level ? made.back().y : made.back().x;
        }
        made.push_back(next);
    }
    return scenes::outline(std::move(made), random.below(2) == 0);
}

Outline any_outline(Random& random, std::size_t most) {
    const std::size_t points = 3 + random.below(most - 2);
    switch (random.below(6)) {
        case 0:
            return ring(random, points);
        case 1:
            return walk(random, points);
        case 2:
            return scenes::outline({random.place(), random.place()}, random.below(2) == 0);
        case 3:
            return repeated(random, points);
        case 4:
            return scribble(random, points);
        default:
            return on_grid(random, points);
    }
}

Position any_vertex(Random& random, const LevelSegments& segments) {
    const Segment& s = segments.all()[random.below(segments.all().size())].segment;
    return random.below(2) == 0 ? s.a : s.b;
}

Position near_vertex(Random& random, const LevelSegments& segments, double decades) {
    const Position vertex = any_vertex(random, segments);
    const double off_m = random.decade(decades, -2.0);
    return vertex + off_m * random.direction();
}

/// Returns a point as close to the segment as rounding allows.
Position on_segment(Random& random, const LevelSegments& segments) {
    const Segment& s = segments.all()[random.below(segments.all().size())].segment;
    const double t = random.below(4) == 0 ? 0.5 : random.unit();
    return s.a + t * (s.b - s.a);
}

Position one_ulp_off(Random& random, Position p) {
    // The next number to 0 is 5e-324, whose products vanish; the predicates promise 1e-140.
    constexpr double beside_zero_m = 0x1p-80;
    const auto off = [&](double x) {
        const std::size_t way = random.below(3);
        if (way == 0) return x;
        const double sign = way == 1 ? 1.0 : -1.0;
        return x == 0.0 ? sign * beside_zero_m : std::nextafter(x, 2.0 * sign * std::abs(x));
    };
    const double x = off(p.x);
    return {x, off(p.y)};
}

/// Any place that may matter: anywhere, a vertex, an ulp beside one, on a segment, near one.
Position any_place(Random& random, const LevelSegments& segments) {
    switch (random.below(6)) {
        case 0:
            return random.place();
        case 1:
            return any_vertex(random, segments);
        case 2:
            return one_ulp_off(random, any_vertex(random, segments));
        case 3:
            return on_segment(random, segments);
        case 4:
            return one_ulp_off(random, on_segment(random, segments));
        default:
            return near_vertex(random, segments, -14.0);
    }
}

/// A way along a segment's line: part of it, all of it, beyond both ends, up to an end.
FromTo along_segment(Random& random, const LevelSegments& segments) {
    const Segment& s = segments.all()[random.below(segments.all().size())].segment;
    constexpr double shares[] = {-1.0, -0.5, 0.0, 0.25, 0.5, 1.0, 1.5, 2.0};
    const auto at = [&] {
        const double t = random.below(4) == 0 ? random.unit() : shares[random.below(8)];
        return t == 1.0 ? s.b : s.a + t * (s.b - s.a);
    };
    return {at(), at()};
}

FromTo far_away(Random& random) {
    const double away_m = random.decade(-1.0, 3.0);
    const Position off = away_m * random.direction();
    const Position from = random.place() + off;
    const Position to = random.place();
    return {from, random.below(2) == 0 ? to + off : to - off};
}

}  // namespace

std::size_t count(std::size_t everyday, std::size_t exhaustive) {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): the tests set no variable.
    return std::getenv("TOUCHLINE_EXHAUSTIVE") != nullptr ? exhaustive : everyday;
}

TactileMap small_map(Random& random) {
    const std::size_t outlines = random.below(4) == 0 ? 2 + random.below(4) : 1;
    std::vector<Outline> made;
    for (std::size_t i = 0; i < outlines; ++i) {
        made.push_back(any_outline(random, most_segments / outlines));
    }
    return scenes::map_of(std::move(made));
}

TactileMap closed_map(Random& random) {
    TactileMap map = small_map(random);
    for (Outline& outline : map.outlines) outline.is_closed = true;
    // Two points are no closed curve.
    std::erase_if(map.outlines, [](const Outline& outline) { return outline.points.size() < 3; });
    return map;
}

TactileMap tiny_outlines(Random& random, std::size_t count) {
    std::vector<Outline> made;
    while (made.size() < count) {
        const Position at = random.place();
        const double size_m = random.decade(-4.3, -2.7);
        const std::size_t points = 2 + random.below(4);
        std::vector<Position> corners;
        while (corners.size() < points) corners.push_back(at + size_m * random.direction());
        made.push_back(scenes::outline(std::move(corners), random.below(2) == 0));
    }
    return scenes::map_of(std::move(made));
}

Scene every_level(const TactileMap& map, double radius_m, const CurveOptions& options) {
    CurveSet curves = CurveSet::build(map, options).value();
    CollisionTree tree = CollisionTree::build(curves, radius_m);
    return {std::move(curves), std::move(tree), map.area};
}

Scene scene_of(const TactileMap& map, std::uint64_t seed) {
    constexpr double never_split_m = 10.0;
    CurveOptions options;
    if (seed % 4 != 0) options.spacing_m = never_split_m;
    return every_level(map, 0.0, options);
}

std::vector<double> levels_of(const CurveSet& curves) {
    std::vector<double> levels;
    for (int whole = 0; whole <= curves.coarsest(); ++whole) {
        for (const double part : {0.0, 0.1, 0.5, 0.9}) levels.push_back(whole + part);
    }
    levels.push_back(curves.coarsest() + 1.0);
    return levels;
}

FromTo way_through_vertex(Random& random, const LevelSegments& segments) {
    const Position vertex = any_vertex(random, segments);
    const double before_m = random.decade(-9.0, -1.0);
    const double after_m = random.decade(-9.0, -1.0);
    Position u = random.direction();
    const std::size_t kind = random.below(4);
    if (kind == 0) u = {random.below(2) == 0 ? 1.0 : -1.0, 0.0};
    if (kind == 1) u = {0.0, random.below(2) == 0 ? 1.0 : -1.0};
    if (kind == 2) return {vertex - before_m * u, vertex + before_m * u};
    return {vertex - before_m * u, vertex + after_m * u};
}

FromTo way(Random& random, const LevelSegments& segments) {
    switch (random.below(10)) {
        case 0:
            return {random.place(), random.place()};
        case 1: {
            const Position from = random.place();
            const double length_m = random.decade(-12.0, -1.0);
            return {from, from + length_m * random.direction()};
        }
        case 2:
        case 3:
            return way_through_vertex(random, segments);
        case 4:
            return along_segment(random, segments);
        case 5: {
            const Position p = any_place(random, segments);
            return {p, p};
        }
        case 6:
            return far_away(random);
        case 7: {  // a short one close to the curve, inside its boxes
            const Position from = near_vertex(random, segments, -9.0);
            const double length_m = random.decade(-9.0, -2.5);
            return {from, from + length_m * random.direction()};
        }
        default:
            return {any_place(random, segments), any_place(random, segments)};
    }
}

}  // namespace touchline::trials
