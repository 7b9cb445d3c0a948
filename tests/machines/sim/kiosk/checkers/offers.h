// Checkers of what some sites offer beside: a drawing that grows under the hand, sheets to take
// home, a braille display.
#pragma once

#include "tests/app/kiosk/read_line.h"
#include "tests/machines/sim/kiosk/checkers/sight.h"
#include "tests/machines/sim/kiosk/house.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>

#include <fmt/format.h>

namespace touchline {

/// Checks that a line that comes or goes in the drawing under the hand changes the force by no more
/// than a hand can tell, beyond what its motion does in that tick and did in the one before.
class GrowingLineChecker {
  public:
    /// `drawing`: that of the map felt in the tick; 0: it is none.
    void look(const TickSight& sight, std::uint64_t drawing, SimFigures& figures,
              Findings& findings) {
        if (sight.tick == nullptr) return;
        const TickRecord& tick = *sight.tick;
        const bool has_grown = !sight.is_first_tick && drawing != 0 && drawing == drawing_ &&
                               tick.map_version != version_;
        if (has_grown && tick.force_state == ForceState::live && !sight.is_led) {
            const double moved_N = most_N_per_m * norm(tick.p_WH - handle_W_) + change_N_;
            const double told_N = norm(tick.force - force_) - moved_N;
            ++figures.grown;
            figures.most_grown_N = std::max(figures.most_grown_N, told_N);
            findings.demand(told_N <= unfelt_N, "growing line", sight.now_s, [&] {
                return fmt::format("a line that came changed the force by {:.3f} N", told_N);
            });
        }
        drawing_ = drawing;
        version_ = tick.map_version;
        change_N_ = norm(tick.force - force_);
        handle_W_ = tick.p_WH;
        force_ = tick.force;
    }

  private:
    static constexpr double unfelt_N = 0.021;       // as in tests/haptics/servo
    static constexpr double most_N_per_m = 1300.0;  // the firmest wall, and more

    std::uint64_t drawing_ = 0;
    std::uint64_t version_ = 0;
    Position handle_W_;
    Force force_;
    double change_N_ = 0.0;  // of the force in the tick before, which damping goes on with
};

/// Checks that no page of a visitor stays in the printer's spool, and that no sheet is waited for
/// in vain.
class PagesChecker {
  public:
    /// `page_since_s`: as SimPrinter tells it, in site time.
    void look(const FrameSight& sight, std::optional<double> page_since_s, Findings& findings) {
        const auto& [house, visitor] = sight.kiosk.visit();
        const double lain_s = page_since_s ? sight.now_s - *page_since_s : 0.0;
        findings.demand(lain_s <= longest_page_s, "pages", sight.now_s, [&] {
            return fmt::format("a page has been in the spool for {:.0f} s", lain_s);
        });
        if (!house.is_printing) printing_since_s_ = sight.now_s;
        const double printing_s = sight.now_s - printing_since_s_;
        findings.demand(printing_s <= longest_sheet_s, "pages", sight.now_s, [&] {
            return fmt::format("a sheet has been printed for {:.0f} s", printing_s);
        });
        findings.demand(visitor.sheets <= most_sheets, "pages", sight.now_s,
                        [&] { return fmt::format("{} sheets in one visit", visitor.sheets); });
        findings.demand(is_visit_on(sight.kiosk.visit()) || !visitor.awaits_sheet, "pages",
                        sight.now_s, [] { return std::string("nobody waits for a sheet"); });
    }

    /// Another kiosk was started: it has printed nothing.
    void begin_anew(double now_s) { printing_since_s_ = now_s; }

  private:
    // The queue is looked at every 300 s, and the settings that name it may be unreadable for 60 s.
    static constexpr double longest_page_s = SheetPrinter::check_every_s + 100.0;
    static constexpr double longest_sheet_s = 90.0;

    double printing_since_s_ = 0.0;
};

/// Checks that whatever is said stands on the braille display too, and can be paged to.
class LineChecker {
  public:
    /// `said`: since the last look.
    void look(const FrameSight& sight, const ReadLine& line, std::span<const HeardThing> said,
              Findings& findings) {
        const LineContents& contents = line.contents;
        // What is forgotten in between is no longer there, and must not be.
        const bool may_look = was_there_ && contents.width() > 0 && line.forgotten == forgotten_;
        was_there_ = contents.width() > 0;
        forgotten_ = line.forgotten;
        if (!may_look) return;
        for (const HeardThing& thing : said)
            if (!thing.text.empty()) look_for(thing, contents, sight.now_s, findings);
        const bool is_blank =
            std::ranges::all_of(contents.shown(), [](std::uint8_t cell) { return cell == 0; });
        findings.demand(!is_blank || contents.reading().texts.empty(), "braille", sight.now_s,
                        [] { return std::string("texts are there, and the line is blank"); });
    }

    /// Another kiosk was started.
    void begin_anew() { was_there_ = false; }

  private:
    static void look_for(const HeardThing& thing, const LineContents& contents, double now_s,
                         Findings& findings) {
        const auto braille = braille_of(thing.text, thing.language, BrailleGrade::uncontracted);
        const bool is_there =
            braille && std::ranges::find(contents.reading().texts, braille->cells) !=
                           contents.reading().texts.end();
        findings.demand(is_there, "braille", now_s,
                        [&] { return "not on the display: " + thing.text; });
    }

    bool was_there_ = false;
    int forgotten_ = 0;
};

}  // namespace touchline
