// What crosses between the servo and the rest of the kiosk: the latest commands and the scene in,
// the latest hand state and every event out. Neither side waits for the other or trusts it.
#pragma once

#include "config/types/contact_event.h"
#include "config/types/fields.h"
#include "config/types/guidance.h"
#include "config/types/hand_state.h"
#include "config/types/triple_buffer.h"
#include "haptics/collision/scene.h"
#include "haptics/contact/proxy_state.h"
#include "haptics/safety/force_chain.h"
#include "haptics/servo/real_time.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>

namespace touchline {

/// Tells whether the peer is alive: says when its count, which should go up, has not for too long.
/// A long step counts for at most longest_step_s: a pause of the whole machine is not the peer's
/// fault.
class PeerWatch {
  public:
    PeerWatch(double silence_s, double longest_step_s)
        : silence_s_(silence_s), longest_step_s_(longest_step_s) {}

    /// Returns true while the peer is lost, which it is until its count first moves.
    [[nodiscard]] bool step(std::uint64_t beats, double dt_s);

  private:
    double silence_s_;
    double longest_step_s_;
    std::uint64_t beats_ = 0;
    double silent_s_ = 0.0;
    bool has_beaten_ = false;
};

/// A share of the force. It falls from 1 to 0 within fade_s once the force is wanted off, and is 1
/// again when it no longer is. A fade that has begun always ends at 0, so that the force comes back
/// by the arm rule.
class ForceShare {
  public:
    static constexpr double fade_s = 0.008;

    /// Returns the share, 0 ... 1.
    [[nodiscard]] double step(bool is_wanted_off, double dt_s);

  private:
    double share_ = 1.0;
};

/// A queue of values from one writer to one reader, lock-free and wait-free. While `capacity`
/// values (a power of two) wait to be read, newer ones are dropped and counted.
template <class T, std::size_t capacity>
class EventRing {
    static_assert(std::is_trivially_copyable_v<T>, "values are copied while nobody can wait");
    static_assert((capacity & (capacity - 1)) == 0, "indices run on past the end");

  public:
    /// Writer.
    void push(const T& value) {
        const std::uint32_t end = end_.load(std::memory_order_relaxed);
        if (end - begin_.load(std::memory_order_acquire) >= capacity) {
            dropped_.fetch_add(1, std::memory_order_relaxed);
            return;
        }
        slots_[end % capacity] = value;
        end_.store(end + 1, std::memory_order_release);
    }

    /// Reader: takes the oldest value not yet read. If more than `capacity` seem to wait, the peer
    /// is corrupted, and nothing is read.
    std::optional<T> pop() {
        const std::uint32_t begin = begin_.load(std::memory_order_relaxed);
        const std::uint32_t waiting = end_.load(std::memory_order_acquire) - begin;
        if (waiting == 0 || waiting > capacity) return std::nullopt;
        const T value = slots_[begin % capacity];
        begin_.store(begin + 1, std::memory_order_release);
        return value;
    }

    /// Either side: the number dropped so far.
    [[nodiscard]] std::uint64_t dropped() const { return dropped_.load(std::memory_order_relaxed); }

  private:
    static_assert(std::atomic<std::uint32_t>::is_always_lock_free &&
                  std::atomic<std::uint64_t>::is_always_lock_free);

    std::array<T, capacity> slots_{};
    std::atomic<std::uint32_t> begin_{0};  // the reader's
    std::atomic<std::uint32_t> end_{0};    // the writer's
    std::atomic<std::uint64_t> dropped_{0};
};

/// What the operator and the session set, within the ranges in command_fields().
struct ServoCommands {
    ContactSettings contact;
    bool is_level_auto = true;  // by the speed of the hand
    double level = 0.0;         // fixed level where not automatic; may be fractional
    double finest_level = 0.0;  // the operator's bounds of the automatic level
    double coarsest_level = 16.0;
    bool is_force_wanted = true;       // false: off, at once
    bool is_emergency_stop = false;    // as long as it is pressed
    std::uint32_t faults_cleared = 0;  // a changed number: the operator clears the fault
    double force_ceiling_N = 3.0;      // the operator's; rises by 1 N/s
    bool has_frame = true;             // the edge of the drawing area is felt
    bool may_rest = false;             // nobody is here: without force the loop may tick slowly
    GuidanceCommand guidance;
    PatternCommand pattern;
    HeldShape shape = HeldShape::none;  // shape felt with; lines are walls then
    double turn_rad = 0.0;  // turn of the shape, by keys or a knob, if the handle does not turn

