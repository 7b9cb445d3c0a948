#include "tests/lab/bench/probe/turning_hand.h"

#include "tests/lab/bench/collision/touchline_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchline::bench {
namespace {

constexpr double step_s = 1e-3;

constexpr double clear_of_curve_m = 0.08;  // from the middle: both curves end before 60 mm

/// Returns a pose clear of the curve, in the direction of the hand.
ProbePose taken_up(const ProbePose& hand) {
    const double share = clear_of_curve_m / std::hypot(hand.x_m, hand.y_m);
    return {hand.x_m * share, hand.y_m * share, hand.angle_rad};
}

}  // namespace

std::vector<ProbePose> turning_hand(workload::Kind kind, std::size_t steps) {
    std::vector<ProbePose> poses;
    poses.reserve(steps);
    for (const Position at : workload::hand(kind, steps)) {
        const double t_s = step_s * static_cast<double>(poses.size());
        const double angle_rad = 1.1 * std::sin(1.7 * t_s) + 0.4 * std::sin(3.1 * t_s);
        poses.push_back({at.x, at.y, angle_rad});
    }
    return poses;
}

ProbeShape regular_shape(double radius_m, int edges) {
    const auto corner = [&](int i) {
        const double angle_rad = 2.0 * std::numbers::pi * (i % edges) / edges;
        return Position{radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad)};
    };
    std::vector<Segment> outline;
    for (int i = 0; i < edges; ++i) outline.push_back({corner(i), corner(i + 1)});
    return ProbeShape::build(std::move(outline), 0.0).value();
}

TurningRun run_shape(const Scene& scene, const ProbeShape& shape,
                     const std::vector<ProbePose>& hand, std::optional<double> level, int passes) {
    std::vector<std::uint64_t> least(hand.size(), UINT64_MAX);
    TurningRun run;
    ProbeProxy proxy;
    for (int pass = 0; pass < passes; ++pass) {
        ShapeLevelRule rule(limits_of(scene.curves), shape.r_max_m());
        proxy.reset(shape, scene, taken_up(hand.front()), level.value_or(0.0));
        bool is_at_hand = false;
        for (std::size_t i = 0; i < hand.size(); ++i) {
            const ProbePose& at = hand[i];
            const std::uint64_t begin = ticks();
            const double wanted =
                level ? *level : rule.step({at.x_m, at.y_m}, at.angle_rad, step_s);
            const ProbeReport report = proxy.step(at, wanted, {}, {});
            const std::uint64_t cost = ticks() - begin;
            const bool is_near = norm(report.pose.place() - at.place()) <= slip_m;
            const bool is_slip = is_at_hand && !is_near;
            if (is_at_hand) least[i] = std::min(least[i], cost);
            if (is_slip) proxy.reset(shape, scene, taken_up(at), wanted);
            is_at_hand = is_near;
            if (pass > 0) continue;
            run.proxies.push_back(report.pose);
            run.slip_offs += is_slip ? 1U : 0U;
            if (is_slip) run.first_slip = std::min(run.first_slip, i);
            run.boxes_max = std::max(run.boxes_max, static_cast<std::size_t>(report.boxes));
        }
    }
    std::erase(least, UINT64_MAX);
    run.least_ticks = std::move(least);
    return run;
}

}  // namespace touchline::bench
