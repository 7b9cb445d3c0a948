// The black box: the newest ticks, what went in and what came out, and now and then the whole step,
// so that they can be run again.
// Threads: the servo's pushes; reading is for when it rests, or when the recorder is held.
#pragma once

#include "config/types/force_status.h"
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
    // In.
    StepInput input;                   // its scene is left out: ...
    std::uint64_t wanted_version = 0;  // ... of the map wanted; 0: none
    bool is_fading_out = false;        // the servo is about to end
    bool is_refused = false;           // the device did not take the torques
    // Out.
    double time_s = 0.0;
    Position p_WH;  // handle
    Position p_WP;  // proxy
    Force force;    // commanded
    JointTorques torques;
    double handle_Nm = 0.0;        // torque at the handle
    double proxy_angle_rad = 0.0;  // of a shape that is held
    double level = 0.0;
    double stiffness_N_per_m = 0.0;
    double spring_gain = 1.0;
    ContactState state = ContactState::free;
    int outline = -1;
    std::uint64_t map_version = 0;  // felt
    ForceState force_state = ForceState::off;
    Fault fault = Fault::none;
    Limit limit = Limit::none;
    GuidancePhase guidance = GuidancePhase::none;
    std::uint32_t guidance_serial = 0;
};

/// What a tick was, read from the step after it.
[[nodiscard]] TickRecord record_of(const StepInput& input, const ServoStep& after,
                                   JointTorques torques, bool is_refused);

class Recorder {
  public:
    /// Keeps the newest `capacity` ticks; 0 keeps none. All memory is taken and touched here.
    explicit Recorder(std::size_t capacity = 0);

    // The servo's side. No allocation; O(1).
    /// Before a tick.
    void begin(const ServoStep& before);
    /// After it.
    void push(const TickRecord& tick);

    /// The last one that was pushed; null: none is kept.
    [[nodiscard]] const TickRecord* newest() const {
        return ring_.empty() || pushed_ == 0 ? nullptr : &ring_[(pushed_ - 1) % ring_.size()];
    }

    // The other side: any one thread.
    /// Asks the servo to leave the ticks as they are; is_held() tells when it does. Not while an
    /// earlier hold is left.
    void hold() { gate_.is_asked.store(true, std::memory_order_relaxed); }

    [[nodiscard]] bool is_held() const { return gate_.is_shut.load(std::memory_order_acquire); }

    /// After is_held(): from here on ticks are recorded again, and those before are gone, so that
    /// there is no gap among the rest.
    void release() { gate_.is_asked.store(false, std::memory_order_release); }

    /// While it is held: every tick and step is overwritten. O(capacity), some 10 ms.
    void wipe();

    /// Oldest first. O(n).
    [[nodiscard]] std::vector<TickRecord> ticks() const;

    /// The step before one of ticks(), as early as there is one.
    struct Start {
        std::size_t tick = 0;           // in ticks()
        std::uint64_t map_version = 0;  // felt then; 0: none
        ServoStep step;                 // its scene may be gone by now
    };

    [[nodiscard]] std::optional<Start> start() const;

    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    static constexpr std::size_t ticks_per_step = 5000;

    /// Copies of a recorder begin open.
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
        std::uint64_t tick = 0;  // counted as pushed_
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
