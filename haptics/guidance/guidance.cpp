#include "haptics/guidance/guidance.h"

#include <array>
#include <numbers>
#include <utility>

namespace touchline {
namespace {

constexpr int most_edges = 64;

const Leg& leg_at(const Scene& scene, int leg) {
    return scene.legs[static_cast<std::size_t>(leg)];
}

Position point_at(const Scene& scene, const Leg& leg, int point) {
    const auto points = scene.curves.points(leg.piece, 0);
    return points[static_cast<std::size_t>(point) % points.size()];
}

constexpr double pull_N_per_m = 250.0;
constexpr double damping_Ns_per_m = 1.5;
constexpr double free_lag_m = 0.002;     // up to here the point keeps its speed ...
constexpr double longest_lag_m = 0.004;  // ... from here on it waits
constexpr double arrived_m = 0.0025;
constexpr double fade_in_s = 0.3;
constexpr double let_go_s = 0.04;
constexpr double rate_change_s = 0.2;
constexpr double corner_pause_s = 0.25;
constexpr double label_pause_s = 1.2;
constexpr double line_reach_m = 0.3;
constexpr int query_boxes = 4096;
// Waiting begins below the one rate and ends above the other, so that a hand in between does not
// flutter.
constexpr double waiting_rate = 0.05;
constexpr double running_rate = 0.3;

Force clamped(Force force, double most_N) {
    const double size_N = norm(force);
    return size_N <= most_N ? force : most_N / size_N * force;
}

constexpr double half_root = 0.5 * std::numbers::sqrt2;
constexpr Direction sideways{1.0, 0.0};
constexpr Direction away{0.0, 1.0};
constexpr Direction slanting{half_root, half_root};

// A hand feels shaking of 10 to 60 Hz well and its direction fairly; below 10 Hz the shaking moves
// it.
constexpr std::array rows{
    PatternRow{HandlePattern::focus, 1, sideways, 25.0, 0.6, 3, 0.06},
    PatternRow{HandlePattern::chosen, 2, away, 25.0, 0.7, 3, 0.10},
    PatternRow{HandlePattern::error, 3, sideways, 50.0, 0.9, 6, 0.10},
    PatternRow{HandlePattern::edge, 1, away, 50.0, 0.8, 12, 0.06},
    PatternRow{HandlePattern::time_out, 4, slanting, 12.5, 0.8, 2, 0.20},
};

constexpr double ending_s = 0.02;

const PatternRow* row_of(HandlePattern pattern) {
    const auto* const found = std::ranges::find(rows, pattern, &PatternRow::pattern);
    return found == rows.end() ? nullptr : found;
}

double pulse_s(const PatternRow& row) {
    return row.swings / row.frequency_Hz;
}

}  // namespace

void LeadingPoint::go_straight(Position to, double speed_m_per_s) {
    from_ = position_;
    to_ = to;
    profile_ = SpeedProfile(norm(to - from_), speed_m_per_s);
    t_s_ = gone_m_ = 0.0;
    has_arrived_ = false;
    is_straight_ = true;
}

void LeadingPoint::go_along(const Scene& scene, int leg, double speed_m_per_s) {
    const Leg& first = leg_at(scene, leg);
    profile_ = SpeedProfile(first.run_m, speed_m_per_s);
    t_s_ = gone_m_ = 0.0;
    has_arrived_ = false;
    is_straight_ = false;
    leg_ = leg;
    point_ = first.first;
    on_edge_m_ = 0.0;
}

void LeadingPoint::step(const Scene& scene, double dt_s) {
    if (has_arrived_) return;
    t_s_ += dt_s;
    const bool is_over = t_s_ >= profile_.duration_s();
    const double way_m = profile_.gone_m(t_s_);
    if (is_straight_) {
        const double whole_m = norm(to_ - from_);
        has_arrived_ = is_over;
        position_ = is_over ? to_ : from_ + way_m / whole_m * (to_ - from_);
        return;
    }
    // At the end goes a trace beyond the length, which was summed in another order.
    constexpr double trace_m = 1e-6;
    walk(scene, way_m - gone_m_ + (is_over ? trace_m : 0.0));
}

void LeadingPoint::walk(const Scene& scene, double way_m) {
    for (int edges = 0; edges < most_edges && way_m > 0.0; ++edges) {
        const Leg& leg = leg_at(scene, leg_);
        const Position a = point_at(scene, leg, point_);
        const Position b = point_at(scene, leg, point_ + 1);
        const double length_m = norm(b - a);
        const double left_m = length_m - on_edge_m_;
        if (way_m < left_m) {
            on_edge_m_ += way_m;
            gone_m_ += way_m;
            position_ = a + on_edge_m_ / length_m * (b - a);
            return;
        }
        way_m -= left_m;
        gone_m_ += left_m;
        on_edge_m_ = 0.0;
        position_ = b;
        if (++point_ < leg.last) continue;
        has_arrived_ = leg.rests_at_end;
        if (has_arrived_) return;
        point_ = leg_at(scene, ++leg_).first;
    }
}

bool LeadingPoint::fits(const Scene& scene) const {
    if (has_arrived_ || is_straight_) return leg_ < static_cast<int>(scene.legs.size());
    if (leg_ < 0 || leg_ >= static_cast<int>(scene.legs.size())) return false;
    const Leg& leg = leg_at(scene, leg_);
    return point_ >= leg.first && point_ < leg.last;
}

Force Guidance::step(const GuideInput& input, double dt_s) {
    take(input.command);
    if (is_leading_ && (!input.is_live || input.scene == nullptr)) end(GuidancePhase::stopped);
    const bool can_begin = gain_ <= 0.0 && input.is_live && input.scene != nullptr;
    if (is_wanted_ && can_begin) begin(input);
    const Position before = point_.position();
    if (is_leading_) lead(input, dt_s);
    const double step = is_leading_ ? dt_s / fade_in_s : -dt_s / let_go_s;
    gain_ = std::clamp(gain_ + step, 0.0, 1.0);
    if (!leads()) point_.put(input.handle);
    status_.leading = point_.position();
    status_.is_on_line = is_leading_ && command_.kind == GuidanceKind::tour && !is_approaching_;
    if (gain_ <= 0.0) return {};
    return pull(input, along<Velocity>(point_.position() - before, 1.0 / dt_s));
}

void Guidance::take(const GuidanceCommand& command) {
    const bool is_new = !is_first_ && command.serial != command_.serial;
    command_ = command;
    if (is_first_) {
        status_.serial = command.serial;
        if (command.kind != GuidanceKind::none) status_.phase = GuidancePhase::stopped;
    }
    is_first_ = false;
    if (!is_new) return;
    is_leading_ = false;
    is_wanted_ = command.kind != GuidanceKind::none;
    status_.serial = command.serial;
    status_.phase = is_wanted_ ? GuidancePhase::waiting : GuidancePhase::stopped;
    status_.outline = status_.label = -1;
}

void Guidance::end(GuidancePhase how) {
    is_leading_ = is_wanted_ = false;
    status_.phase = how;
}

void Guidance::begin(const GuideInput& input) {
    is_wanted_ = false;
    is_leading_ = true;
    is_approaching_ = false;
    rate_ = 0.0;
    pause_s_ = 0.0;
    point_.put(input.handle);
    const Scene& scene = *input.scene;
    switch (command_.kind) {
        case GuidanceKind::tour:
            begin_tour(scene);
            break;
        case GuidanceKind::to_line:
            begin_to_line(scene, input.handle);
            break;
        case GuidanceKind::to_place:
            point_.go_straight(within(scene.area, command_.place), command_.speed_m_per_s);
            break;
        case GuidanceKind::none:
            end(GuidancePhase::stopped);
            break;
    }
}

void Guidance::begin_tour(const Scene& scene) {
    const auto& all = scene.legs;
    const auto count = static_cast<int>(all.size());
    next_leg_ = 0;
    end_leg_ = count;
    if (command_.outline >= 0) {
        const auto own = std::ranges::equal_range(all, command_.outline, {}, &Leg::outline);
        next_leg_ = static_cast<int>(own.begin() - all.begin());
        end_leg_ = static_cast<int>(own.end() - all.begin());
    }
    if (next_leg_ == end_leg_) return end(GuidancePhase::stopped);
    go_on(scene);
}

void Guidance::begin_to_line(const Scene& scene, Position handle) {
    const Closest at = scene.tree.closest_point(scene.curves, handle, 0.0, line_reach_m,
                                                Budget{.boxes = query_boxes});
    if (at.segment.piece < 0) return end(GuidancePhase::stopped);
    status_.outline = scene.curves.piece(at.segment.piece).outline;
    point_.go_straight(at.point, command_.speed_m_per_s);
}

/// Leaves a rest: on along the line, or first to where an outline begins.
void Guidance::go_on(const Scene& scene) {
    const Leg& next = scene.legs[static_cast<std::size_t>(next_leg_)];
    status_.outline = next.outline;
    const Position start = scene.curves.points(next.piece, 0)[static_cast<std::size_t>(next.first)];
    is_approaching_ = next.starts_outline && start != point_.position();
    if (is_approaching_) {
        point_.go_straight(start, command_.speed_m_per_s);
    } else {
        point_.go_along(scene, next_leg_, command_.speed_m_per_s);
    }
}

/// The point has reached a resting place.
void Guidance::rest(const Scene& scene) {
    if (is_approaching_) {
        pause_s_ = corner_pause_s;
        return;
    }
    const Leg& gone = scene.legs[static_cast<std::size_t>(point_.leg())];
    next_leg_ = point_.leg() + 1;
    pause_s_ = gone.label >= 0 ? label_pause_s : corner_pause_s;
    if (gone.label >= 0) status_.label = gone.label;
}

bool Guidance::is_at_end() const {
    const bool is_tour = command_.kind == GuidanceKind::tour;
    return point_.has_arrived() && (!is_tour || next_leg_ == end_leg_);
}

void Guidance::lead(const GuideInput& input, double dt_s) {
    const Scene& scene = *input.scene;
    const double lag_m = norm(point_.position() - input.handle);
    const double follows =
        std::clamp((longest_lag_m - lag_m) / (longest_lag_m - free_lag_m), 0.0, 1.0);
    const double goal = command_.is_held ? 0.0 : follows;
    rate_ = std::clamp(goal, rate_ - dt_s / rate_change_s, rate_ + dt_s / rate_change_s);
    // A hand that stops must not be pulled on by the remaining rate.
    rate_ = std::min(rate_, goal);
    if (!point_.has_arrived()) {
        point_.step(scene, rate_ * dt_s);
        if (point_.has_arrived() && command_.kind == GuidanceKind::tour) rest(scene);
    } else if (pause_s_ > 0.0) {
        pause_s_ -= rate_ * dt_s;
    } else if (!is_at_end()) {
        if (std::exchange(is_approaching_, false)) {
            point_.go_along(scene, next_leg_, command_.speed_m_per_s);
        } else {
            go_on(scene);
        }
    } else if (lag_m <= arrived_m && !command_.is_held) {
        return end(GuidancePhase::arrived);
    }
    tell_phase(rate_ < waiting_rate);
}

void Guidance::tell_phase(bool is_held_back) {
    if (is_held_back) {
        status_.phase = GuidancePhase::waiting;
    } else if (point_.has_arrived() && pause_s_ > 0.0) {
        status_.phase = GuidancePhase::pausing;
    } else if (rate_ > running_rate) {
        status_.phase = GuidancePhase::running;
    }
}

/// A spring to the point, damped against the point's own motion.
Force Guidance::pull(const GuideInput& input, Velocity ahead) const {
    const Force spring = along<Force>(point_.position() - input.handle, pull_N_per_m);
    const Force damping = along<Force>(ahead - input.velocity, damping_Ns_per_m);
    return gain_ * clamped(spring + damping, most_guide_N);
}

void Guidance::leave_scene() {
    if (is_leading_) end(GuidancePhase::stopped);
    point_.put(point_.position());
    next_leg_ = end_leg_ = 0;
}

bool Guidance::fits(const Scene* scene) const {
    if (scene == nullptr) return !is_leading_;
    const auto count = static_cast<int>(scene->legs.size());
    const bool is_in_range = next_leg_ >= 0 && next_leg_ <= end_leg_ && end_leg_ <= count;
    return is_in_range && point_.fits(*scene) && command_.kind <= GuidanceKind::to_line;
}

std::span<const PatternRow> pattern_rows() {
    return rows;
}

double duration_s(const PatternRow& row) {
    return row.pulses * (pulse_s(row) + row.gap_s);
}

Force force_at(const PatternRow& row, double t_s) {
    if (!(t_s >= 0.0 && t_s < duration_s(row))) return {};
    const double in_pulse_s = std::fmod(t_s, pulse_s(row) + row.gap_s);
    if (in_pulse_s >= pulse_s(row)) return {};
    const double turn = 2.0 * std::numbers::pi * row.frequency_Hz * in_pulse_s;
    const double bell = 0.5 * (1.0 - std::cos(turn / row.swings));
    return along<Force>(row.direction, row.peak_N * bell * std::cos(turn));
}

bool PatternPlayer::is_sound() const {
    return playing_ == HandlePattern::none || row_of(playing_) != nullptr;
}

Force PatternPlayer::step(const PatternCommand& command, bool is_live, double dt_s) {
    if (is_first_) known_ = serial_ = command.serial;
    is_first_ = false;
    if (command.serial != known_) {
        known_ = serial_ = command.serial;
        wanted_ = is_live ? command.pattern : HandlePattern::none;
        is_ending_ = true;
    }
    if (!is_live) {
        wanted_ = HandlePattern::none;
        is_ending_ = true;
    }
    const PatternRow* row = row_of(playing_);
    const bool is_over = row == nullptr || t_s_ >= duration_s(*row) || (is_ending_ && gain_ <= 0.0);
    if (is_over) {
        playing_ = std::exchange(wanted_, HandlePattern::none);
        is_ending_ = false;
        t_s_ = 0.0;
        gain_ = 1.0;
        row = row_of(playing_);
    }
    if (row == nullptr) return {};
    t_s_ += dt_s;
    if (is_ending_) gain_ = std::max(0.0, gain_ - dt_s / ending_s);
    return gain_ * force_at(*row, t_s_);
}

}  // namespace touchline
