// Can a hand that knows nothing of the line follow a groove round?
#include "config/types/angle.h"
#include "haptics/contact/contact_machine.h"
#include "haptics/resolution/level_rule.h"
#include "tests/haptics/scenes.h"
#include "tests/haptics/tick.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iostream>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Has no mass and 3 N s/m; pushes with 0.09 N along the mean direction of its last 5 mm.
class BlindHand {
  public:
    BlindHand(Position start, Direction initial) : at_(start) {
        way_.push_back(start - along<Position>(initial, memory_m));
        way_.push_back(start);
    }

    void step(Force felt) {
        const Direction heading = direction_of(at_ - way_.front());
        const Force total = felt + along<Force>(heading, push_N);
        const Position moved = along<Position>(total, tick_s / damping_Ns_per_m);
        at_ += moved;
        way_.push_back(at_);
        length_m_ += norm(moved);
        while (true) {  // forgets its way beyond the last 5 mm
            const Position first = way_[1] - way_[0];
            const double spare_m = length_m_ - memory_m;
            if (spare_m < norm(first)) {
                if (spare_m > 0.0) way_[0] += (spare_m / norm(first)) * first;
                length_m_ = std::min(length_m_, memory_m);
                return;
            }
            length_m_ -= norm(first);
            way_.pop_front();
        }
    }

    [[nodiscard]] Position at() const { return at_; }

  private:
    static constexpr double memory_m = 5e-3;
    static constexpr double push_N = 0.09;
    static constexpr double damping_Ns_per_m = 3.0;

    std::deque<Position> way_;
    double length_m_ = memory_m;
    Position at_;
};

/// A line as stations 0.25 mm apart.
class Route {
  public:
    explicit Route(const Outline& line) {
        const std::size_t count = line.points.size();
        for (std::size_t i = 0; i + (line.is_closed ? 0 : 1) < count; ++i) {
            const Position a = line.points[i];
            const Position b = line.points[(i + 1) % count];
            const int parts = std::max(1, static_cast<int>(std::ceil(norm(b - a) / 2.5e-4)));
            for (int k = 0; k < parts; ++k) {
                stations_.push_back(a + static_cast<double>(k) / parts * (b - a));
            }
        }
        stations_.push_back(line.is_closed ? line.points.front() : line.points.back());
    }

    [[nodiscard]] int last() const { return static_cast<int>(stations_.size()) - 1; }

    [[nodiscard]] Position station(int i) const { return stations_[static_cast<std::size_t>(i)]; }

    /// Returns the nearest of the stations up to 2 mm ahead; farther ahead would be skipping.
    [[nodiscard]] int onward(int from, Position p) const {
        int best = from;
        for (int i = from; i <= std::min(last(), from + 8); ++i) {
            if (norm(station(i) - p) < norm(station(best) - p)) best = i;
        }
        return best;
    }

  private:
    std::vector<Position> stations_;
};

struct Followed {
    double mean_m = 0.0;  // distance from the station reached
    double worst_m = 0.0;
    double reached = 0.0;  // share of the line, in order
    double jump_N = 0.0;
    Position end;
    double end_speed_m_per_s = 0.0;
    int ticks = 0;
};

enum class LevelChoice { finest, by_speed };

/// Follows the line from its first point until all of it is visited in order, or time is up.
Followed follow(const Outline& line, LevelChoice choice, double longest_s) {
    const Scene scene = build_scene(scenes::map_of({line}), {}, 0.0).value();
    const Route route(line);
    LevelLimits limits;
    limits.spacing_m = scene.curves.finest_spacing_m();
    limits.safe = scene.curves.coarsest();
    limits.percept = scene.percept_level;
    LevelRule rule(limits);
    ContactSettings settings;
    settings.mode = Mode::groove;
    BlindHand hand(line.points[0], direction_of(line.points[1] - line.points[0]));
    ContactMachine machine;
    machine.reset(scene, hand.at(), 0.0);
    Followed run;
    int station = 0;
    Force force;
    const int ticks = static_cast<int>(longest_s / tick_s);
    for (; run.ticks < ticks && station < route.last(); ++run.ticks) {
        const Position before = hand.at();
        hand.step(force);
        const double moved_m = norm(hand.at() - before);
        const double level = choice == LevelChoice::finest ? 0.0 : rule.step(hand.at(), tick_s);
        const Force now = machine.step(hand.at(), level, settings, {}).force;
        run.jump_N =
            std::max(run.jump_N, norm(now - force) - 3.0 * settings.stiffness_N_per_m * moved_m);
        force = now;
        station = route.onward(station, hand.at());
        const double distance_m = norm(hand.at() - route.station(station));
        run.mean_m += distance_m;
        run.worst_m = std::max(run.worst_m, distance_m);
        run.end_speed_m_per_s = moved_m / tick_s;
    }
    run.mean_m /= std::max(1, run.ticks);
    run.reached = static_cast<double>(station) / route.last();
    run.end = hand.at();
    return run;
}