    friend bool operator==(const ServoCommands&, const ServoCommands&) = default;
};

template <class Fields, class Commands>
void command_fields(Fields& f, Commands& c) {
    constexpr double most_level = 64.0;
    constexpr double most_turn_rad = 1e4;
    contact_fields(f, c.contact);
    f.flag(c.is_level_auto);
    f.number(c.level, 0.0, most_level);
    f.number(c.finest_level, 0.0, most_level);
    f.number(c.coarsest_level, 0.0, most_level);
    f.flag(c.is_force_wanted);
    f.flag(c.is_emergency_stop);
    f.number(c.faults_cleared);
    f.number(c.force_ceiling_N, 0.0, most_force_N);
    f.flag(c.has_frame);
    f.flag(c.may_rest);
    f.choice(c.guidance.kind, GuidanceKind::to_line);
    f.flag(c.guidance.is_held);
    f.number(c.guidance.serial);
    f.number(c.guidance.outline, -1, std::numeric_limits<std::int32_t>::max() - 1);
    f.number(c.guidance.place.x, -1.0, 1.0);
    f.number(c.guidance.place.y, -1.0, 1.0);
    f.number(c.guidance.speed_m_per_s, 0.005, 0.1);
    f.choice(c.pattern.pattern, HandlePattern::time_out);
    f.number(c.pattern.serial);
    f.choice(c.shape, HeldShape::key);
    f.number(c.turn_rad, -most_turn_rad, most_turn_rad);
}

// Name every member in command_fields(); otherwise a recorded run cannot be repeated.
static_assert(sizeof(ServoCommands) == sizeof(ContactSettings) + 120);

/// What the servo publishes every tick.
struct ServoReport {
    HandState hand;
    ForceStatus force;
};

/// Returns whether every number is finite and in its range. `commands` may hold any bytes.
[[nodiscard]] bool is_sound(const ServoCommands& commands);

/// Returns whether positions and force are finite and all states exist. `report` may hold any
/// bytes.
[[nodiscard]] bool is_sound(const ServoReport& report);

/// Everything that crosses, without pointers, so that it may lie in memory that two processes
/// share. The kiosk writes commands, kiosk_beats and is_stop_wanted; the servo writes the rest.
struct ServoChannel {
    TripleBuffer<ServoCommands> commands;
    TripleBuffer<ServoReport> reports;
    EventRing<ContactEvent, 1024> events;
    LatenessHistogram lateness;
    std::atomic<std::uint64_t> kiosk_beats{0};      // goes up while the kiosk lives
    std::atomic<std::uint64_t> servo_beats{0};      // ticks
    std::atomic<std::uint8_t> tier{0xff};           // a RealTimeTier, once the loop is made
    std::atomic<std::uint8_t> is_force_on{0};       // the device may hold torque
    std::atomic<std::uint8_t> fault{0};             // of the last tick
    std::atomic<std::uint8_t> is_device_silent{0};  // the device gave no angles in the last tick
    std::atomic<double> joint_1{std::numeric_limits<double>::quiet_NaN()};  // rad, the last that
    std::atomic<double> joint_2{std::numeric_limits<double>::quiet_NaN()};  // the device gave
    std::atomic<double> motor_heat{0.0};  // of the warmer motor (MotorHeat)
    std::atomic<std::uint8_t> is_stop_wanted{0};
    // The process and thread, as the system numbers them, that run the loop. A guard sees by them
    // that the loop is gone long before its process is. 0: there is no loop, or it has ended.
    std::atomic<std::int32_t> loop_process{0}, loop_thread{0};

    /// Marks the calling thread as the one that ticks, until it calls end_loop().
    void begin_loop();

    void end_loop() { loop_thread = 0; }
};

/// Returns the tier in the channel. Returns nothing before a servo has set it, or if it is not a
/// valid tier.
[[nodiscard]] std::optional<RealTimeTier> tier_of(const ServoChannel& channel);

/// Threads: set(), feel(), report() from the kiosk's, next_event() from any one; the rest from the
/// servo's. Only the kiosk's thread frees scenes, once the servo has moved on to a later one.
class ServoExchange {
  public:
    /// Owns its channel.
    ServoExchange();

    /// `channel` must outlive the exchange. The other side then uses nothing of this object but the
    /// scenes.
    explicit ServoExchange(ServoChannel& channel) : channel_(channel) {}

    // The kiosk's side.
    void set(const ServoCommands& commands) { channel_.commands.write(commands); }

    void feel(std::shared_ptr<const Scene> scene);
    /// Returns the newest report.
    [[nodiscard]] const ServoReport& report();

    /// Returns the oldest event not yet read. Up to 1024 wait, 10 s of the busiest hand.
    [[nodiscard]] std::optional<ContactEvent> next_event() { return channel_.events.pop(); }

    /// The number of events dropped so far because nobody read them.
    [[nodiscard]] std::uint64_t dropped_events() const { return channel_.events.dropped(); }

    // The servo's side.
    /// Returns the newest sound commands; unsound ones change nothing.
    [[nodiscard]] const ServoCommands& commands();
    /// Returns the newest scene offered, null before the first.
    [[nodiscard]] const Scene* wanted_scene();
    /// From here on the scene returned by wanted_scene() is the only one in use.
    void release_older_scenes();

    void publish(const ServoReport& report) { channel_.reports.write(report); }

    void tell(const ContactEvent& event) { channel_.events.push(event); }

    /// Heartbeats, tier and lateness.
    [[nodiscard]] ServoChannel& channel() { return channel_; }

    [[nodiscard]] const ServoChannel& channel() const { return channel_; }

  private:
    struct Offer {
        const Scene* scene = nullptr;
        std::uint64_t serial = 0;
    };

    struct Kept {
        std::shared_ptr<const Scene> scene;
        std::uint64_t serial = 0;
    };

    void drop_unused_scenes();

    std::unique_ptr<ServoChannel> own_;
    ServoChannel& channel_;
    ServoCommands commands_;  // the last sound ones
    TripleBuffer<Offer> offers_;
    std::atomic<std::uint64_t> oldest_used_{0};  // serial
    std::deque<Kept> kept_;                      // the kiosk's
    std::uint64_t last_serial_ = 0;              // the kiosk's
};

}  // namespace touchline
