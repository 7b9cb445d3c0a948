// What checkers see of the site, and its hash.
#include "haptics/pantograph/kinematics.h"
#include "haptics/safety/force_chain.h"
#include "tests/machines/sim/kiosk/sim_house.h"

#include <algorithm>
#include <utility>

namespace touchline {
namespace {

constexpr double pattern_s = 1.0;  // longer than any pattern
constexpr std::size_t most_heard = 20'000;

bool leads(GuidancePhase phase) {
    return phase == GuidancePhase::running || phase == GuidancePhase::waiting ||
           phase == GuidancePhase::pausing;
}

}  // namespace

Force SimHouse::force_of(JointTorques torques) const {
    if (torques == JointTorques{}) return {};
    const auto pose = forward(board_.truth().profile.geometry, board_.true_angles());
    const auto force_D = pose ? tip_force(pose->jacobian, torques) : std::nullopt;
    return force_D ? turned(*force_D) : Force{};
}

void SimHouse::look_at_tick() {
    const JointTorques held = board_.plant().torques();
    if (held != held_) {
        const auto& changes = board_.told_torques();
        held_since_s_ = changes.empty() ? time_.now_s : changes.back().at_s;
        held_ = held;
        board_.forget_told_torques();
    }
    TickSight sight;
    sight.now_s = time_.now_s;
    sight.held = held_;
    sight.held_since_s = held_since_s_;
    sight.force_W = force_of(held_);
    sight.tip = board_.plant().tip();
    sight.is_hand_on = hand_->is_homing() || (visitor_ && visitor_->holds_handle());
    sight.is_send_hanging = time_.now_s < link_broken_until_s_;
    const std::uint64_t ticks =
        servo_ && servo_->is_ticking() ? connection_->region.channel().servo_beats.load() : 0;
    const TickRecord* const newest = servo_ && servo_->is_ticking() ? servo_->newest() : nullptr;
    if (newest != nullptr && ticks != seen_ticks_) {
        sight.tick = newest;
        sight.is_first_tick = !std::exchange(has_ticked_, true);
        seen_ticks_ = ticks;
        ++figures_.ticks;
        figures_.servo_s += 1e-3;
        const std::uint32_t serial = newest->input.commands.pattern.serial;
        if (serial != std::exchange(pattern_serial_, serial))
            pattern_until_s_ = time_.now_s + pattern_s;
        is_led_ = leads(newest->guidance);
        hash_.mix(newest->force.x);
        hash_.mix(newest->p_WH.y);
        hash_.mix(static_cast<std::uint64_t>(newest->force_state));
    }
    sight.is_led = is_led_ || time_.now_s < pattern_until_s_;
    force_limits_.look(sight, figures_, findings_);
    board_truth_.look(sight, findings_);
    given_energy_.look(sight, figures_, findings_);
    zero_deadline_.look(sight, figures_, findings_);
    no_hand_.look(sight, findings_);
    safety_transitions_.look(sight, findings_);
    if (sight.tick == nullptr || !kiosk_) return;
    const auto felt = kiosk_->servo->drawings.find(sight.tick->map_version);
    const bool is_known = felt != kiosk_->servo->drawings.end();
    growing_line_.look(sight, is_known ? felt->second : 0, figures_, findings_);
}

std::size_t SimHouse::heard_ever() const {
    if (sabotage_ == Sabotage::silent_sound) return 0;
    return heard_before_ + heard_->things.size();
}

bool SimHouse::is_servo_ready() const {
    return servo_ && servo_->is_ticking() && kiosk_ &&
           kiosk_->kiosk->force().fault == Fault::none && !is_servo_frozen_;
}

/// Returns true for a fault that only a person may clear.
bool SimHouse::needs_staff() const {
    const Fault fault = kiosk_->kiosk->force().fault;
    if (fault == Fault::none) return false;
    const FaultRule& rule = fault_rules()[static_cast<std::size_t>(fault) - 1];
    return rule.clears != FaultClears::when_gone;
}

void SimHouse::look_at_frame() {
    const Kiosk& kiosk = *kiosk_->kiosk;
    if (heard_->things.size() > 0)
        last_heard_s_ = std::max(last_heard_s_, heard_->things.back().at_s);
    FrameSight sight{now_s_, kiosk};
    sight.heard = heard_ever();
    sight.is_servo_ready = is_servo_ready();
    sight.is_blocked =
        !ongoing_.empty() || !servo_ || !servo_->is_ticking() || needs_staff() || is_end_wanted_;
    sight.has_read = std::exchange(has_read_, false);
    sight.commands = kiosk_->servo->told;
    sight.jobs = kiosk_->jobs->waiting();
    sight.dropped_events = servo_ ? servo_->dropped_events() : 0;
    session_rules_.look(sight, findings_);
    answers_.look(sight, figures_, findings_);
    readiness_.look(sight, figures_, findings_);
    queues_.look(sight, findings_);
    look_at_offers(sight);
    hash_.mix(static_cast<std::uint64_t>(open_screen(kiosk.visit())));
    hash_.mix(static_cast<std::uint64_t>(sight.heard));
    if (now_s_ >= hashed_s_ + 1.0) {
        hash_.mix(std::string_view(kiosk.caption()));
        hash_.mix(kiosk.hand().p_WP.x);
        figures_.hashes.push_back(hash_.value());
        hashed_s_ = std::max(hashed_s_ + 1.0, now_s_ - 1.0);
    }
    if (heard_->things.size() > most_heard) forget_heard();
}

void SimHouse::look_at_offers(const FrameSight& sight) {
    if (plan_.offers.printer) pages_.look(sight, printer_.page_since_s(), findings_);
    if (!kiosk_->braille) return;
    if (sabotage_ == Sabotage::deaf_display) kiosk_->braille->contents.forget();
    const std::span<const HeardThing> heard(heard_->things);
    line_.look(sight, *kiosk_->braille, heard.subspan(std::exchange(read_, heard.size())),
               findings_);
}

void SimHouse::forget_heard() {
    read_ = 0;
    for (const HeardThing& thing : heard_->things)
        if (!thing.text.empty()) ++figures_.utterances;
    heard_before_ += heard_->things.size();
    heard_->things.clear();
}

}  // namespace touchline
