#include "app/cli/commands.h"
#include "app/cli/hand_csv.h"
#include "app/cli/load.h"
#include "app/documents/decode/files.h"
#include "config/types/steady_clock.h"
#include "haptics/pantograph/profile.h"
#include "haptics/servo/rendering.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr double first_period_s = 1e-3;  // before the first row, and of a single one

Result<std::vector<HandRow>> read_hand(const std::string& path, HandColumns columns) {
    return read_text(path).and_then([&path, columns](const std::string& text) {
        return parse_hand_csv(text, columns).map_error([&path](const Error& error) {
            return Error{fmt::format("{}: {}", path, error.line)};
        });
    });
}

Result<ProbeShape> load_shape(const FeelOptions& options) {
    return load_map(options.probe, false).and_then([&options](const TactileMap& map) {
        return ProbeShape::of_map(map, options.contact.radius_m)
            .map_error([&options](const Error& error) {
                return Error{fmt::format("{}: {}", options.probe, error.line)};
            });
    });
}

/// One line of RUN.csv, without what is optional. Numbers read back to the same bits.
void write_row(fmt::memory_buffer& out, const HandRow& hand, const ContactReport& report) {
    auto to = std::back_inserter(out);
    fmt::format_to(to, "{},{},{},{},{},{},{},{},{},", hand.t_s, hand.p_WH.x, hand.p_WH.y,
                   report.p_WP.x, report.p_WP.y, report.force.x, report.force.y,
                   name_of(report.state), report.level);
    if (report.state == ContactState::free) {
        fmt::format_to(to, ",,,");
    } else {
        fmt::format_to(to, "{},{},{},", report.outline, report.parameter,
                       report.side == Side::left ? "left" : "right");
    }
    for (int i = 0; i < report.transitions.size(); ++i) {
        fmt::format_to(to, "{}{}", i == 0 ? "" : ">", static_cast<int>(report.transitions[i]));
    }
    fmt::format_to(to, ",{},{},{}", report.carried_m, report.boxes, report.clear);
}

/// The first two rows tell it.
double period_of(const std::vector<HandRow>& hand) {
    return hand.size() > 1 ? hand[1].t_s - hand[0].t_s : first_period_s;
}

/// The budget of one step of the run. A deadline counts from now.
Budget budget_of(const FeelOptions& options) {
    Budget budget;
    if (options.budget_boxes) budget.boxes = *options.budget_boxes;
    if (options.deadline_us) {
        budget.deadline_ns =
            steady_now_ns() + static_cast<std::int64_t>(*options.deadline_us * 1000.0);
    }
    return budget;
}

/// The rows of a run, stepped through the production code. With a shape in the hand, its angles and
/// its torque follow the columns of a point.
class Feeling {
  public:
    Feeling(const Scene& scene, const ProbeShape* shape, const FeelOptions& options,
            const DeviceProfile& profile, const std::vector<HandRow>& hand)
        : scene_(scene), options_(options), hand_(hand), rendering_(profile, period_of(hand)) {
        rendering_.begin(&scene, options.contact.radius_m,
                         shape == nullptr ? HeldProbe{} : HeldProbe{shape, &proxy_});
        bound_level();
    }

    std::string run() {
        fmt::memory_buffer out;
        const bool has_shape = rendering_.holds_shape();
        fmt::format_to(
            std::back_inserter(out),
            "t_s,x_m,y_m,proxy_x_m,proxy_y_m,fx_N,fy_N,state,level,outline,parameter,side,"
            "transitions,carried_m,nodes,clear{}{}\n",
            has_shape ? ",angle_rad,proxy_angle_rad,torque_Nm" : "",
            options_.with_timing ? ",step_ns" : "");
        for (std::size_t i = 0; i < hand_.size(); ++i) {
            const std::int64_t begin_ns = options_.with_timing ? steady_now_ns() : 0;
            const Rendered rendered = step(i);
            const std::int64_t step_ns = options_.with_timing ? steady_now_ns() - begin_ns : 0;
            write_row(out, hand_[i], rendered.contact);
            if (has_shape)
                fmt::format_to(std::back_inserter(out), ",{},{},{}", hand_[i].angle_rad,
                               rendered.angle_rad, rendered.twist_Nm);
            if (options_.with_timing) fmt::format_to(std::back_inserter(out), ",{}", step_ns);
            out.push_back('\n');
        }
        return fmt::to_string(out);
    }

  private:
    Rendered step(std::size_t row) {
        const HandRow& hand = hand_[row];
        const ProbePose handle{hand.p_WH.x, hand.p_WH.y, hand.angle_rad};
        const double dt_s = row > 0 ? hand.t_s - hand_[row - 1].t_s : first_period_s;
        const double level = wanted_level(handle, dt_s);
        if (row == 0) rendering_.place(handle, level);
        const bool is_placed_only = row == 0 && !rendering_.holds_shape();
        const Rendered rendered = is_placed_only ? place_point(handle.place(), level)
                                                 : rendering_.step(handle, level, options_.contact,
                                                                   budget_of(options_), dt_s);
        bound_level();
        return rendered;
    }

    /// The first row of a point: the proxy is at the handle, free. On a line it is beside it, by
    /// the contact skin.
    Rendered place_point(Position handle, double level) {
        Rendered placed;
        placed.contact.p_WP = rendering_.proxy();
        placed.contact.force =
            along<Force>(placed.contact.p_WP - handle, options_.contact.stiffness_N_per_m);
        placed.contact.level = level;
        rendering_.skip_step();
        return placed;
    }

    double wanted_level(const ProbePose& handle, double dt_s) {
        if (options_.level)
            return std::min(*options_.level, static_cast<double>(scene_.curves.coarsest()));
        rendering_.measure_speed(handle, dt_s);
        return rendering_.level();
    }

    /// Whatever the operator set, and as the work of the last row asks.
    void bound_level() { rendering_.bound_level(LevelLimits{}.finest, LevelLimits{}.coarsest); }

    const Scene& scene_;
    const FeelOptions& options_;
    const std::vector<HandRow>& hand_;
    ProbeProxy proxy_;
    Rendering rendering_;
};

}  // namespace

Result<void> run_feel(const FeelOptions& options) {
    const auto profile = find_profile(options.profile);
    if (!profile) return tl::unexpected(profile.error());
    const bool has_shape = !options.probe.empty();
    const auto hand =
        read_hand(options.path, has_shape ? HandColumns::place_and_angle : HandColumns::place);
    if (!hand) return tl::unexpected(hand.error());
    const auto scene =
        load_map(options.input, options.as_picture).and_then([&](const TactileMap& map) {
            CurveOptions curves = options.curves;
            curves.device_step_m = encoder_step_m(*profile);
            return build_scene(map, curves, options.contact.radius_m);
        });
    if (!scene) return tl::unexpected(scene.error());
    if (!has_shape)
        return write_whole_file(options.output,
                                Feeling(*scene, nullptr, options, *profile, *hand).run());
    return load_shape(options).and_then([&](const ProbeShape& shape) {
        return write_whole_file(options.output,
                                Feeling(*scene, &shape, options, *profile, *hand).run());
    });
}

}  // namespace touchline
