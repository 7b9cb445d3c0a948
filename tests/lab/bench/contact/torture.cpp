#include "tests/lab/bench/contact/torture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

namespace touchline::bench {
namespace {

using scenarios::mm;
using scenarios::Polyline;
using scenarios::through;
using scenarios::Trajectory;

constexpr double pi = std::numbers::pi;

std::vector<Position> in_metres(const std::vector<Position>& points_mm) {
    std::vector<Position> points;
    for (const Position p : points_mm) points.push_back(mm * p);
    return points;
}

/// Goes from `high_mm` down along -`out` to 5 mm past the origin, then 2 mm to both sides at 3 Hz
/// for a second, then rests for a second.
Trajectory press_and_wiggle(Position out, double high_mm) {
    return [=](double t) -> Intention {
        constexpr double omega = 2.0 * pi * 3.0;
        const bool is_wiggling = t > 0.5 && t < 1.5;
        const double depth_m = mm * (high_mm - (high_mm + 5.0) * std::min(t / 0.5, 1.0));
        const double aside_m = is_wiggling ? 2 * mm * std::sin(omega * t) : 0.0;
        const double down = t < 0.5 ? -2.0 * (high_mm + 5.0) * mm : 0.0;
        const double aside = is_wiggling ? 2 * mm * omega * std::cos(omega * t) : 0.0;
        const Position left = left_of(out);
        return {depth_m * out + aside_m * left,
                along<Velocity>(out, down) + along<Velocity>(left, aside)};
    };
}

Torture acute_corner(double opening_deg) {
    const double a = opening_deg * pi / 360.0;
    const Position arm{50.0 * std::sin(a), 50.0 * std::cos(a)};
    const Polyline line{{{-arm.x, arm.y}, {0.0, 0.0}, arm}};
    const auto is_out = [a](Position p) {
        return std::abs(p.x) * std::cos(a) > p.y * std::sin(a) + 1e-7;
    };
    return {"acute corners",
            fmt::format("{:g} degrees", opening_deg),
            there_and_back(line),
            {line},
            press_and_wiggle({0.0, 1.0}, 20.0),
            2.5,
            [is_out](Position from, Position to) { return !is_out(from) && is_out(to); }};
}

Torture thin_bar(double width_mm) {
    const Polyline bar{{{-20.0, 0.0}, {20.0, 0.0}, {20.0, -width_mm}, {-20.0, -width_mm}}, true};
    // 300 N/m of hand in series with 1000 N/m of wall: 5 N at 21.7 mm.
    return {"thin bars",
            fmt::format("{:g} mm", width_mm),
            in_metres(bar.points_mm),
            {bar},
            through({{0, 0, 10}, {1.0, 0, -22}, {1.5, 0, -22}, {2.5, 0, 10}}),
            2.8,
            [](Position from, Position to) { return from.y >= 0.0 && to.y < 0.0; },
            true};
}

Torture crossing_lines(double turned_deg) {
    const double lean = 5.0 * pi / 180.0;
    const Position rising{50.0 * std::cos(lean), 50.0 * std::sin(lean)};
    const Position falling{rising.x, -rising.y};
    const Position middle{0.0, 0.0};
    const auto sector = [=](Position p) {
        return 2 * (cross(rising, p) > 0.0) + (cross(falling, p) > 0.0);
    };
    const double turn = turned_deg * pi / 180.0;
    return {"crossing lines",
            fmt::format("from {:g} degrees", turned_deg),
            in_metres({middle, rising, middle, -rising, middle, falling, middle, -falling}),
            {{{-rising, rising}}, {{-falling, falling}}},
            press_and_wiggle({std::cos(turn), std::sin(turn)}, 12.0),
            2.5,
            [sector](Position from, Position to) { return sector(from) != sector(to); }};
}

Torture line_end(double pressed_mm) {
    const Polyline line{{{-60.0, 0.0}, {0.0, 0.0}}};
    return {"line ends",
            fmt::format("pressed {:g} mm", pressed_mm),
            there_and_back(line),
            {line},
            through({{0, -30, 10},
                     {.2, -30, -pressed_mm},
                     {1.0, 15, -pressed_mm},
                     {1.2, 15, -pressed_mm},
                     {2.0, -30, -pressed_mm},
                     {2.6, -30, 12}}),
            3.0,
            [](Position from, Position to) {
                return (from.y < 0.0) != (to.y < 0.0) && std::max(from.x, to.x) < -1 * mm;
            },
            true};
}

}  // namespace

std::vector<Position> there_and_back(const Polyline& line) {
    std::vector<Position> points = line.points_mm;
    for (std::size_t i = line.points_mm.size() - 1; i-- > 1;) points.push_back(line.points_mm[i]);
    return in_metres(points);
}

std::vector<Torture> tortures() {
    std::vector<Torture> made;
    for (const double opening : {90.0, 60.0, 30.0, 15.0, 5.0})
        made.push_back(acute_corner(opening));
    for (const double width : {0.2, 0.5, 1.0, 3.0}) made.push_back(thin_bar(width));
    for (const double turned : {0.0, 90.0, 180.0, 270.0}) made.push_back(crossing_lines(turned));
    for (const double pressed : {3.0, 6.0}) made.push_back(line_end(pressed));
    return made;
}

}  // namespace touchline::bench
