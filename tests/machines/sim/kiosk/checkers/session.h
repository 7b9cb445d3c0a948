// Checkers of the visit: answers, readiness, what belongs together, and what piles up.
#pragma once

#include "tests/machines/sim/kiosk/checkers/sight.h"

#include <algorithm>

#include <fmt/format.h>

namespace touchline {

/// Checks that the parts of a visit's state fit together, and that nothing of a visitor outlives
/// the visit.
class SessionRulesChecker {
  public:
    /// Call this when another kiosk was started: it begins anew.
    void begin_anew() { before_ = VisitScreen::attract; }

    void look(const FrameSight& sight, Findings& findings) {
        const auto& [house, visitor] = sight.kiosk.visit();
        const VisitScreen now = open_screen(sight.kiosk.visit());
        const auto demand = [&](bool holds, const char* words) {
            findings.demand(holds, "session rules", sight.now_s, [&] {
                return fmt::format("{}, on screen {} after {}", words, static_cast<int>(now),
                                   static_cast<int>(before_));
            });
        };
        const bool is_on = is_visit_on(sight.kiosk.visit());
        const bool is_working = visitor.loading || visitor.is_capturing || visitor.waiting;
        demand(!needs_picture(now) || visitor.felt, "nothing is felt");
        demand(now != VisitScreen::trouble || !visitor.error.empty(), "a trouble without words");
        demand(now != VisitScreen::opening || is_working, "nobody knows what is waited for");
        const bool waits_long =
            visitor.waiting && house.now_s - visitor.waiting->since_s > longest_work_s;
        demand(!waits_long, "work that was waited for never ended");
        demand(is_legal(before_, now), "this screen cannot come now");
        demand(is_on || !visitor.felt, "a picture outlived its visit");
        demand(is_on || !sight.commands.is_force_wanted, "force is wanted and nobody is here");
        before_ = now;
    }

  private:
    static constexpr double longest_work_s = 30.0;  // workers are stopped long before

    static bool needs_picture(VisitScreen screen) {
        return screen == VisitScreen::picture || screen == VisitScreen::parts ||
               screen == VisitScreen::explore || screen == VisitScreen::zoom ||
               screen == VisitScreen::pages;
    }

    /// Nothing can be chosen before somebody has begun, nor after goodbye.
    static bool is_legal(VisitScreen before, VisitScreen now) {
        const bool was_outside = before == VisitScreen::attract || before == VisitScreen::goodbye ||
                                 before == VisitScreen::closed;
        if (before == now || !was_outside) return true;
        return now == VisitScreen::attract || now == VisitScreen::language ||
               now == VisitScreen::choose || now == VisitScreen::goodbye ||
               now == VisitScreen::closed || now == VisitScreen::trouble ||
               now == VisitScreen::help;
    }

    VisitScreen before_ = VisitScreen::attract;
};

/// Checks that every key is answered, every lasting change is heard, and no visitor is left in
/// silence.
class AnswersChecker {
  public:
    /// Call this just before a key is given to the kiosk.
    void ask(double now_s, std::size_t heard) {
        if (asked_s_) return;
        asked_s_ = now_s;
        heard_then_ = heard;
        is_asked_by_fault_ = false;
    }

    /// A fault stopped the frames for a while, so the kiosk could not answer.
    void excuse(double now_s) {
        asked_s_.reset();
        alive_s_ = now_s;
    }

    void look(const FrameSight& sight, SimFigures& figures, Findings& findings) {
        const bool is_on = is_visit_on(sight.kiosk.visit());
        const VisitScreen screen = open_screen(sight.kiosk.visit());
        const Fault fault = sight.kiosk.force().fault;
        if (is_on && screen != screen_) ask(sight.now_s, before_);
        if (is_on && fault > fault_ && !asked_s_) {
            ask(sight.now_s, before_);
            is_asked_by_fault_ = true;
        }
        // A fault that is over before the kiosk could speak of it is not spoken of.
        if (is_asked_by_fault_ && fault == Fault::none) asked_s_.reset();
        screen_ = screen;
        fault_ = fault;
        if (sight.heard != before_ || !is_on || sight.has_read || has_moved(sight))
            alive_s_ = sight.now_s;
        look_at_answer(sight, figures, findings);
        look_at_silence(sight, figures, findings);
        before_ = sight.heard;
    }

