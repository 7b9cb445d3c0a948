#include "app/kiosk/kiosk_handle.h"

#include "app/force/servo/black_box.h"
#include "app/kiosk/loading/kiosk_stages.h"
#include "app/visit/proxy_radius.h"

#include <array>
#include <cstddef>
#include <utility>

namespace touchline {
namespace {

constexpr double motor_test_lasts_s = 2.5;

constexpr std::array guidance_kinds{GuidanceKind::none, GuidanceKind::tour, GuidanceKind::to_place,
                                    GuidanceKind::to_line};  // by GuideKind

/// Force that waits for a hand has lost the one that it guided.
GuidanceEnd why_stopped(const ForceStatus& force) {
    switch (force.state) {
        case ForceState::fault:
        case ForceState::off:
            return GuidanceEnd::no_force;
        case ForceState::armed:
            return GuidanceEnd::let_go;
        case ForceState::ramp:
            return force.limit == Limit::hand ? GuidanceEnd::let_go : GuidanceEnd::other;
        case ForceState::live:
            break;
    }
    return GuidanceEnd::other;
}

}  // namespace

KioskHandle::KioskHandle(std::unique_ptr<ServoClient> servo, const DeviceProfile& profile,
                         const Settings& settings)
    : servo_(std::move(servo)), profile_(profile), settings_(settings) {}

void KioskHandle::set_nobody_here(bool is_nobody_here) {
    if (is_nobody_here_ == is_nobody_here) return;
    is_nobody_here_ = is_nobody_here;
    set_servo();
}

void KioskHandle::carry_out(const Feel& feel) {
    feel_ = feel;
    set_servo();
}

void KioskHandle::carry_out(const Guide& guide) {
    is_guiding_ = guide.kind != GuideKind::stop;
    guidance_.kind = guidance_kinds.at(static_cast<std::size_t>(guide.kind));
    ++guidance_.serial;
    guidance_.outline = guide.kind == GuideKind::outline ? guide.outline : -1;
    guidance_.place = guide.place_W;
    set_servo();
}

void KioskHandle::carry_out(const GivePattern& given) {
    pattern_.pattern = given.pattern;
    ++pattern_.serial;
    set_servo();
}

void KioskHandle::stop_at_once() {
    is_emergency_stop_ = true;
    set_servo();
}

void KioskHandle::clear_fault() {
    is_emergency_stop_ = false;
    ++faults_cleared_;
    set_servo();
}

void KioskHandle::lock(bool is_locked) {
    is_handle_locked_ = is_locked;
    set_servo();
}

void KioskHandle::begin_motor_test() {
    motor_test_s_ = now_s_;
    is_motor_test_due_ = true;
    set_servo();
}

bool KioskHandle::is_motor_test_on() const {
    return motor_test_s_ > 0.0 && now_s_ - motor_test_s_ < motor_test_lasts_s;
}

void KioskHandle::follow_motor_test() {
    if (is_motor_test_due_ && force_.state == ForceState::live) {
        is_motor_test_due_ = false;
        carry_out(GivePattern{HandlePattern::chosen});
    }
    if (motor_test_s_ > 0.0 && !is_motor_test_on()) {
        motor_test_s_ = 0.0;
        is_motor_test_due_ = false;
        set_servo();
    }
}

void KioskHandle::set_servo() {
    ServoCommands commands;
    ContactSettings& contact = commands.contact;
    contact.mode = feel_.mode;
    contact.stiffness_N_per_m =
        stiffness_steps.at(feel_.stiffness).share * settings_.stiffness_N_per_m;
    contact.radius_m = proxy_radius_m;
    contact.pop_through_N = settings_.has_pop_through ? settings_.pop_through_N : 0.0;
    contact.friction = settings_.friction;
    contact.capture_m = settings_.capture_mm / 1000.0;
    commands.finest_level = settings_.finest_level;
    commands.coarsest_level = settings_.coarsest_level;
    commands.is_level_auto = settings_.is_level_automatic;
    commands.level = settings_.fixed_level;
    commands.is_force_wanted = (feel_.is_force_wanted || is_motor_test_on()) && !is_handle_locked_;
    commands.may_rest = is_nobody_here_;
    commands.force_ceiling_N = settings_.force_ceiling_N;
    commands.guidance = guidance_;
    commands.pattern = pattern_;
    commands.is_emergency_stop = is_emergency_stop_;
    commands.faults_cleared = faults_cleared_;
    commands.shape = feel_.shape;
    commands.turn_rad = feel_.turn_rad;
    servo_->set(commands);
}

void KioskHandle::wipe() {
    servo_->feel(nothing_to_feel(profile_));
    servo_->forget_recording();
}

void KioskHandle::keep_recording() {
    is_recording_due_ = true;
    servo_->keep_recording();
}

std::optional<bool> KioskHandle::is_recording_kept(const std::string& notice) {
    const bool is_kept = notice.find(recording_kept) != std::string::npos;
    const bool is_lost = notice.find(recording_not_kept) != std::string::npos;
    if (!is_recording_due_ || (!is_kept && !is_lost)) return std::nullopt;
    is_recording_due_ = false;
    return is_kept;
}

void KioskHandle::look() {
    hand_ = servo_->latest();
    force_ = servo_->force_status();
}

HandleSeen KioskHandle::take_seen() {
    HandleSeen seen;
    seen.place_W = hand_.p_WH;
    seen.speed_m_per_s = hand_.speed_m_per_s;
    seen.has_moved = hand_.hand_moves != std::exchange(moves_seen_, hand_.hand_moves);
    const GuidancePhase phase = hand_.guidance.phase;
    seen.is_led = phase == GuidancePhase::running || phase == GuidancePhase::pausing;
    return seen;
}

std::optional<GuidanceEnded> KioskHandle::take_guidance_end() {
    const GuidanceStatus& status = hand_.guidance;
    if (!is_guiding_ || status.serial != guidance_.serial) return std::nullopt;
    const bool has_arrived = status.phase == GuidancePhase::arrived;
    if (!has_arrived && status.phase != GuidancePhase::stopped) return std::nullopt;
    is_guiding_ = false;
    return GuidanceEnded{has_arrived ? GuidanceEnd::arrived : why_stopped(force_)};
}

std::optional<Position> KioskHandle::target() const {
    if (!is_guiding_ || guidance_.kind != GuidanceKind::to_place) return std::nullopt;
    return guidance_.place;
}

}  // namespace touchline
