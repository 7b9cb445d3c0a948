#include "haptics/servo/exchange.h"

#include <cmath>
#include <cstring>
#include <utility>

#include <unistd.h>

namespace touchline {
namespace {

// Every comparison is written so that NaN fails it.
bool is_within(double value, double least, double most) {
    return value >= least && value <= most;
}

// A bool from another process may hold any byte.
bool is_bool(const bool& value) {
    unsigned char byte = 0;
    std::memcpy(&byte, &value, 1);
    return byte <= 1;
}

}  // namespace

bool is_sound(const ServoCommands& commands) {
    FieldCheck check;
    fields(check, commands);
    return check.is_sound();
}

bool is_sound(const ServoReport& report) {
    const HandState& hand = report.hand;
    return is_finite(hand.p_WH) && is_finite(hand.p_WP) && is_finite(hand.force) &&
           std::isfinite(hand.level) && is_within(hand.stiffness_bound.share, 0.0, 1.0) &&
           is_within(hand.stiffness_bound.most_N_per_m, 0.0, most_stiffness_N_per_m) &&
           hand.mode <= Mode::stay && hand.state <= ContactState::vertex && hand.outline >= -1 &&
           is_bool(hand.is_level_auto) && hand.guidance.phase <= GuidancePhase::stopped &&
           is_bool(hand.guidance.is_on_line) && hand.guidance.outline >= -1 &&
           hand.guidance.label >= -1 && is_finite(hand.guidance.leading) &&
           hand.shape <= HeldShape::key && is_bool(hand.is_shape_placed) &&
           std::isfinite(hand.angle_rad) && std::isfinite(hand.proxy_angle_rad) &&
           std::isfinite(hand.torque_Nm) && report.force.state <= ForceState::fault &&
           report.force.fault <= Fault::emergency_stop && report.force.limit <= Limit::fault;
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
