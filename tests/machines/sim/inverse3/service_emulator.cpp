#include "tests/machines/sim/inverse3/service_emulator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace touchline {
namespace {

using nlohmann::json;

constexpr double longest_step_s = 1.25e-4;

json vector_of(Space v) {
    return {{"x", v.x}, {"y", v.y}, {"z", v.z}};
}

/// The service tells single precision.
json rounded(Space v) {
    const auto single = [](double value) { return double{static_cast<float>(value)}; };
    return vector_of({single(v.x), single(v.y), single(v.z)});
}

json transform_of(bool is_turned, double scale) {
    const double half = is_turned ? std::sqrt(0.5) : 1.0;
    return {{"position", vector_of({})},
            {"rotation", {{"w", half}, {"x", 0}, {"y", 0}, {"z", is_turned ? half : 0.0}}},
            {"scale", vector_of({scale, scale, scale})}};
}

json state_of(const ArmTruth& arm, Space place_m, Space velocity_m_per_s, Space applied_N) {
    const bool is_idle = applied_N == Space{};
    json state{{"angular_position", {{"a0", -30.9}, {"a1", 53.8}, {"a2", -6.6}}},
               {"body_orientation", {{"w", 1}, {"x", 0}, {"y", 0}, {"z", 0}}},
               {"control_domain", is_idle ? "undefined" : "cartesian"},
               {"control_mode", is_idle ? "idle" : "force"},
               {"current_cursor_force", rounded(applied_N)},
               {"cursor_position", rounded(place_m)},
               {"cursor_velocity", rounded(velocity_m_per_s)},
               {"mode", is_idle ? "idle" : "force"},
               {"transform", transform_of(false, arm.has_workspace_scaled ? 2.0 : 1.0)}};
    if (!arm.tells_place) state.erase("cursor_position");
    return state;
}

json config_of(const ArmTruth& arm) {
    return {{"type", arm.type},
            {"port", "/dev/ttyACM0"},
            {"handedness", "right"},
            {"gravity_compensation", {{"enabled", true}, {"scaling_factor", 1.0}}},
            {"preset", "defaults"},
            {"basis", {{"permutation", "XYZ"}}},
            {"mount", transform_of(arm.is_mount_turned, 1.0)}};
}

std::optional<Space> force_in(const json& device, bool has_session) {
    const json::json_pointer way(has_session ? "/commands/set_cursor_force/vector"
                                             : "/commands/set_cursor_force/values");
    if (!device.contains(way)) return std::nullopt;
    const json& told = device.at(way);
    return Space{told.at("x"), told.at("y"), told.at("z")};
}

}  // namespace

ServiceEmulator::ServiceEmulator(ServiceTruth truth, std::shared_ptr<const IntendedPath> path)
    : truth_(std::move(truth)),
      path_(std::move(path)),
      level_(truth_.tip, truth_.hand, path_->at(0.0).position),
      vertical_(truth_.tip, truth_.hand, {}) {}

void ServiceEmulator::advance_to(double t_s) {
    const double span_s = t_s - now_s_;
    if (!(span_s > 0.0)) return;
    const double steps = std::max(1.0, std::ceil(span_s / longest_step_s - 1e-6));
    for (int i = 0; i < static_cast<int>(steps); ++i) step(span_s / steps);
    now_s_ = t_s;
}

void ServiceEmulator::step(double span_s) {
    if (now_s_ - told_s_ > truth_.idle_after_s) apply({});
    const bool is_driven = !truth_.arms.empty() && truth_.arms[0].has_power;
    const Space force_N = is_driven ? applied_N_ : Space{};
    level_.step({force_N.x, force_N.y}, path_->at(now_s_), span_s);
    Intention height;
    height.position = {height_m_, 0.0};
    vertical_.step({force_N.z - truth_.weight_N, 0.0}, height, span_s);
    now_s_ += span_s;
}

std::string ServiceEmulator::answer(std::string_view text) {
    const json told = json::parse(text, nullptr, false);
    bool is_whole = false;
    if (told.is_object()) {
        is_whole = told.contains("/session/force_render_full_state"_json_pointer);
        for (const json& device : told.value("inverse3", json::array())) {
            const auto force_N = force_in(device, truth_.has_session);
            const bool is_first =
                !truth_.arms.empty() && device.value("device_id", "") == truth_.arms[0].name;
            if (!force_N || !is_first) continue;
            told_s_ = now_s_;
            apply(*force_N);
        }
    }
    return frame(is_whole);
}

void ServiceEmulator::apply(Space force_N) {
    if (force_N == applied_N_ || (truth_.clings && force_N == Space{})) return;
    applied_N_ = force_N;
    told_.push_back({now_s_, force_N});
}

std::string ServiceEmulator::frame(bool is_whole) const {
    json arms = json::array();
    const Velocity level = level_.tip().velocity;
    for (std::size_t i = 0; i < truth_.arms.size(); ++i) {
        const ArmTruth& arm = truth_.arms[i];
        const bool is_first = i == 0;
        json told{{"device_id", arm.name},
                  {"state", state_of(arm, is_first ? place_m() : Space{0.1, -0.03, -0.06},
                                     is_first ? Space{level.x, level.y, vertical_.tip().velocity.x}
                                              : Space{},
                                     is_first ? applied_N_ : Space{})},
                  {"status",
                   {{"calibrated", arm.is_calibrated},
                    {"in_use", false},
                    {"power_supply", arm.has_power},
                    {"ready", arm.is_ready},
                    {"started", true}}}};
        if (is_whole) told["config"] = config_of(arm);
        arms.push_back(std::move(told));
    }
    json all{{"inverse3", std::move(arms)}, {"wireless_verse_grip", json::array()}};
    if (is_whole && truth_.has_session) all["session_id"] = 7;
    return all.dump();
}

Space ServiceEmulator::place_m() const {
    const Position level = level_.tip().position;
    return {truth_.centre_m.x + level.x, truth_.centre_m.y + level.y,
            truth_.centre_m.z + vertical_.tip().position.x};
}

}  // namespace touchline
