// The black box: the newest ticks with their inputs and outputs, and now and then the whole step,
// so that they can be run again.
// Threads: the servo's pushes; others read while it rests or while the recorder is held.
#pragma once

#include "config/types/hand_state.h"
#include "config/types/vec2.h"
#include "haptics/servo/servo_step.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace touchline {

struct TickRecord {
    // Inputs.
    StepInput input;                   // without its scene: ...
    std::uint64_t wanted_version = 0;  // ... version of the wanted map instead; 0: none
    bool is_fading_out = false;        // the servo is about to end
    bool is_refused = false;           // the device did not take the command
    // Outputs.
    double time_s = 0.0;
    Position p_WH;  // handle
    Position p_WP;  // proxy
    Force force;    // commanded
    JointTorques torques;
    double handle_Nm = 0.0;        // torque at the handle
    double plane_share = 0.0;      // of what holds it to the plane
    double proxy_angle_rad = 0.0;  // of a held shape
    double level = 0.0;
    double stiffness_N_per_m = 0.0;
    double spring_gain = 1.0;
    ContactState state = ContactState::free;
    int outline = -1;
    std::uint64_t map_version = 0;  // map that was felt
    ForceState force_state = ForceState::off;
    Fault fault = Fault::none;
    Limit limit = Limit::none;
    GuidancePhase guidance = GuidancePhase::none;
    std::uint32_t guidance_serial = 0;
};

/// Makes the record of a tick from the step after it.
[[nodiscard]] TickRecord record_of(const StepInput& input, const ServoStep& after,
                                   const DeviceCommand& command, bool is_refused);

class Recorder {
  public:
    /// Keeps the newest `capacity` ticks; 0 keeps none. Allocates and touches all its memory here.
    explicit Recorder(std::size_t capacity = 0);

    // The servo's side. No allocation; O(1).
    /// Call before a tick.
    void begin(const ServoStep& before);
    /// Call after the tick.
    void push(const TickRecord& tick);

    /// Returns the tick pushed last; null if none is kept.
    [[nodiscard]] const TickRecord* newest() const {
        return ring_.empty() || pushed_ == 0 ? nullptr : &ring_[(pushed_ - 1) % ring_.size()];
    }

    // The other side: any one thread.
    /// Asks the servo to leave the ticks alone; is_held() tells when it does. Not allowed until an
    /// earlier hold is over.
    void hold() { gate_.is_asked.store(true, std::memory_order_relaxed); }

    [[nodiscard]] bool is_held() const { return gate_.is_shut.load(std::memory_order_acquire); }

    /// Call after is_held(). Recording goes on, and the ticks before are dropped, so that the rest
    /// has no gap.
    void release() { gate_.is_asked.store(false, std::memory_order_release); }

    /// Call while held. Overwrites every tick and step. O(capacity), some 10 ms.
    void wipe();

    /// The ticks, oldest first. O(n).
    [[nodiscard]] std::vector<TickRecord> ticks() const;

    /// The step before one of ticks(), the earliest that is kept.
    struct Start {
        std::size_t tick = 0;           // in ticks()
        std::uint64_t map_version = 0;  // map felt then; 0: none
        ServoStep step;                 // its scene may be gone by now
    };

    [[nodiscard]] std::optional<Start> start() const;

    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    static constexpr std::size_t ticks_per_step = 5000;

    /// A copy of a recorder begins with an open gate.
    struct Gate {
        std::atomic<bool> is_asked{false};
        std::atomic<bool> is_shut{false};

        Gate() = default;

        Gate(Gate&& /*other*/) noexcept {}

        Gate& operator=(Gate&& /*other*/) noexcept { return *this; }

        Gate(const Gate&) = delete;
        Gate& operator=(const Gate&) = delete;
        ~Gate() = default;
    };

    struct Kept {
        std::uint64_t tick = 0;  // counts as pushed_ does
        std::uint64_t map_version = 0;
        std::optional<ServoStep> step;
    };

    [[nodiscard]] std::uint64_t oldest() const;

    std::vector<TickRecord> ring_;
    std::vector<Kept> steps_;
    std::uint64_t pushed_ = 0;
    Gate gate_;
};

}  // namespace touchline
