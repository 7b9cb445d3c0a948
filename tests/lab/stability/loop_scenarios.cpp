#include "tests/lab/stability/loop_scenarios.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>

#include <fmt/core.h>

namespace touchline::stability {
namespace {

using bench::there_and_back;
using bench::Torture;
using scenarios::flat_line;
using scenarios::mm;
using scenarios::Polyline;
using scenarios::through;

constexpr double pi = std::numbers::pi;

bool is_below(Position, Position to) {
    return to.y < -1e-7;
}

Scene scene_of_edges(const std::vector<Polyline>& lines, double radius_m = 0.0) {
    CurveOptions whole_edges;
    whole_edges.spacing_m = 1.0;
    return scenarios::scene_of(lines, radius_m, whole_edges);
}

LoopScenario made(Torture torture, double radius_m = 0.0,
                  std::function<double(double)> level = {}) {
    Scene scene = scene_of_edges(torture.lines, radius_m);
    return {std::move(torture), std::move(scene), radius_m, std::move(level)};
}

/// Presses to 5 mm and goes along the line.
Torture flat(const std::string& group, const std::string& name, const std::vector<Polyline>& lines,
             std::vector<Position> ring) {
    return {group,
            name,
            std::move(ring),
            lines,
            through({{0, -30, 10}, {.2, -30, -5}, {.8, 30, -5}}),
            0.9,
            is_below};
}

Torture convex_vertex(double interior_deg) {
    const double turn = (180.0 - interior_deg) * pi / 180.0;
    const Position down{std::cos(turn), -std::sin(turn)};
    const Polyline line{{{-50.0, 0.0}, {0.0, 0.0}, 50.0 * down}};
    return {"convex vertices",
            fmt::format("{:g} degrees", interior_deg),
            there_and_back(line),
            {line},
            through({{0, -30, 10}, {.2, -30, -6}, {1.0, 20, -6}}),
            1.1,
            // Below the first face and on the inner side of the second.
            [down](Position, Position to) { return to.y < -1e-7 && cross(down, to) < -1e-9; }};
}

std::vector<Position> corners(const Polyline& closed) {
    std::vector<Position> points;
    for (const Position p : closed.points_mm) points.push_back(mm * p);
    return points;
}

Torture polygon(int vertices) {
    const double inner_m = 30 * mm * std::cos(pi / vertices);
    const auto path = [](double t) -> Intention {
        const double angle = std::max(0.0, t - 0.2) * 0.1 / (27 * mm);
        const double radius_m = mm * (36.0 - 9.0 * std::min(1.0, t / 0.2));
        const Position out{std::cos(angle), std::sin(angle)};
        return {radius_m * out, {}};
    };
    const Polyline line = scenarios::polygon(30.0, vertices);
    return {"polygons",
            fmt::format("{} vertices", vertices),
            corners(line),
            {line},
            path,
            2.0,
            [inner_m](Position, Position to) { return norm(to) < inner_m - 1e-7; }};
}

/// Goes from 20 mm above the line to 20 mm below it.
Torture swipe(double speed_m_per_s) {
    const double end_s = 0.1 + 40 * mm / speed_m_per_s;
    return {"swipes",      fmt::format("{:g} m/s", speed_m_per_s),   there_and_back(flat_line()),
            {flat_line()}, through({{0.1, 3, 20}, {end_s, 3, -20}}), end_s,
            is_below};
}

/// Goes between two strands, 50 mm/s along and 3 mm to both sides; both are at their coarsest level
/// most of the time.
LoopScenario strands(const std::string& name, const Polyline& upper, const Polyline& lower,
                     double middle_per_mm) {
    const auto middle_mm = [middle_per_mm](double x_mm) { return middle_per_mm * x_mm * x_mm; };
    const auto path = [middle_mm](double t) -> Intention {
        const double x_mm = -13.0 + 50.0 * t;
        const double aside_mm = 3.0 * std::sin(2.0 * pi * 3.0 * t);
        return {{x_mm * mm, (middle_mm(x_mm) + aside_mm) * mm}, {}};
    };
    // Beyond any level's version of a strand, if the hand gets that far.
    const auto is_out = [middle_mm](Position p) {
        const double x_mm = p.x / mm;
        const double reach_mm = 0.5 + 0.25 * std::abs(x_mm);
        return std::abs(x_mm) < 8.0 && std::abs(p.y / mm - middle_mm(x_mm)) > reach_mm;
    };
    std::vector<Position> ring = there_and_back(upper);
    const std::vector<Position> other = there_and_back(lower);
    ring.push_back(ring.front());
    ring.insert(ring.end(), other.begin(), other.end());
    ring.push_back(other.front());
    Torture torture{"strands",
                    name,
                    std::move(ring),
                    {upper, lower},
                    path,
                    0.5,
                    [is_out](Position from, Position to) { return !is_out(from) && is_out(to); }};
    return made(std::move(torture), 5e-5,
                [](double t) { return t < 0.05 || t > 0.45 ? 0.0 : 16.0; });
}

/// Presses in the middle of an edge of the level that has 16 edges.
LoopScenario changing_circle() {
    const Direction out{std::cos(pi / 16.0), std::sin(pi / 16.0)};
    const auto press = [out](double t) -> Intention {
        return {along<Position>(out, 35 * mm - 9 * mm * std::min(t / 0.3, 1.0)),
                along<Velocity>(out, t < 0.3 ? -30 * mm : 0.0)};
    };
    const Polyline line = scenarios::polygon(30.0, 256);
    // A millimetre inside the coarse circle.
    const double inside_m = 30 * mm * std::cos(pi / 16.0) - 1 * mm;
    Torture torture{"levels that change",
                    "circle",
                    corners(line),
                    {line},
                    press,
                    2.0,
                    [inside_m](Position, Position to) { return norm(to) < inside_m; }};
    return made(std::move(torture), 5e-5, [](double t) {
        const bool is_fine = t < 0.5 || t > 1.5 || static_cast<int>(t / 0.05) % 2 == 1;
        return is_fine ? 0.0 : 4.0;
    });
}

/// For a disc of 50 um, which does not fit through the closed gaps. At an open one only a way
/// beside the gap counts as through.
LoopScenario gap(double width_mm) {
    const double half = 0.5 * width_mm;
    const Polyline left{{{-50.0, 0.0}, {-half, 0.0}}};
    const Polyline right{{{half, 0.0}, {50.0, 0.0}}};
    const bool is_open = width_mm > 0.1;
    const auto is_through = [=](Position from, Position to) {
        if (!is_open) return is_below(from, to);
        const bool is_beside =
            from.x * to.x > 0.0 && std::min(std::abs(from.x), std::abs(to.x)) > half * mm;
        return is_beside && from.y >= 0.0 && to.y < 0.0;
    };
    // The two lines there and back, joined out of the hand's reach.
    const std::vector<Position> ring_mm = {
        left.points_mm[0],  left.points_mm[1],  left.points_mm[0],  {-50.0, -60.0}, {50.0, -60.0},
        right.points_mm[1], right.points_mm[0], right.points_mm[1], {50.0, -60.0},  {-50.0, -60.0}};
    return made({"gaps",
                 fmt::format("{:g} mm", width_mm),
                 corners({ring_mm, true}),
                 {left, right},
                 through({{0, 0, 10}, {.3, 0, -6}}),
                 0.8,
                 is_through},
                5e-5);
}

Torture tremor(double frequency_Hz, double amplitude_mm) {
    const auto path = [=](double t) -> Intention {
        const double omega = 2.0 * pi * frequency_Hz;
        // 2 mm deep, because friction would hold a light hand outside that aims 1 mm deep.
        const double down_mm = 3.0 - 5.0 * std::min(1.0, t / 0.2);
        const double shake = t < 2.5 ? amplitude_mm : 0.0;
        return {
            {mm * shake * std::sin(0.83 * omega * t), mm * (down_mm + shake * std::sin(omega * t))},
            {mm * shake * 0.83 * omega * std::cos(0.83 * omega * t),
             mm * shake * omega * std::cos(omega * t)}};
    };
    return {"tremor",
            fmt::format("{:g} Hz {:g} mm", frequency_Hz, amplitude_mm),
            there_and_back(flat_line()),
            {flat_line()},
            path,
            2.6,
            is_below};
}

/// A line more every 50 ms, each second one across the line that the hand goes along.
LoopScenario growing_drawing() {
    LoopScenario scenario = made(flat("a drawing that grows", "20 lines", {flat_line()}, {}));
    auto maps = std::make_shared<std::vector<Scene>>();
    std::vector<Polyline> lines{flat_line()};
    for (int i = 0; i < 20; ++i) {
        maps->push_back(scene_of_edges(lines));
        maps->back().map_version = static_cast<std::uint64_t>(i) + 1;
        maps->back().drawing = 1;
        const double x_mm = -40.0 + 4.0 * i;
        lines.push_back({{{x_mm, i % 2 == 0 ? 3.0 : -20.0}, {x_mm + 3.0, 20.0}}});
    }
    scenario.scene_at = [maps](double t_s) {
        return &(*maps)[std::min(static_cast<std::size_t>(t_s / 0.05), maps->size() - 1)];
    };
    return scenario;
}

std::vector<LoopScenario> all_scenarios() {
    std::vector<LoopScenario> all;
    for (const Torture& torture : bench::tortures()) all.push_back(made(torture));
    const Polyline line = flat_line();
    const Polyline reversed{{line.points_mm.back(), line.points_mm.front()}};
    all.push_back(made(flat("flat lines", "one", {line}, there_and_back(line))));
    all.push_back(made(flat("flat lines", "doubled", {line, reversed}, there_and_back(line))));
    // One curve of whole edges cannot have edges without length.
    all.push_back(made(flat("flat lines", "100 000 pieces", {scenarios::cut_line()}, {})));
    for (const double speed : {0.1, 0.25, 0.5, 1.0, 3.0}) all.push_back(made(swipe(speed)));
    for (const double interior : {150.0, 120.0, 90.0, 60.0, 30.0})
        all.push_back(made(convex_vertex(interior)));
    for (const int vertices : {16, 64, 256}) all.push_back(made(polygon(vertices)));
    using scenarios::strand;
    all.push_back(strands("bent apart", strand(1, 0, -20), strand(-1, 0, -20), 0.0));
    all.push_back(strands("bent alike", strand(1, 0, -15), strand(1, -0.4, -20), 0.02));
    all.push_back(changing_circle());
    for (const double width_mm : {1e-6, 1e-3, 1e-2, 9e-2, 1.1e-1, 1.0})
        all.push_back(gap(width_mm));
    all.push_back(made(tremor(8.0, 0.05)));
    all.push_back(made(tremor(7.0, 0.18)));
    all.push_back(made(tremor(5.0, 5.0)));
    all.push_back(made(tremor(5.0, 10.0)));
    all.push_back(growing_drawing());
    return all;
}

}  // namespace

const std::vector<LoopScenario>& loop_scenarios() {
    static const std::vector<LoopScenario> all = all_scenarios();
    return all;
}

}  // namespace touchline::stability