/// A closed polygon with its corners rounded to a radius, in steps of 5 degrees; begins in the
/// middle of a side.
Outline rounded(const std::vector<Position>& corners, double radius_m) {
    const std::size_t count = corners.size();
    std::vector<Position> points{0.5 * (corners[count - 1] + corners[0])};
    for (std::size_t i = 0; i < count; ++i) {
        const Position corner = corners[i];
        const Direction in = direction_of(corner - corners[(i + count - 1) % count]);
        const Direction out = direction_of(corners[(i + 1) % count] - corner);
        const double turn = std::atan2(cross(in, out), dot(in, out));
        const double cut_m = radius_m * std::tan(0.5 * std::abs(turn));
        const Position begin = corner - along<Position>(in, cut_m);
        const Direction to_centre = (turn > 0.0 ? 1.0 : -1.0) * left_of(in);
        const Position centre = begin + along<Position>(to_centre, radius_m);
        const int steps = static_cast<int>(std::ceil(std::abs(turn) / (std::numbers::pi / 36.0)));
        for (int k = 0; k <= steps; ++k) {
            const double angle = turn * k / steps;
            const Direction spoke{-std::cos(angle) * to_centre.x + std::sin(angle) * to_centre.y,
                                  -std::sin(angle) * to_centre.x - std::cos(angle) * to_centre.y};
            points.push_back(centre + along<Position>(spoke, radius_m));
        }
    }
    return scenes::outline(std::move(points), true);
}

std::vector<Position> star(double outer_m, double inner_m) {
    std::vector<Position> corners;
    for (int i = 0; i < 10; ++i) {
        const double angle = std::numbers::pi * i / 5.0;
        const double r = i % 2 == 0 ? outer_m : inner_m;
        corners.push_back(r * Position{std::cos(angle), std::sin(angle)});
    }
    return corners;
}

Outline spiral() {
    std::vector<Position> points;
    for (int i = 0; i <= 720; ++i) {
        const double angle = 6.0 * std::numbers::pi * i / 720.0;
        const double r = 0.008 + 0.024 * i / 720.0;
        points.push_back(r * Position{std::cos(angle), std::sin(angle)});
    }
    return scenes::outline(std::move(points), false);
}

struct Named {
    const char* name;
    Outline line;
};

// Corners are rounded to 2 mm, as rules for tactile graphics ask.
std::vector<Named> shapes() {
    const std::vector<Position> square{{0.02, -0.02}, {0.02, 0.02}, {-0.02, 0.02}, {-0.02, -0.02}};
    return {{"circle", scenes::circle(0.02, 256)},
            {"square", rounded(square, 0.002)},
            {"star", rounded(star(0.03, 0.014), 0.002)},
            {"spiral", spiral()}};
}

TEST(BlindHand, FollowsAGrooveRoundCircleSquareStarAndSpiral) {
    for (const Named& shape : shapes()) {
        for (const LevelChoice choice : {LevelChoice::finest, LevelChoice::by_speed}) {
            const Followed run = follow(shape.line, choice, 60.0);
            std::cout << "  " << shape.name << ": mean " << 1e3 * run.mean_m << " mm, at most "
                      << 1e3 * run.worst_m << " mm, " << 100.0 * run.reached << " % in "
                      << run.ticks * tick_s << " s, jump " << run.jump_N << " N\n";
            EXPECT_LE(run.mean_m, 0.001) << shape.name;
            EXPECT_LE(run.worst_m, 0.002) << shape.name;
            EXPECT_EQ(run.reached, 1.0) << shape.name;
            EXPECT_LE(run.jump_N, 0.03) << shape.name;
        }
    }
}

/// A bend between two sides of 30 mm, with a sharp vertex.
Outline bend(double turn_rad) {
    const Position out = 0.03 * Position{std::cos(turn_rad), std::sin(turn_rad)};
    return scenes::outline({{-0.03, 0.0}, {0.0, 0.0}, out}, false);
}

TEST(BlindHand, PassesSharpCornersThatTurnByLessThanARightAngle) {
    for (const double degrees : {15.0, 30.0, 45.0, 60.0, 75.0, 85.0}) {
        const Followed run = follow(bend(radians(degrees)), LevelChoice::finest, 60.0);
        EXPECT_EQ(run.reached, 1.0) << degrees;
        EXPECT_LE(run.worst_m, 0.002) << degrees;
    }
}

TEST(BlindHand, ComesToRestAtASharpTip) {
    for (const double degrees : {120.0, 135.0, 144.0, 160.0}) {
        const Followed run = follow(bend(radians(degrees)), LevelChoice::finest, 10.0);
        std::cout << "  turn " << degrees << ": rests " << 1e3 * norm(run.end)
                  << " mm from the tip\n";
        EXPECT_LE(norm(run.end), 0.001) << degrees;
        EXPECT_LE(run.end_speed_m_per_s, 1e-4) << degrees;
        EXPECT_LE(run.jump_N, 0.03) << degrees;
        EXPECT_LE(run.reached, 0.51) << degrees;  // skipped nothing beyond the tip
    }
}

}  // namespace
}  // namespace touchline
