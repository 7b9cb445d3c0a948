#include "app/cli/tour.h"

#include "app/cli/load.h"
#include "app/documents/decode/picture.h"
#include "app/force/servo/scene_order.h"
#include "app/screen/tour_figure.h"
#include "app/visit/proxy_radius.h"
#include "config/types/utf8.h"
#include "haptics/servo/servo_step.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

namespace touchline {

namespace {

constexpr double period_s = 1e-3;
constexpr int longest_picture_px = 2000;

/// Means what it was last told to. Threads: one.
class LedHand final : public IntendedPath {
  public:
    explicit LedHand(Position start) : now_{start, {}} {}

    void mean(const Intention& intention) { now_ = intention; }

    [[nodiscard]] Intention at(double) const override { return now_; }

  private:
    Intention now_;
};

Felt felt_by(const ServoReport& report, const Scene& scene) {
    const HandState& hand = report.hand;
    const bool is_there = hand.map_version == scene.map_version;
    const bool is_live = report.force.state == ForceState::live;
    const MapForce map_force = !is_there ? MapForce::off
                               : is_live ? MapForce::on
                                         : MapForce::changing;
    return {hand.p_WP, hand.force, hand.state != ContactState::free, map_force};
}

void add_figures(TourRun& run) {
    double force_sum_N = 0.0;
    for (const TourTick& tick : run.ticks) {
        const double force_N = norm(tick.hand.force);
        run.largest_force_N = std::max(run.largest_force_N, force_N);
        if (tick.hand.state == ContactState::free) continue;
        run.contact_s += run.period_s;
        force_sum_N += force_N * run.period_s;
    }
    if (run.contact_s > 0.0) run.mean_force_N = force_sum_N / run.contact_s;
}

/// The path in pieces: a new one each time the hand lifts or comes down.
std::vector<TourStretch> way_of(const TourRun& run) {
    constexpr std::size_t ticks_per_point = 4;
    std::vector<TourStretch> way;
    for (std::size_t i = 0; i < run.ticks.size(); ++i) {
        const TourTick& tick = run.ticks[i];
        const bool is_new = way.empty() || way.back().is_lifted != tick.is_lifted;
        if (is_new) way.push_back({tick.is_lifted, {}, {}});
        if (!is_new && i % ticks_per_point != 0) continue;
        way.back().handle.push_back(tick.hand.p_WH);
        way.back().proxy.push_back(tick.hand.p_WP);
    }
    return way;
}

/// A force every few millimetres of the handle's path.
std::vector<ForceMark> forces_of(const TourRun& run) {
    constexpr double apart_m = 0.003;
    std::vector<ForceMark> marks;
    for (const TourTick& tick : run.ticks) {
        if (tick.hand.state == ContactState::free || tick.is_lifted) continue;
        if (marks.empty() || norm(tick.hand.p_WH - marks.back().at) >= apart_m)
            marks.push_back({tick.hand.p_WH, tick.hand.force});
    }
    return marks;
}

std::string title_of(const TactileMap& map, const std::string& path) {
    return "Tour: " +
           (map.title.empty() ? std::filesystem::path(path).filename().string() : map.title);
}

}  // namespace

TourRun take_tour(const TactileMap& map, const Scene& scene) {
    Explorer explorer(map, scene, ExplorerOptions{});
    const auto hand = std::make_shared<LedHand>(explorer.start());
    const DeviceProfile& profile = default_profile();
    SimulatedPantograph device(profile, SimulationOptions{}, hand);
    ServoStep servo(profile, period_s);
    ServoCommands commands;
    commands.contact.radius_m = proxy_radius_m;
    TourRun run;
    run.period_s = period_s;
    run.outlines = static_cast<int>(map.outlines.size());
    while (!explorer.is_done()) {
        const double now_s = period_s * static_cast<double>(run.ticks.size());
        const bool is_lifted = explorer.is_lifted();
        const StepInput input{now_s, 0, device.read(now_s), commands, is_lifted ? nullptr : &scene};
        (void)device.write(servo.step(input));
        const ServoReport& report = servo.report();
        run.ticks.push_back({report.hand, is_lifted});
        explorer.step(felt_by(report, scene), period_s);
        hand->mean(explorer.intention());
    }
    run.visited = explorer.visited();
    add_figures(run);
    return run;
}

std::vector<std::string> describe_tour(const TourRun& run) {
    const double time_s = run.period_s * static_cast<double>(run.ticks.size());
    const double share = time_s > 0.0 ? 100.0 * run.contact_s / time_s : 0.0;
    const ContactSettings settings;
    return {
        fmt::format("A pen grip explored {} of {} outlines in {:.1f} s, at {:.0f} mm/s along them.",
                    run.visited, run.outlines, time_s, 1000.0 * ExplorerOptions{}.follow_m_per_s),
        fmt::format("Wall of {:.0f} N/m, proxy radius {:.1f} mm, level by hand speed, {}.",
                    settings.stiffness_N_per_m, 1000.0 * proxy_radius_m, default_profile().name),
        fmt::format("In contact for {:.1f} s, {:.0f} % of the time.", run.contact_s, share),
        fmt::format("Force on the hand in contact: {:.2f} N on average, {:.2f} N at most.",
                    run.mean_force_N, run.largest_force_N)};
}

/// A map is felt as it is; a picture is opened once, to be felt and painted.
Result<TactileMap> explored_map(const TourArguments& arguments, const Result<SeenView>& seen) {
    if (is_map_name(arguments.input) && !arguments.as_picture)
        return load_map(arguments.input, false);
    return seen.and_then(map_of);
}

Result<void> run_tour(const TourArguments& arguments) {
    const Result<SeenView> seen = open_view(arguments.input);
    Result<TactileMap> map = explored_map(arguments, seen);
    if (!map) return tl::unexpected(map.error());
    if (!seen) return tl::unexpected(seen.error());
    map->version = 1;
    const Result<Scene> scene = build_scene(*map, felt_order(default_profile()));
    if (!scene) return failure(fmt::format("{}: {}", arguments.input, scene.error().line));

    const TourRun run = take_tour(*map, *scene);
    const std::vector<std::string> lines = describe_tour(run);
    const TourFigure figure{title_of(*map, arguments.input), lines, way_of(run), forces_of(run)};
    const Canvas canvas =
        paint_tour(figure, *scene, canvas_of(seen->page.picture, longest_picture_px));
    auto written = write_png(arguments.output, picture_of(canvas));
    if (!written) return written;
    fmt::print("{}\n", plain_line(figure.title));
    for (const std::string& line : lines) fmt::print("{}\n", line);
    fmt::print("Drawn in {}\n", plain_line(arguments.output));
    return {};
}

}  // namespace touchline
