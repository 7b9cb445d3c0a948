#include "app/cli/feel.h"

#include "app/cli/feel_shape.h"
#include "app/cli/hand_csv.h"
#include "app/cli/load.h"
#include "app/cli/names.h"
#include "app/decode/files.h"
#include "config/types/steady_clock.h"
#include "haptics/pantograph/profile.h"
#include "haptics/resolution/cost_term.h"
#include "haptics/resolution/level_rule.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace touchline {
namespace {

Result<std::vector<HandRow>> read_hand(const std::string& path, HandColumns columns) {
    return read_file(path).and_then([&path, columns](const std::vector<std::byte>& bytes) {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes of a text
        return parse_hand_csv({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, columns)
            .map_error([&path](const Error& error) {
                return Error{fmt::format("{}: {}", path, error.line)};
            });
    });
}

/// One line of RUN.csv. Numbers read back to the same bits.
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

LevelLimits limits_of(const Scene& scene, const DeviceProfile& profile, double radius_m) {
    LevelLimits limits;
    limits.spacing_m = scene.curves.finest_spacing_m();
    limits.encoder_step_m = encoder_step_m(profile);
    limits.f_device_Hz = profile.bandwidth_Hz;
    limits.radius_m = radius_m;
    limits.percept = scene.percept_level;
    limits.safe = scene.curves.coarsest();
    return limits;
}

/// The rows of a run, stepped through the production code.
class Feeling {
  public:
    Feeling(const Scene& scene, const FeelOptions& options, const DeviceProfile& profile)
        : scene_(scene),
          options_(options),
          limits_(limits_of(scene, profile, options.contact.radius_m)),
          rule_(limits_) {}

    std::string run(const std::vector<HandRow>& hand) {
        if (hand.size() > 1) cost_ = CostTerm(hand[1].t_s - hand[0].t_s);
        fmt::memory_buffer out;
        fmt::format_to(
            std::back_inserter(out),
            "t_s,x_m,y_m,proxy_x_m,proxy_y_m,fx_N,fy_N,state,level,outline,parameter,side,"
            "transitions,carried_m,nodes,clear{}\n",
            options_.with_timing ? ",step_ns" : "");
        for (std::size_t i = 0; i < hand.size(); ++i) {
            const double dt_s = i > 0 ? hand[i].t_s - hand[i - 1].t_s : first_period_s;
            const std::int64_t begin_ns = options_.with_timing ? steady_now_ns() : 0;
            const double level = wanted_level(hand[i].p_WH, dt_s);
            const ContactReport report = i == 0
                                             ? start(hand[0].p_WH, level)
                                             : machine_.step(hand[i].p_WH, level, options_.contact,
                                                             budget_of(options_), dt_s);
            limits_.cost = cost_.step(work_of(report), machine_.rendered_level());
            rule_.set_limits(limits_);
            const std::int64_t step_ns = options_.with_timing ? steady_now_ns() - begin_ns : 0;
            write_row(out, hand[i], report);
            if (options_.with_timing) fmt::format_to(std::back_inserter(out), ",{}", step_ns);
            out.push_back('\n');
        }
        return fmt::to_string(out);
    }

  private:
    /// The first row: the proxy is at the handle, free. On a line it is beside it, by the contact
    /// skin.
    ContactReport start(Position handle, double level) {
        machine_.reset(scene_, handle, level);
        ContactReport report;
        report.p_WP = machine_.proxy().centre;
        report.force = along<Force>(report.p_WP - handle, options_.contact.stiffness_N_per_m);
        report.level = level;
        return report;
    }

    double wanted_level(Position handle, double dt_s) {
        const double coarsest = scene_.curves.coarsest();
        if (options_.level) return std::min(*options_.level, coarsest);
        return rule_.step(handle, dt_s);
    }

    const Scene& scene_;
    const FeelOptions& options_;
    LevelLimits limits_;
    LevelRule rule_;
    CostTerm cost_{first_period_s};  // period of the first two rows
    ContactMachine machine_;
};

}  // namespace

Budget budget_of(const FeelOptions& options) {
    Budget budget;
    if (options.budget_boxes) budget.boxes = *options.budget_boxes;
    if (options.deadline_us) {
        budget.deadline_ns =
            steady_now_ns() + static_cast<std::int64_t>(*options.deadline_us * 1000.0);
    }
    return budget;
}

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
    if (has_shape) {
        const auto shape = load_shape(options);
        if (!shape) return tl::unexpected(shape.error());
        const LevelLimits limits = limits_of(*scene, *profile, options.contact.radius_m);
        return write_whole_file(options.output, feel_shape(*scene, *shape, options, limits, *hand));
    }
    return write_whole_file(options.output, Feeling(*scene, options, *profile).run(*hand));
}

}  // namespace touchline
