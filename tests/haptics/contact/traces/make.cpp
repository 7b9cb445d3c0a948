// contact_traces_make writes the reference traces anew. Run it after an intended change of the
// machine; what git then shows as changed is what the hand would feel.
#include "tests/haptics/contact/traces/hands.h"
#include "tests/haptics/contact/traces/trace.h"
#include "tests/haptics/scenes.h"
#include "tests/lab/bench/workload.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>

namespace touchline::traces {
namespace {

// Lines

constexpr double pitch_m = 4e-3;
constexpr double exact_m =
    0x1p-8;  // whole nanometres, as is its half: nothing on that grid is rounded

/// Short lines between points of a grid: they share ends, cross, lie in one another and run back.
TactileMap lattice() {
    Chance chance(3);
    std::vector<Outline> made;
    for (int i = 0; i < 12; ++i) {
        std::vector<Position> points;
        const int count = 2 + chance.below(3);
        while (static_cast<int>(points.size()) < count) {
            const Position p =
                pitch_m * Position{chance.below(7) - 3.0, static_cast<double>(chance.below(5) - 2)};
            if (points.empty() || p != points.back()) points.push_back(p);
        }
        made.push_back(
            scenes::outline(points, count > 2 && points[0] != points.back() && i % 3 == 0));
    }
    return scenes::map_of(made);
}

/// Lines of equal steps along a grid, whose lengths, depths and angles are equal to the last bit.
TactileMap steps() {
    Chance chance(8);
    std::vector<Outline> made;
    for (int i = 0; i < 5; ++i) {
        Position at{chance.below(9) - 4.0, chance.below(7) - 3.0};
        std::vector<Position> points{exact_m * at};
        while (points.size() < 26) {
            const double way = chance.unit() < 0.5 ? 1.0 : -1.0;
            const Position next =
                at + (chance.unit() < 0.5 ? Position{way, 0.0} : Position{0.0, way});
            if (std::abs(next.x) > 6.0 || std::abs(next.y) > 4.0) continue;
            at = next;
            points.push_back(exact_m * at);
        }
        made.push_back(scenes::outline(points, false));
    }
    return scenes::map_of(made);
}

/// Sharp tips, a line that runs back on itself, open ends, a notch.
TactileMap tips() {
    std::vector<Position> star;
    for (int i = 0; i < 14; ++i) {
        const double angle = 0.45 * i;
        star.push_back((i % 2 == 0 ? 0.02 : 0.004) * Position{std::cos(angle), std::sin(angle)});
    }
    return scenes::map_of(
        {scenes::outline(star, true),
         scenes::outline(
             {{-0.04, 0.02}, {-0.03, 0.022}, {-0.022, 0.02}, {-0.03, 0.022}, {-0.035, 0.03}},
             false),
         scenes::outline({{-0.04, -0.02}, {-0.03, -0.021}, {-0.0396, -0.0215}}, false),
         scenes::outline(
             {{0.03, 0.02}, {0.04, 0.02}, {0.0401, 0.03}, {0.033, 0.029}, {0.034, 0.022}}, false)});
}

/// Lines side by side and across, a line in many collinear pieces, a square, a circle.
TactileMap bars() {
    std::vector<Position> straight;
    for (int i = 0; i <= 60; ++i) straight.push_back({-0.03 + 1e-3 * i, 0.001});
    Outline square = scenes::square(0.012, 8);
    for (Position& p : square.points) p += Position{0.0371, -0.0213};
    Outline circle = scenes::circle(0.009, 48);
    for (Position& p : circle.points) p += Position{-0.0307, -0.0219};
    return scenes::map_of({scenes::outline(straight, false),
                           scenes::outline({{-0.03, -0.0011}, {0.031, -0.0009}}, false),
                           scenes::outline({{-0.012, -0.03}, {0.0093, 0.031}}, false),
                           scenes::outline({{0.014, 0.03}, {0.0141, -0.004}}, false), square,
                           circle});
}

std::map<std::string, TactileMap> all_lines() {
    return {{"tangle", scenes::random_map(5, 12)},
            {"knot", scenes::random_map(11, 16)},
            {"lattice", lattice()},
            {"steps", steps()},
            {"tips", tips()},
            {"bars", bars()},
            {"ring", scenes::rough_ring(3, 2e-4)},
            {"coast", workload::map_of(workload::curve(workload::Kind::fractal, 1024))}};
}

// Cases

struct Case {
    Trace trace;
    Hand hand;
    std::vector<Mode> modes;
    std::vector<double> levels;
};

constexpr Hand slow{0.05};
constexpr Hand brisk{0.3, 1e-3};
constexpr Hand leaping{0.0, 3e-3, 0.0, 48, 0.08, 0.0};
constexpr Hand still{0.005, 4e-4, 0.0, 48, 0.2};
constexpr Hand pressing{0.005, 8e-3, 0.0, 96, 0.08, 0.985};
constexpr Hand far{0.05, 0.1, 0.0, 192};
constexpr Hand on_grid{0.0, 3e-3, 0.5 * pitch_m, 48, 0.08, 0.0};
const std::vector<double> finest{0.0};
const std::vector<double> between{1.5};
const std::vector<double> gentle{0.0, 0.3, 0.6, 1.0, 1.3, 1.7, 2.0, 2.5, 3.0};
const std::vector<double> changing{0.0, 1.0, 1.4, 2.0, 2.75, 3.5, 5.0};

ContactSettings wall(double friction, double radius_m, double pop_through_N = 0.0) {
    ContactSettings settings;
    settings.friction = friction;
    settings.radius_m = radius_m;
    settings.pop_through_N = pop_through_N;
    settings.pop_through_s = 0.02;
    return settings;
}

void add_walls(std::vector<Case>& cases) {
    const std::vector<Mode> walls{Mode::wall};
    for (const char* const lines : {"tangle", "knot", "tips", "bars"}) {
        const std::string name = lines;
        cases.push_back({{name + "_point", name, wall(0.0, 0.0)}, slow, walls, finest});
        cases.push_back({{name + "_levels", name, wall(0.2, 0.0)}, slow, walls, changing});
        cases.push_back({{name + "_disc", name, wall(0.1, 1e-3)}, slow, walls, between});
        cases.push_back({{name + "_disc_levels", name, wall(0.0, 1e-3)}, slow, walls, changing});
        cases.push_back({{name + "_leaps", name, wall(0.1, 0.0)}, leaping, walls, changing});
        cases.push_back({{name + "_disc_leaps", name, wall(0.1, 2e-3)}, leaping, walls, finest});
    }
    for (const double radius_m : {0.0, 1e-3}) {
        const std::string suffix = radius_m > 0.0 ? "_disc" : "";
        cases.push_back(
            {{"lattice_grid" + suffix, "lattice", wall(0.0, radius_m)}, on_grid, walls, finest});
        cases.push_back(
            {{"lattice_rough" + suffix, "lattice", wall(0.3, radius_m)}, on_grid, walls, finest});
        cases.push_back(
            {{"coast_brisk" + suffix, "coast", wall(0.0, radius_m)}, brisk, walls, finest});
        cases.push_back(
            {{"coast_rough" + suffix, "coast", wall(0.3, radius_m)}, brisk, walls, finest});
        cases.push_back(
            {{"coast_levels" + suffix, "coast", wall(0.1, radius_m)}, brisk, walls, changing});
        cases.push_back(
            {{"ring_levels" + suffix, "ring", wall(0.1, radius_m)}, slow, walls, changing});
    }
    cases.push_back({{"ring_pops", "ring", wall(0.0, 0.0, 0.3)}, slow, walls, finest});
    cases.push_back({{"tips_pops", "tips", wall(0.0, 5e-4, 0.3)}, slow, walls, changing});
    cases.push_back({{"lattice_levels", "lattice", wall(0.1, 5e-4)}, on_grid, walls, changing});
    cases.push_back(
        {{"lattice_levels_disc", "lattice", wall(0.0, 1e-3)}, on_grid, walls, changing});
    cases.push_back({{"lattice_again", "lattice", wall(0.1, 0.0)}, on_grid, walls, finest});
    cases.push_back({{"lattice_again_disc", "lattice", wall(0.1, 3e-3)}, on_grid, walls, finest});
    cases.push_back({{"knot_few_boxes", "knot", wall(0.1, 1e-3), 40}, slow, walls, changing});
    cases.push_back({{"coast_few_boxes", "coast", wall(0.0, 0.0), 24}, leaping, walls, between});
}

void add_still_hands(std::vector<Case>& cases) {
    const std::vector<Mode> walls{Mode::wall};
    for (const char* const lines : {"tangle", "knot", "tips", "coast", "ring", "lattice"}) {
        const std::string name = lines;
        cases.push_back({{name + "_still", name, wall(0.1, 0.0)}, still, walls, gentle});
        cases.push_back({{name + "_still_disc", name, wall(0.0, 1e-3)}, still, walls, gentle});
    }
    constexpr Hand nestling{0.005, 1.5e-3, 0.0, 64, 0.2};
    for (const char* const lines : {"tangle", "knot", "coast", "ring"}) {
        const std::string name = lines;
        for (const double radius_m : {5e-4, 2e-3}) {
            ContactSettings soft = wall(radius_m > 1e-3 ? 0.2 : 0.0, radius_m);
            soft.stiffness_N_per_m = 50.0;
            const char* const size = radius_m > 1e-3 ? "_large" : "_small";
            cases.push_back({{name + "_soft" + size, name, soft}, nestling, walls, gentle});
        }
    }
    cases.push_back({{"knot_still_few_boxes", "knot", wall(0.0, 1e-3), 30}, still, walls, gentle});
    cases.push_back(
        {{"tangle_still_few_boxes", "tangle", wall(0.1, 0.0), 20}, still, walls, gentle});
    for (const char* const lines : {"bars", "knot", "tips", "coast"}) {
        const std::string name = lines;
        cases.push_back({{name + "_pressed", name, wall(0.1, name == "knot" ? 4e-4 : 0.0, 0.2)},
                         pressing,
                         walls,
                         finest});
    }
}

void add_exact_hands(std::vector<Case>& cases) {
    const std::vector<Mode> walls{Mode::wall};
    constexpr Hand exact{0.0, 3e-3, 0.5 * exact_m, 48, 0.08, 0.0};
    for (const double radius_m : {0.0, 0.25 * exact_m, 0.5 * exact_m}) {
        for (const double friction : {0.0, 0.5}) {
            const std::string name = "steps_" + std::to_string(std::lround(1e6 * radius_m)) +
                                     (friction > 0.0 ? "_rough" : "");
            for (const char* const again : {"", "_again"}) {
                cases.push_back(
                    {{name + again, "steps", wall(friction, radius_m)}, exact, walls, finest});
            }
        }
    }
    ContactSettings ties;
    ties.capture_m = exact_m;
    cases.push_back({{"steps_groove", "steps", ties}, exact, {Mode::groove}, finest});
    cases.push_back({{"steps_ridge", "steps", ties}, exact, {Mode::ridge}, {0.0, 1.0}});
    cases.push_back({{"steps_stay", "steps", ties}, exact, {Mode::stay}, finest});
    ContactSettings giving = wall(0.0, 0.0, 500.0 * 0.5 * exact_m);
    giving.pop_through_s = 2e-3;
    cases.push_back({{"steps_pops", "steps", giving}, exact, walls, finest});
}

void add_ties(std::vector<Case>& cases) {
    const std::pair<const char*, Mode> ties[] = {
        {"groove", Mode::groove}, {"ridge", Mode::ridge}, {"stay", Mode::stay}};
    for (const auto& [name, tie] : ties) {
        for (const char* const lines : {"bars", "knot"}) {
            const std::string start = std::string(lines) + "_" + name;
            cases.push_back({{start, lines, {}}, slow, {tie}, finest});
            cases.push_back({{start + "_levels", lines, {}}, slow, {tie}, changing});
        }
        cases.push_back(
            {{std::string("tangle_") + name + "_leaps", "tangle", {}}, leaping, {tie}, changing});
    }
    const std::vector<Mode> all{Mode::wall, Mode::groove, Mode::ridge, Mode::stay};
    cases.push_back({{"tangle_modes", "tangle", wall(0.1, 1e-3)}, slow, all, changing});
    cases.push_back({{"bars_modes", "bars", wall(0.0, 0.0, 0.3)}, slow, all, finest});
    cases.push_back({{"bars_far", "bars", wall(0.0, 0.0)}, far, all, finest});
    cases.push_back({{"tangle_far", "tangle", wall(0.0, 0.0)}, far, {Mode::groove}, changing});
    cases.push_back({{"knot_groove_few_boxes", "knot", {}, 20}, slow, {Mode::groove}, finest});
}

void make() {
    write_lines(all_lines());
    std::vector<Case> cases;
    add_walls(cases);
    add_still_hands(cases);
    add_exact_hands(cases);
    add_ties(cases);
    std::vector<Trace> made;
    std::vector<std::pair<std::string, std::vector<Row>>> runs;
    unsigned seed = 0;
    for (const Case& one : cases) {
        const TactileMap map = read_lines(one.trace.lines);  // rounded as its readers get it
        runs.emplace_back(one.trace.name,
                          follow(scene_of(map, one.trace), one.trace,
                                 hand_over(map, one.hand, one.modes, one.levels, ++seed)));
        made.push_back(one.trace);
    }
    write_traces(made);
    write_ticks(runs);
}

}  // namespace
}  // namespace touchline::traces

int main() {
    try {
        touchline::traces::make();
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "%s\n", fault.what());
        return 1;
    }
    return 0;
}
