#include "haptics/servo/exchange.h"

#include <algorithm>
#include <utility>

#include <unistd.h>

namespace touchline {
namespace {

template <class Place>
void finite(FieldCheck& check, const Place& place) {
    check.finite(place.x);
    check.finite(place.y);
}

}  // namespace

bool PeerWatch::step(std::uint64_t beats, double dt_s) {
    if (beats != beats_) {
        beats_ = beats;
        silent_s_ = 0.0;
        has_beaten_ = true;
    } else if (!(dt_s <= longest_step_s_)) {
        silent_s_ += longest_step_s_;
    } else {
        silent_s_ += std::max(dt_s, 0.0);
    }
    return !has_beaten_ || silent_s_ >= silence_s_;
}

double ForceShare::step(bool is_wanted_off, double dt_s) {
    const bool is_fading = share_ > 0.0 && share_ < 1.0;
    if (is_wanted_off || is_fading) {
        share_ = dt_s > 0.0 ? std::max(0.0, share_ - dt_s / fade_s) : 0.0;
    } else {
        share_ = 1.0;
    }
    return share_;
}

bool is_sound(const ServoCommands& commands) {
    FieldCheck check;
    command_fields(check, commands);
    return check.is_sound();
}

bool is_sound(const ServoReport& report) {
    const HandState& hand = report.hand;
    FieldCheck check;
    finite(check, hand.p_WH);
    finite(check, hand.p_WP);
    finite(check, hand.force);
    check.finite(hand.level);
    check.number(hand.stiffness_bound.share, 0.0, 1.0);
    check.number(hand.stiffness_bound.most_N_per_m, 0.0, most_stiffness_N_per_m);
    check.choice(hand.mode, Mode::stay);
    check.choice(hand.state, ContactState::vertex);
    check.number(hand.outline, -1, std::numeric_limits<int>::max());
    check.flag(hand.is_level_auto);
    check.choice(hand.guidance.phase, GuidancePhase::stopped);
    check.flag(hand.guidance.is_on_line);
    check.number(hand.guidance.outline, -1, std::numeric_limits<int>::max());
    check.number(hand.guidance.label, -1, std::numeric_limits<int>::max());
    finite(check, hand.guidance.leading);
    check.choice(hand.shape, HeldShape::key);
    check.flag(hand.is_shape_placed);
    check.finite(hand.angle_rad);
    check.finite(hand.proxy_angle_rad);
    check.finite(hand.torque_Nm);
    check.choice(report.force.state, ForceState::fault);
    check.choice(report.force.fault, Fault::emergency_stop);
    check.choice(report.force.limit, Limit::fault);
    return check.is_sound();
}

std::optional<RealTimeTier> tier_of(const ServoChannel& channel) {
    const std::uint8_t told = channel.tier.load(std::memory_order_relaxed);
    const auto last = static_cast<std::uint8_t>(RealTimeTier::too_late);
    if (told > last) return std::nullopt;
    return static_cast<RealTimeTier>(told);
}

ServoExchange::ServoExchange() : own_(std::make_unique<ServoChannel>()), channel_(*own_) {}

void ServoChannel::begin_loop() {
    loop_process = getpid();
    loop_thread = gettid();
}

void ServoExchange::feel(std::shared_ptr<const Scene> scene) {
    const Offer offer{scene.get(), ++last_serial_};
    kept_.push_back({std::move(scene), offer.serial});
    offers_.write(offer);
    drop_unused_scenes();
}

const ServoReport& ServoExchange::report() {
    drop_unused_scenes();
    channel_.reports.update();
    return channel_.reports.value();
}

const ServoCommands& ServoExchange::commands() {
    if (channel_.commands.update()) {
        const ServoCommands told = channel_.commands.value();
        // Copied before it is checked, so that the other side cannot change it in between.
        std::atomic_signal_fence(std::memory_order_acq_rel);
        if (is_sound(told)) commands_ = told;
    }
    return commands_;
}

const Scene* ServoExchange::wanted_scene() {
    offers_.update();
    return offers_.value().scene;
}

void ServoExchange::release_older_scenes() {
    oldest_used_.store(offers_.value().serial, std::memory_order_release);
}

void ServoExchange::drop_unused_scenes() {
    const std::uint64_t oldest = oldest_used_.load(std::memory_order_acquire);
    while (!kept_.empty() && kept_.front().serial < oldest) kept_.pop_front();
}

}  // namespace touchline
