#include "app/cli/feel_shape.h"

#include "app/cli/load.h"
#include "app/cli/names.h"
#include "config/types/steady_clock.h"
#include "haptics/probe/held_shapes.h"
#include "haptics/resolution/cost_term.h"
#include "haptics/resolution/shape_level_rule.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr double least_carried_m = 1e-9;  // a smaller rest is rounding, no lack of time

ProbePose pose_of(const HandRow& row) {
    return {row.p_WH.x, row.p_WH.y, row.angle_rad};
}

/// One line of RUN.csv. Numbers read back to the same bits.
void write_row(fmt::memory_buffer& out, const CurveSet& curves, const HandRow& hand,
               const ProbeReport& report) {
    auto to = std::back_inserter(out);
    const ContactReport contact = contact_of(report, curves);
    fmt::format_to(to, "{},{},{},{},{},{},{},{},{},", hand.t_s, hand.p_WH.x, hand.p_WH.y,
                   report.pose.x_m, report.pose.y_m, report.force.x, report.force.y,
                   name_of(report.state), report.level);
    if (contact.outline < 0) {
        fmt::format_to(to, ",,,");
    } else {
        fmt::format_to(to, "{},{},{},", contact.outline, contact.parameter,
                       contact.side == Side::left ? "left" : "right");
    }
    for (int i = 0; i < report.transitions.size(); ++i) {
        fmt::format_to(to, "{}{}", i == 0 ? "" : ">", static_cast<int>(report.transitions[i]));
    }
    fmt::format_to(to, ",{},{},{},{},{},{}", report.carried_m, report.boxes, report.clear,
                   hand.angle_rad, report.pose.angle_rad, report.torque_Nm);
}

}  // namespace

Result<ProbeShape> load_shape(const FeelOptions& options) {
    return load_map(options.probe, false).and_then([&options](const TactileMap& map) {
        return ProbeShape::of_map(map, options.contact.radius_m)
            .map_error([&options](const Error& error) {
                return Error{fmt::format("{}: {}", options.probe, error.line)};
            });
    });
}

std::string feel_shape(const Scene& scene, const ProbeShape& shape, const FeelOptions& options,
                       LevelLimits limits, const std::vector<HandRow>& hand) {
    fmt::memory_buffer out;
    fmt::format_to(std::back_inserter(out),
                   "t_s,x_m,y_m,proxy_x_m,proxy_y_m,fx_N,fy_N,state,level,outline,parameter,side,"
                   "transitions,carried_m,nodes,clear,angle_rad,proxy_angle_rad,torque_Nm{}\n",
                   options.with_timing ? ",step_ns" : "");
    const double period_s = hand.size() > 1 ? hand[1].t_s - hand[0].t_s : first_period_s;
    const double coarsest = scene.curves.coarsest();
    const ProbeSettings settings{options.contact.stiffness_N_per_m, 0.0};
    CostTerm cost(period_s);
    ShapeLevelRule rule(limits, shape.r_max_m());
    ProbeProxy proxy;
    double level = options.level ? std::min(*options.level, coarsest) : 0.0;
    for (std::size_t i = 0; i < hand.size(); ++i) {
        const double dt_s = i > 0 ? hand[i].t_s - hand[i - 1].t_s : first_period_s;
        const std::int64_t begin_ns = options.with_timing ? steady_now_ns() : 0;
        if (!options.level) level = rule.step(hand[i].p_WH, hand[i].angle_rad, dt_s);
        if (i == 0) proxy.reset(shape, scene, pose_of(hand[0]), level);
        const ProbeReport report =
            proxy.step(pose_of(hand[i]), level, settings, budget_of(options), dt_s);
        limits.cost = cost.step({report.boxes, report.carried_m > least_carried_m}, report.level);
        rule.set_limits(limits);
        const std::int64_t step_ns = options.with_timing ? steady_now_ns() - begin_ns : 0;
        write_row(out, scene.curves, hand[i], report);
        if (options.with_timing) fmt::format_to(std::back_inserter(out), ",{}", step_ns);
        out.push_back('\n');
    }
    return fmt::to_string(out);
}

}  // namespace touchline
