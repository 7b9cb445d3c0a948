// What crosses between the servo and the rest of the kiosk: the latest commands and the scene in,
// the latest hand state and every event out. Nobody ever waits.
#pragma once

#include "config/types/contact_event.h"
#include "config/types/force_status.h"
#include "config/types/hand_state.h"
#include "haptics/collision/scene.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <type_traits>

namespace touchline {

/// The latest value, from one writer thread to one reader thread, lock-free and wait-free: three
/// slots, one with each side and one between them that both swap.
template <class T>
class TripleBuffer {
    static_assert(std::is_trivially_copyable_v<T>, "values are copied while nobody can wait");

  public:
    explicit TripleBuffer(const T& initial = T{}) { slots_.fill(initial); }

    /// Writer.
    void write(const T& value) {
        slots_[write_slot_] = value;
        const std::uint8_t free = middle_.exchange(
            static_cast<std::uint8_t>(write_slot_ | is_new_bit), std::memory_order_acq_rel);
        write_slot_ = free & slot_mask;
    }

    /// Reader: takes the newest value if there is one since the last call.
    bool update() {
        if ((middle_.load(std::memory_order_relaxed) & is_new_bit) == 0) return false;
        const std::uint8_t taken = middle_.exchange(read_slot_, std::memory_order_acq_rel);
        read_slot_ = taken & slot_mask;
        return true;
    }

    /// Reader: the value last taken.
    [[nodiscard]] const T& value() const { return slots_[read_slot_]; }

  private:
    static constexpr std::uint8_t slot_mask = 3;
    static constexpr std::uint8_t is_new_bit = 4;

    std::array<T, 3> slots_;
    std::atomic<std::uint8_t> middle_{1};
    std::uint8_t write_slot_ = 0;  // the writer's
    std::uint8_t read_slot_ = 2;   // the reader's
};

/// Values in order, from one writer thread to one reader thread, lock-free and wait-free. Where
/// `capacity` (a power of two) wait to be read, the newest are dropped and counted.
template <class T, std::size_t capacity>
class EventRing {
    static_assert(std::is_trivially_copyable_v<T>, "values are copied while nobody can wait");
    static_assert((capacity & (capacity - 1)) == 0, "indices run on past the end");

  public:
    /// Writer.
    void push(const T& value) {
        const std::uint32_t end = end_.load(std::memory_order_relaxed);
        if (end - begin_.load(std::memory_order_acquire) == capacity) {
            dropped_.fetch_add(1, std::memory_order_relaxed);
            return;
        }
        slots_[end % capacity] = value;
        end_.store(end + 1, std::memory_order_release);
    }

    /// Reader: the oldest not yet read.
    std::optional<T> pop() {
        const std::uint32_t begin = begin_.load(std::memory_order_relaxed);
        if (begin == end_.load(std::memory_order_acquire)) return std::nullopt;
        const T value = slots_[begin % capacity];
        begin_.store(begin + 1, std::memory_order_release);
        return value;
    }

    /// Either: so far.
    [[nodiscard]] std::uint64_t dropped() const { return dropped_.load(std::memory_order_relaxed); }

  private:
    std::array<T, capacity> slots_{};
    std::atomic<std::uint32_t> begin_{0};  // the reader's
    std::atomic<std::uint32_t> end_{0};    // the writer's
    std::atomic<std::uint64_t> dropped_{0};
};

/// What the operator and the session set.
struct ServoCommands {
    Mode mode = Mode::wall;
    double stiffness_N_per_m = 500.0;  // 0 < K <= 20000; rises are ramped
    double friction = 0.0;             // 0 ... 1
    double radius_m = 0.0;             // of the proxy, 0 ... 0.02, at most the scene's
    double capture_m = 0.003;          // half width of groove and ridge, > 0
    double pop_through_N = 0.0;        // push that a wall gives way to; 0: none does
    double pop_through_s = 0.3;        // how long it must last
    bool is_level_auto = true;         // by the speed of the hand
    double level = 0.0;                // fixed where not automatic, >= 0, may be fractional
    double finest_level = 0.0;         // the operator's bounds of the automatic level
    double coarsest_level = 16.0;
    bool is_force_wanted = true;       // false: off, at once
    bool is_emergency_stop = false;    // as long as it is pressed
    std::uint32_t faults_cleared = 0;  // another number: the operator clears what went wrong

    friend bool operator==(const ServoCommands&, const ServoCommands&) = default;
};

/// What the servo publishes every tick.
struct ServoReport {
    HandState hand;
    ForceStatus force;
};

/// Threads: set(), feel(), report(), next_event() from one thread, the kiosk's; the rest from the
/// servo's. Scenes are only ever freed by the kiosk's thread, once the servo has moved on to a
/// later one.
class ServoExchange {
  public:
    // The kiosk's side.
    void set(const ServoCommands& commands) { commands_.write(commands); }

    void feel(std::shared_ptr<const Scene> scene);
    /// The newest report.
    [[nodiscard]] const ServoReport& report();

    /// The oldest event not yet read. Up to 1024 wait, 10 s of the busiest hand.
    [[nodiscard]] std::optional<ContactEvent> next_event() { return events_.pop(); }

    /// So far, because nobody read them.
    [[nodiscard]] std::uint64_t dropped_events() const { return events_.dropped(); }

    // The servo's side.
    [[nodiscard]] const ServoCommands& commands();
    /// The newest scene offered, null before the first.
    [[nodiscard]] const Scene* wanted_scene();
    /// The scene named by wanted_scene() is the only one in use from here on.
    void release_older_scenes();

    void publish(const ServoReport& report) { reports_.write(report); }

    void tell(const ContactEvent& event) { events_.push(event); }

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

    TripleBuffer<ServoCommands> commands_;
    TripleBuffer<Offer> offers_;
    TripleBuffer<ServoReport> reports_;
    EventRing<ContactEvent, 1024> events_;
    std::atomic<std::uint64_t> oldest_used_{0};  // serial
    std::deque<Kept> kept_;                      // the kiosk's
    std::uint64_t last_serial_ = 0;              // the kiosk's
};

}  // namespace touchline
