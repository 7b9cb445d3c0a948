// What a build in float would get wrong before it computed anything. Takes the proxies of the servo
// step in double, rounds them to float, and checks on which side of the line they are then. Prints
// Markdown.
#include "haptics/collision/touch.h"
#include "tests/exact/orientation.h"
#include "tests/lab/bench/collision/brute_force.h"
#include "tests/lab/bench/instructions/servo_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/core.h>

namespace touchline::bench {
namespace {

/// Converts one number at a time, by a call. Where GCC 12 converts two doubles to float and back at
/// once (-ftree-slp-vectorize, on at -O2), it leaves both conversions out.
[[gnu::noinline]] double as_float(double x) {
    return static_cast<double>(static_cast<float>(x));
}

Position as_float(Position p) {
    return {as_float(p.x), as_float(p.y)};
}

std::vector<Position> as_float(std::vector<Position> points) {
    for (Position& p : points) p = as_float(p);
    return points;
}

/// A proxy held by the line, and the way off the line: from the hand to the proxy.
struct Held {
    Position proxy;
    Direction off;
};

std::vector<Held> held_proxies(const Scene& scene, const std::vector<Position>& hand) {
    std::vector<Held> held;
    Servo servo = start(scene, LevelChoice::finest, hand[0]);
    for (const Position at : hand) {
        touchline_servo_step(servo, at);
        expect_held(servo, at);
        const Position gap = servo.report.p_WP - at;
        const double gap_m = norm(gap);
        if (servo.report.state == ContactState::free || gap_m == 0.0) continue;
        held.push_back({servo.report.p_WP, {gap.x / gap_m, gap.y / gap_m}});
    }
    return held;
}

/// The hand begins outside the curve, so a proxy inside is on the wrong side.
template <class Rounding>
std::size_t wrong_sides(const std::vector<Held>& held, double farther_m, const Inside& is_inside,
                        const Rounding& rounding) {
    return static_cast<std::size_t>(std::count_if(held.begin(), held.end(), [&](const Held& h) {
        const Position off{h.off.x * farther_m, h.off.y * farther_m};
        return is_inside(rounding(h.proxy + off));
    }));
}

/// Counts the corners that turn the other way, or not at all, once their points are rounded.
std::size_t turned_corners(const std::vector<Position>& points,
                           const std::vector<Position>& rounded) {
    const std::size_t n = points.size();
    std::size_t turned = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto turn = [&](const std::vector<Position>& at) {
            return exact::orientation(at[i], at[(i + 1) % n], at[(i + 2) % n]);
        };
        turned += turn(points) != turn(rounded) ? 1U : 0U;
    }
    return turned;
}

double largest_coordinate_m(const std::vector<Position>& points) {
    double largest_m = 0.0;
    for (const Position p : points) {
        largest_m = std::max({largest_m, std::abs(p.x), std::abs(p.y)});
    }
    return largest_m;
}

double float_step_m(double at_m) {
    const auto value = static_cast<float>(at_m);
    const float next = std::nextafter(value, std::numeric_limits<float>::max());
    return static_cast<double>(next) - static_cast<double>(value);
}

void print_row(std::size_t edges, const std::vector<Position>& hand) {
    const auto points = workload::curve(workload::Kind::radial, edges);
    const auto rounded = as_float(points);
    const Scene scene = radial_scene(edges);
    const auto held = held_proxies(scene, hand);
    const Inside is_inside(points);
    const Inside is_inside_rounded(rounded);
    const auto in_double = [](Position p) { return p; };
    const auto in_float = [](Position p) { return as_float(p); };
    fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} |\n", edges, held.size(),
               wrong_sides(held, 0.0, is_inside, in_double),
               wrong_sides(held, 0.0, is_inside, in_float),
               wrong_sides(held, 0.0, is_inside_rounded, in_float),
               wrong_sides(held, 1e-9, is_inside, in_float),
               wrong_sides(held, 1e-8, is_inside, in_float), turned_corners(points, rounded));
}

void print_words(const std::vector<Position>& points) {
    const double largest_m = largest_coordinate_m(points);
    const double step_m = float_step_m(largest_m);
    double length_m = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        length_m += norm(points[(i + 1) % points.size()] - points[i]);
    }
    fmt::print(
        "\nIn words: at {:.0f} mm, the curve's farthest coordinate, one step of a float is "
        "{:.1f} nm; the contact skin is {:.0f} pm,\n"
        "{:.0f} times less. An edge of the curve of {} edges is {:.1f} um long on average.\n",
        largest_m * 1e3, step_m * 1e9, contact_skin_m * 1e12, step_m / contact_skin_m,
        points.size(), length_m / static_cast<double>(points.size()) * 1e6);
}

}  // namespace
}  // namespace touchline::bench

int main() {
    using namespace touchline;
    const auto hand =
        workload::hand(workload::Kind::radial, bench::warm_up_steps + bench::counted_steps);
    fmt::print(
        "| edges | steps held by the line | wrong side in double | proxy in float "
        "| proxy and line in float | float, 1 nm farther off | float, 10 nm farther off "
        "| corners whose turn changes |\n|---|---|---|---|---|---|---|---|\n");
    for (const std::size_t edges : {512U, 4096U, 65536U}) bench::print_row(edges, hand);
    bench::print_words(workload::curve(workload::Kind::radial, 65536));
    return 0;
}
