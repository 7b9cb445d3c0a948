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
};

/// Returns the eight plans.
[[nodiscard]] std::span<const VisitPlan> visit_plans();

/// Takes a second or two for some minutes of visit. `language`: code. Throws std::runtime_error if
/// the kiosk does not offer what the plan chooses.
[[nodiscard]] Transcript act_out(const VisitPlan& plan, const std::string& language);

/// Returns a name such as "first-visit.en.txt".
[[nodiscard]] std::string file_of(const VisitPlan& plan, const std::string& language);

}  // namespace touchline
