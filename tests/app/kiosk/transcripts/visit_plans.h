// The whole visits whose transcripts are kept (tests/data/transcripts). Threads: one.
#pragma once

#include "tests/app/kiosk/transcripts/staged_kiosk.h"

#include <span>
#include <string>
#include <string_view>

namespace touchline {

/// A visitor who goes by keys and item ids, never by names.
struct VisitPlan {
    std::string_view name;
    void (*act)(StagedKiosk& kiosk);
    SwitchUse two_switches = SwitchUse::none;
    bool offers_drawing = false;
    bool has_printer = false;
};

/// Returns the plans: visitors of every kind, and the staff.
[[nodiscard]] std::span<const VisitPlan> visit_plans();

/// Takes a second or two for some minutes of visit. `language`: code. Throws std::runtime_error if
/// the kiosk does not offer what the plan chooses.
[[nodiscard]] Transcript act_out(const VisitPlan& plan, const std::string& language);

/// Returns the line above a visit in the page of a language, "# first-visit", and the empty line.
[[nodiscard]] std::string heading_of(const VisitPlan& plan);

}  // namespace touchline
