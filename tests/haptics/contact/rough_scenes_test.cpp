// Scenes rougher than any picture: corners on a grid of 1 mm, lines on lines and back on
// themselves, sharp tips, T junctions, repeated points; a hand at up to 1 m/s that also jumps.
#include "tests/haptics/contact/step_rules.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double grid_m = 1e-3;
constexpr int half_width = 12;  // of the drawing, in grid units
constexpr int scenes_a_case = 12;
constexpr int steps_a_scene = 3500;

class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}

    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(engine_); }

    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }

    Position place() {
        return grid_m * Position{static_cast<double>(below(2 * half_width + 1) - half_width),
                                 static_cast<double>(below(2 * half_width + 1) - half_width)};
    }

    const Position& point_of(const Outline& outline) {
        return outline
            .points[static_cast<std::size_t>(below(static_cast<int>(outline.points.size())))];
    }

  private:
    std::mt19937 engine_;
};

Position next_corner(Random& random, Position at) {
    const Position next = at + grid_m * Position{static_cast<double>(random.below(7) - 3),
                                                 static_cast<double>(random.below(7) - 3)};
    constexpr double most_m = half_width * grid_m;
    return {std::clamp(next.x, -most_m, most_m), std::clamp(next.y, -most_m, most_m)};
}

/// Goes back over the last points, as far as all of them.
void retrace(Random& random, std::vector<Position>& points) {
    const std::size_t last = points.size() - 1;
    const auto back = static_cast<std::size_t>(random.below(static_cast<int>(points.size())));
    for (std::size_t i = 1; i <= back; ++i) points.push_back(points[last - i]);
}

/// Goes out by 4 to 8 units and back beside itself.
void add_tip(Random& random, std::vector<Position>& points) {
    const Position foot = points.back();
    const double out_m = grid_m * (4 + random.below(5)) * (random.below(2) == 0 ? 1.0 : -1.0);
    const bool is_level = random.below(2) == 0;
    points.push_back(foot + (is_level ? Position{out_m, 0.0} : Position{0.0, out_m}));
    points.push_back(foot + (is_level ? Position{0.0, grid_m} : Position{grid_m, 0.0}));
}

/// Returns a start: anywhere, on a vertex of another outline or half-way along one of its edges.
Position start_of(Random& random, const std::vector<Outline>& others) {
    const int kind = others.empty() ? 0 : random.below(3);
    if (kind == 0) return random.place();
    const Outline& other =
        others[static_cast<std::size_t>(random.below(static_cast<int>(others.size())))];
    if (kind == 1) return random.point_of(other);
    const auto i =
        static_cast<std::size_t>(random.below(static_cast<int>(other.points.size()) - 1));
    return 0.5 * (other.points[i] + other.points[i + 1]);
}

Outline rough_outline(Random& random, const std::vector<Outline>& others) {
    if (!others.empty() && random.below(6) == 0) {  // the last one again, reversed
        Outline again = others.back();
        std::reverse(again.points.begin(), again.points.end());
        return again;
    }
    std::vector<Position> points{start_of(random, others)};
    const std::size_t corners = 3 + static_cast<std::size_t>(random.below(30));
    while (points.size() < corners) {
        switch (random.below(8)) {
            case 0:
                points.push_back(points.back());
                break;
            case 1:
                retrace(random, points);
                break;
            case 2:
                add_tip(random, points);
                break;
            default:
                points.push_back(next_corner(random, points.back()));
        }
    }
    return scenes::outline(std::move(points), random.below(3) == 0);
}

TactileMap rough_map(Random& random) {
    std::vector<Outline> made;
    const int outlines = 1 + random.below(5);
    while (static_cast<int>(made.size()) < outlines) made.push_back(rough_outline(random, made));
    return scenes::map_of(std::move(made));
}

/// Wanders at up to 1 m/s, and jumps: anywhere, or exactly onto the grid.
class Hand {
  public:
    explicit Hand(Random& random) : random_(random), at_(random.place()) {}

    Position next() {
        if (random_.unit() < 0.03) heading_ = 2.0 * std::numbers::pi * random_.unit();
        if (random_.unit() < 0.02) step_m_ = std::pow(10.0, -6.0 + 3.0 * random_.unit());
        heading_ += 0.3 * (random_.unit() - 0.5);
        at_ += step_m_ * Position{std::cos(heading_), std::sin(heading_)};
        constexpr double most_m = 1.3 * half_width * grid_m;
        at_ = {std::clamp(at_.x, -most_m, most_m), std::clamp(at_.y, -most_m, most_m)};
        if (random_.unit() < 0.02) at_ = random_.place();
        if (random_.unit() < 0.01)
            at_ = random_.place() + (grid_m * random_.unit()) * Position{1, 1};
        return at_;
    }

