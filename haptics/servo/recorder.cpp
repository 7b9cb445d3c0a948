#include "haptics/servo/recorder.h"

#include "haptics/curve/large_pages.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>

namespace touchline {
namespace {

/// Leaves not one byte of the old values; a compiler cannot leave this out.
template <class T>
void overwrite(std::span<T> values) {
    for (T& value : values) {
        std::destroy_at(&value);
        ::explicit_bzero(static_cast<void*>(&value), sizeof value);
        std::construct_at(&value);
    }
}

}  // namespace

TickRecord record_of(const StepInput& input, const ServoStep& after, const DeviceCommand& command,
                     bool is_refused) {
    const HandState& hand = after.report().hand;
    const ForceStatus& force = after.report().force;
    TickRecord tick;
    tick.input = input;
    tick.input.scene = nullptr;
    tick.wanted_version = input.scene == nullptr ? 0 : input.scene->map_version;
    tick.is_fading_out = after.is_fading_out();
    tick.is_refused = is_refused;
    tick.time_s = hand.time_s;
    tick.p_WH = hand.p_WH;
    tick.p_WP = hand.p_WP;
    tick.force = hand.force;
    tick.torques = command.torques;
    tick.handle_Nm = command.handle_Nm;
    tick.plane_share = command.plane_share;
    tick.proxy_angle_rad = hand.proxy_angle_rad;
    tick.level = hand.level;
    tick.stiffness_N_per_m = hand.stiffness_N_per_m;
    tick.spring_gain = hand.spring_gain;
    tick.state = hand.state;
    tick.outline = hand.outline;
    tick.map_version = hand.map_version;
    tick.force_state = force.state;
    tick.fault = force.fault;
    tick.limit = force.limit;
    tick.guidance = hand.guidance.phase;
    tick.guidance_serial = hand.guidance.serial;
    return tick;
}

Recorder::Recorder(std::size_t capacity)
    : steps_(capacity == 0 ? 0 : capacity / ticks_per_step + 2) {
    // A minute of ticks is some ten thousand small pages, and a servo cannot start before all came.
    reserve_in_large_pages(ring_, capacity);
    ring_.resize(capacity);
}

void Recorder::begin(const ServoStep& before) {
    if (ring_.empty()) return;
    if (gate_.is_asked.load(std::memory_order_acquire)) {
        gate_.is_shut.store(true, std::memory_order_release);
        return;
    }
    if (gate_.is_shut.load(std::memory_order_relaxed)) {
        gate_.is_shut.store(false, std::memory_order_relaxed);
        pushed_ = 0;
        for (Kept& kept : steps_) kept.step.reset();
    }
    if (pushed_ % ticks_per_step != 0) return;
    Kept& kept = steps_[pushed_ / ticks_per_step % steps_.size()];
    kept.tick = pushed_;
    kept.map_version = before.scene() == nullptr ? 0 : before.scene()->map_version;
    // A shape in the hand is not part of the flat step, so a run cannot start while one is held.
    kept.step = before.holds_shape() ? std::nullopt : std::optional(before);
}

void Recorder::push(const TickRecord& tick) {
    if (ring_.empty() || gate_.is_shut.load(std::memory_order_relaxed)) return;
    ring_[pushed_ % ring_.size()] = tick;
    ++pushed_;
}

void Recorder::wipe() {
    overwrite(std::span(ring_));
    overwrite(std::span(steps_));
    pushed_ = 0;
}

std::uint64_t Recorder::oldest() const {
    return pushed_ - std::min<std::uint64_t>(pushed_, ring_.size());
}

std::vector<TickRecord> Recorder::ticks() const {
    std::vector<TickRecord> result;
    result.reserve(static_cast<std::size_t>(pushed_ - oldest()));
    for (std::uint64_t i = oldest(); i < pushed_; ++i) result.push_back(ring_[i % ring_.size()]);
    return result;
}

std::optional<Recorder::Start> Recorder::start() const {
    const Kept* found = nullptr;
    for (const Kept& kept : steps_) {
        const bool is_inside = kept.step && kept.tick >= oldest() && kept.tick < pushed_;
        if (is_inside && (found == nullptr || kept.tick < found->tick)) found = &kept;
    }
    if (found == nullptr) return std::nullopt;
    return Start{static_cast<std::size_t>(found->tick - oldest()), found->map_version,
                 *found->step};
}

std::size_t Recorder::memory_bytes() const {
    return ring_.size() * sizeof(TickRecord) + steps_.size() * sizeof(Kept);
}

}  // namespace touchline
