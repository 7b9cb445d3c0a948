#include "tests/lab/bench/instructions/servo_steps.h"

#include "tests/lab/bench/collision/touchline_rows.h"

#include <cstdlib>
#include <utility>

#include <fmt/core.h>

namespace touchline::bench {

Scene radial_scene(std::size_t edges) {
    const auto map = workload::map_of(workload::curve(workload::Kind::radial, edges));
    auto scene = build_scene(map, {}, 0.0);
    if (!scene) {
        fmt::print(stderr, "no scene of {} edges can be built\n", edges);
        std::exit(EXIT_FAILURE);
    }
    return std::move(*scene);
}

Servo start(const Scene& scene, LevelChoice choice, Position hand) {
    Servo servo{LevelRule(limits_of(scene.curves)), choice, {}, {}, {}};
    servo.machine.reset(scene, hand, 0.0);
    return servo;
}

void expect_held(const Servo& servo, Position hand) {
    if (norm(servo.report.p_WP - hand) <= slip_m) return;
    fmt::print(stderr, "the hand slipped off: nothing is counted\n");
    std::exit(EXIT_FAILURE);
}

}  // namespace touchline::bench

void touchline_servo_step(touchline::bench::Servo& servo, const touchline::Position& hand) {
    constexpr double step_s = 1e-3;
    const bool is_automatic = servo.choice == touchline::bench::LevelChoice::automatic;
    const double level = is_automatic ? servo.rule.step(hand, step_s) : 0.0;
    servo.report = servo.machine.step(hand, level, servo.settings, {});
}