  private:
    Random& random_;
    Position at_;
    double heading_ = 0.0;
    double step_m_ = 1e-4;
};

struct Case {
    double level;
    double radius_m;
    double friction;
};

class RoughScene : public testing::TestWithParam<Case> {};

TEST_P(RoughScene, IsFeltByTheRules) {
    const auto [level, radius_m, friction] = GetParam();
    const ContactSettings settings{Mode::wall, 500.0, friction, radius_m, 0.003};
    std::array<int, 3> seen{};
    for (unsigned seed = 0; seed < scenes_a_case; ++seed) {
        Random random(seed);
        const TactileMap map = rough_map(random);
        CurveOptions options;
        options.spacing_m = level > 0.0 ? 0.25 * grid_m : 0.0;  // else there are no coarse levels
        const Scene scene = build_scene(map, options, radius_m).value();
        const Judge judge(scene.curves, level, 2.0 * grid_m);
        Hand hand(random);
        std::vector<Position> path;
        ContactMachine machine;
        machine.record_path(&path);
        machine.reset(scene, hand.next(), level);
        for (int i = 0; i < steps_a_scene; ++i) {
            const Position handle = hand.next();
            const ProxyState before = machine.proxy();
            const ContactReport report = machine.step(handle, level, settings, {});
            const StepSeen step{scene.curves, judge,           settings, level, handle,
                                before,       machine.proxy(), report,   path};
            const char* rule = level == 0.0 ? broken_rule(step) : broken_rule_of_motion(step);
            ASSERT_EQ(rule, nullptr) << rule << ": seed " << seed << ", step " << i;
            ++seen[static_cast<std::size_t>(report.state)];
        }
    }
    for (const int steps : seen) EXPECT_GT(steps, 500);
}

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    for (const double level : {0.0, 0.4, 1.0, 1.7}) {
        for (const double radius_m : {0.0, 3e-4, 1.4e-3}) {
            for (const double friction : {0.0, 0.3}) cases.push_back({level, radius_m, friction});
        }
    }
    return cases;
}

INSTANTIATE_TEST_SUITE_P(LevelsRadiiAndFriction, RoughScene, testing::ValuesIn(all_cases()));

/// Only one of the two tips is a pin; at the other, coarse levels have a segment that is a point.
TEST(RoughScene, IsRoundedAtTheTipsOfALineThatRunsBackAtEveryLevel) {
    CurveOptions options;
    options.spacing_m = 0.25 * grid_m;
    const ContactSettings settings;
    int in_contact = 0;
    int points = 0;
    for (const Position tip : {grid_m * Position{1, 2}, {-grid_m, 3 * grid_m}, {0, -3 * grid_m}}) {
        const Position foot{0, 0};
        const TactileMap map =
            scenes::map_of({scenes::outline({foot, tip, foot, tip, foot}, false)});
        const Scene scene = build_scene(map, options, 0.0).value();
        for (double level = 0.0; level <= scene.curves.coarsest(); level += 0.5) {
            const Judge judge(scene.curves, level, 2.0 * grid_m);
            for (int piece = 0; piece < static_cast<int>(scene.curves.pieces().size()); ++piece) {
                for (int j = 0; j < scene.curves.rendered_count(piece, level); ++j) {
                    points += is_point(scene.curves.rendered_segment(piece, level, j)) ? 1 : 0;
                }
            }
            Random random(7);
            std::vector<Position> path;
            ContactMachine machine;
            machine.record_path(&path);
            machine.reset(scene, 2.0 * tip, level);
            for (int i = 0; i < 2000; ++i) {
                const Position handle = 0.2 * random.place();
                const ProxyState before = machine.proxy();
                const ContactReport report = machine.step(handle, level, settings, {});
                const char* rule = broken_rule({scene.curves, judge, settings, level, handle,
                                                before, machine.proxy(), report, path});
                ASSERT_EQ(rule, nullptr) << rule << ": level " << level << ", step " << i;
                in_contact += report.state == ContactState::free ? 0 : 1;
            }
        }
    }
    EXPECT_GT(in_contact, 2000);
    EXPECT_GT(points, 0);
}

}  // namespace
}  // namespace touchline
