// A visitor of a simulated site: cannot hear but knows the screens, presses keys, moves the handle
// as people do, brings a stick, lets go, leaves. Threads: one.
#pragma once

#include "app/kiosk/kiosk.h"
#include "tests/machines/sim/board/board_emulator.h"
#include "tests/machines/sim/kiosk/plan.h"
#include "tests/machines/sim/kiosk/sim_sources.h"
#include "tests/machines/sim/kiosk/visitor_hand.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace touchline {

/// What a visitor can reach in one frame.
struct VisitorPlace {
    Kiosk& kiosk;
    BoardEmulator& board;
    VisitorHand& hand;
    SimFileSource& sticks;
    std::shared_ptr<const TactileMap> felt;  // null: nothing yet
    double now_s = 0.0;                      // site time
    double awake_s = 0.0;                    // board time
    bool is_calm = false;                    // no wild motion now: something is being waited for
};

class SimVisitor {
  public:
    explicit SimVisitor(const PlannedVisit& visit);

    /// Acts for one frame. Returns the key to press now, if any.
    [[nodiscard]] std::optional<KeyRole> act(const VisitorPlace& place);

    /// Takes the hand off the handle until then.
    void lose_grip(double until_s) { hands_off_until_s_ = until_s; }

    /// Throws the handle at this speed.
    void throw_handle(const VisitorPlace& place, double speed_m_per_s);

    /// True after saying goodbye, or after walking away and not being waited for any more.
    [[nodiscard]] bool is_gone() const { return is_gone_; }

    /// Wants to go now, and does nothing else any more.
    [[nodiscard]] bool is_leaving(double now_s) const {
        return now_s > visit_.at_s + visit_.length_s;
    }

    [[nodiscard]] bool holds_handle() const { return holds_; }

  private:
    enum class Doing : std::uint8_t { tracing, tapping, pushing, jerking, wandering, resting, off };

    void move(const VisitorPlace& place);
    void begin(Doing doing, const VisitorPlace& place);
    void go_on(const VisitorPlace& place);
    void hold(const VisitorPlace& place, const HandModel& hand);
    void let_go(const VisitorPlace& place);
    void bring_stick(const VisitorPlace& place);
    [[nodiscard]] Doing next_doing(const VisitorPlace& place);
    [[nodiscard]] std::optional<KeyRole> key(const VisitorPlace& place);
    [[nodiscard]] KeyRole key_of_screen(const VisitorPlace& place, VisitScreen screen);
    [[nodiscard]] std::optional<KeyRole> key_to_sheet(const VisitorPlace& place) const;
    [[nodiscard]] KeyRole key_while_feeling(const VisitorPlace& place);
    [[nodiscard]] Position somewhere(double most_x_m, double most_y_m);

    PlannedVisit visit_;
    Dice dice_;
    HandModel grip_;
    double pace_s_ = 1.0;  // time between keys
    double tremor_m_ = 0.0;
    bool walks_away_ = false;  // without saying goodbye
    bool keeps_off_ = false;   // hands only on the keys
    VisitItem wish_ = VisitItem::practise;
    double next_key_s_ = 0.0;
    double next_doing_s_ = 0.0;
    double hands_off_until_s_ = 0.0;
    Doing doing_ = Doing::off;
    std::size_t outline_ = 0;
    std::size_t point_ = 0;
    bool is_tap_down_ = false;
    bool holds_ = false;
    bool has_begun_ = false;
    bool has_stick_ = false;
    bool is_gone_ = false;
};

}  // namespace touchline
