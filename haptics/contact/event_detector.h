// Finds the events worth telling of the hand in the contact machine's reports, tick by tick.
// Threads: one, the servo's. A plain value; no allocation.
#pragma once

#include "config/types/contact_event.h"
#include "config/types/hand_state.h"
#include "haptics/collision/scene.h"
#include "haptics/contact/contact_machine.h"

#include <array>
#include <cstddef>
#include <span>

namespace touchline {

/// One tick, as the detector sees it.
struct EventInput {
    double time_s = 0.0;  // does not go back
    Position p_WH;        // handle
    Mode mode = Mode::wall;
    ContactReport contact;
    double rendered_level = 0.0;
    const Scene* scene = nullptr;  // that is felt; never null
};

/// At most one event of each kind.
class TickEvents {
  public:
    void add(const ContactEvent& event) {
        if (count_ < events_.size()) events_[count_++] = event;
    }

    [[nodiscard]] std::span<const ContactEvent> all() const& { return {events_.data(), count_}; }

    std::span<const ContactEvent> all() const&& = delete;  // they would be gone

  private:
    std::array<ContactEvent, contact_event_count> events_;
    std::size_t count_ = 0;
};

/// Filters events, so that a hand at rest with up to 0.2 mm of noise does not cause one a tick:
/// * contact, outline, level and area tell of a change once it has lasted for 20 ms, and at the
///   soonest 100 ms after the last: at most 10 a second, of contact and area 5 each way;
/// * a vertex, a line crossed and an end are told at most 20 times a second each, and like another
///   outline once only until the hand has been 1 mm away from there (the side of a line counts
///   from 0.3 mm on).
class EventDetector {
  public:
    [[nodiscard]] TickEvents step(const EventInput& input);

    /// Starts a new scene: nothing is touched, and no event tells of that.
    void reset() { *this = {}; }

  private:
    /// A value that is told late and not too often.
    template <class T>
    class Settled {
      public:
        explicit Settled(T value) : told_(value), next_(value) {}

        /// Returns true if `value` is now told instead of the one before.
        bool update(T value, double time_s) {
            if (value != next_) since_s_ = time_s;
            next_ = value;
            const bool is_due = time_s - since_s_ >= lasting_s && time_s - told_s_ >= apart_s;
            if (next_ == told_ || !is_due) return false;
            told_ = next_;
            told_s_ = time_s;
            return true;
        }

        /// Takes the value without an event.
        void take(T value) { told_ = next_ = value; }

        [[nodiscard]] T told() const { return told_; }

      private:
        static constexpr double lasting_s = 0.02;
        static constexpr double apart_s = 0.1;

        T told_, next_;
        double since_s_ = -1.0;
        double told_s_ = -1.0;
    };

    /// A place that is told only once while the hand is near it.
    class Place {
      public:
        bool tell(Position p, double time_s) {
            if (is_told_ || time_s - told_s_ < apart_s) return false;
            is_told_ = true;
            place_ = p;
            told_s_ = time_s;
            return true;
        }

        [[nodiscard]] bool is_told() const { return is_told_; }

        void watch(Position p) {
            if (norm(p - place_) > away_m) is_told_ = false;
        }

      private:
        static constexpr double away_m = 1e-3;
        static constexpr double apart_s = 0.05;

        Position place_;
        double told_s_ = -1.0;
        bool is_told_ = false;
    };

    [[nodiscard]] bool has_passed_corner(const EventInput& input) const;
    void tell_contact(const EventInput& input, TickEvents& events);
    void tell_places(const EventInput& input, TickEvents& events);
    void tell_area(const EventInput& input, TickEvents& events);

    Settled<bool> is_touching_{false};
    Settled<int> outline_{-1};
    Settled<double> level_{0.0};
    Settled<bool> is_inside_{true};
    bool is_first_ = true;
    Place vertex_, crossing_, end_, change_;  // change_: of outline
    int last_outline_ = -1;                   // of the contact in the last tick
    int last_piece_ = -1;
    double last_parameter_ = 0.0;
    int side_ = 0;  // of the line, where the hand last was clearly; 0: not known
};

}  // namespace touchline
