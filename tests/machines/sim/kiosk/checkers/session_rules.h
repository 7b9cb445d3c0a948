// Checks that the parts of a visit's state fit together, and that nothing of a visitor outlives the
// visit.
#pragma once

#include "tests/machines/sim/kiosk/checkers/sight.h"

#include <fmt/format.h>

namespace touchline {

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

}  // namespace touchline
