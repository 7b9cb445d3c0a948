#include "tests/haptics/contact/scenarios/watched_machine.h"

#include <algorithm>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace touchline::scenarios {
namespace {

/// Returns a cell size of about one segment, neither too small nor too large.
double cell_m(const CurveSet& curves) {
    return std::clamp(curves.finest_spacing_m(), 1e-5, 2e-3);
}

bool is_flip(const ContactReport& before, const ContactReport& now) {
    return before.outline >= 0 && before.outline == now.outline && before.side != now.side;
}

}  // namespace

WatchedMachine::WatchedMachine(const Scene& scene, const CommonSetUp& set_up, Position start,
                               double level)
    : settings_(set_up.contact),
      motors_N_(set_up.motors_N),
      judge_(scene.curves, 0.0, cell_m(scene.curves)) {
    machine_.reset(scene, start, level);
    machine_.record_path(&path_);
}

ContactReport WatchedMachine::step(Position handle, double level) {
    const double level_before = machine_.rendered_level();
    const double gap_before_m = norm(handle - machine_.proxy().centre);
    const ContactReport report = machine_.step(handle, level, settings_, {});
    const double gap_m = norm(handle - report.p_WP);
    if (machine_.rendered_level() != level_before) {
        ++watch_.level_changes;
        watch_.switched_J +=
            0.5 * settings_.stiffness_N_per_m * (gap_m * gap_m - gap_before_m * gap_before_m);
    } else {
        watch_.farthest_growth_m = std::max(watch_.farthest_growth_m, gap_m - gap_before_m);
        if (level_before == 0.0 && !judge_.is_free(path_)) ++watch_.crossings;
    }
    if (is_flip(last_report_, report)) ++watch_.side_flips;
    last_report_ = report;
    book_energy(handle, limited(report.force, motors_N_));
    return report;
}

void WatchedMachine::book_energy(Position handle, Force force) {
    if (has_last_) {
        const Position moved = handle - last_handle_;
        watch_.work_J += dot(last_force_, moved);
        if (last_force_ != Force{} || force != Force{}) {
            watch_.allowed_J += 0.5 * settings_.stiffness_N_per_m * dot(moved, moved);
        }
    }
    has_last_ = true;
    last_handle_ = handle;
    last_force_ = force;
}

void expect_sound(const Watch& watch) {
    EXPECT_EQ(watch.crossings, 0);
    EXPECT_LE(watch.farthest_growth_m, 1e-12);
    EXPECT_LE(watch.work_J, watch.allowed_J + 1e-9);
    const auto record = [](const std::string& name, double value) {
        testing::Test::RecordProperty(name, fmt::format("{:.4g}", value));
    };
    record("work_mJ", 1e3 * watch.work_J);
    record("allowed_mJ", 1e3 * watch.allowed_J);
    record("farthest_growth_m", watch.farthest_growth_m);
    record("side_flips", watch.side_flips);
}

}  // namespace touchline::scenarios