  private:
    static constexpr double longest_answer_s = 0.150;
    static constexpr double longest_silence_s = 100.0;  // a question comes after 90 s of rest
    static constexpr double moved_m = 0.002;            // a smaller motion is no sign of a person
    static constexpr double longest_wait_s = 5.0;       // without a sound, while work is under way

    void look_at_answer(const FrameSight& sight, SimFigures& figures, Findings& findings) {
        if (!asked_s_) return;
        const double after_s = sight.now_s - *asked_s_;
        if (sight.heard != heard_then_) {
            figures.longest_answer_s = std::max(figures.longest_answer_s, after_s);
            asked_s_.reset();
        }
        findings.demand(after_s <= longest_answer_s, "answers", sight.now_s, [&] {
            return fmt::format("nothing was heard for {:.3f} s, on screen {}, fault {}", after_s,
                               static_cast<int>(screen_), static_cast<int>(fault_));
        });
    }

    /// A hand that moves through empty places hears nothing, and need not.
    [[nodiscard]] bool has_moved(const FrameSight& sight) {
        const HandleSeen& handle = sight.kiosk.visit().visitor.handle;
        if (norm(handle.place_W - seen_W_) <= moved_m) return false;
        seen_W_ = handle.place_W;
        return !handle.is_led;
    }

    void look_at_silence(const FrameSight& sight, SimFigures& figures, Findings& findings) const {
        const double silent_s = sight.now_s - alive_s_;
        const bool is_waiting = sight.kiosk.visit().visitor.waiting.has_value();
        figures.longest_silence_s = std::max(figures.longest_silence_s, silent_s);
        findings.demand(silent_s <= (is_waiting ? longest_wait_s : longest_silence_s), "answers",
                        sight.now_s, [&] {
                            return fmt::format("a visitor was left in silence for {:.1f} s{}",
                                               silent_s, is_waiting ? " while waiting" : "");
                        });
    }

    std::optional<double> asked_s_;
    std::size_t heard_then_ = 0;
    bool is_asked_by_fault_ = false;
    std::size_t before_ = 0;
    double alive_s_ = 0.0;  // when something was last heard, or the hand last moved the handle
    Position seen_W_{};
    VisitScreen screen_ = VisitScreen::attract;
    Fault fault_ = Fault::none;
};

/// Checks that force may come again within five seconds after a fault is over.
class ReadinessChecker {
  public:
    void look(const FrameSight& sight, SimFigures& figures, Findings& findings) {
        const double after_s = sight.now_s - free_since_s_;
        if (sight.is_blocked || sight.is_servo_ready) {
            if (was_waiting_ && !sight.is_blocked)
                figures.longest_ready_s = std::max(figures.longest_ready_s, after_s);
            was_waiting_ = !sight.is_servo_ready;
            free_since_s_ = sight.now_s;
            return;
        }
        was_waiting_ = true;
        findings.demand(after_s <= longest_s, "readiness", sight.now_s, [&] {
            return fmt::format("not ready {:.1f} s after what was wrong ended, fault {}", after_s,
                               static_cast<int>(sight.kiosk.force().fault));
        });
    }

  private:
    static constexpr double longest_s = 5.0;

    double free_since_s_ = 0.0;
    bool was_waiting_ = false;
};

/// Checks that nothing piles up.
class QueuesChecker {
  public:
    void look(const FrameSight& sight, Findings& findings) {
        const auto demand = [&](bool holds, const char* what, std::size_t count) {
            findings.demand(holds, "queues", sight.now_s,
                            [&] { return fmt::format("{} {}", count, what); });
        };
        const std::size_t screens = sight.kiosk.visit().visitor.path.size();
        demand(sight.jobs <= most_jobs, "jobs of loading wait", sight.jobs);
        demand(sight.dropped_events == 0, "events of the hand were dropped",
               static_cast<std::size_t>(sight.dropped_events));
        demand(screens >= 1 && screens <= most_screens, "screens lie on each other", screens);
    }

  private:
    static constexpr std::size_t most_jobs = 8;  // two at a time, and those of the visit before
    static constexpr std::size_t most_screens = 8;
};

}  // namespace touchline
