// Checks that every key is answered, every lasting change is heard, and no visitor is left in
// silence.
#pragma once

#include "tests/machines/sim/kiosk/checkers/sight.h"

#include <algorithm>

#include <fmt/format.h>

namespace touchline {

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
        if (sight.heard != before_ || !is_on || has_moved(sight)) alive_s_ = sight.now_s;
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

}  // namespace touchline
