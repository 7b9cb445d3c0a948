// The whole visits of which transcripts are kept (tests/data/transcripts).
// Threads: one.
#pragma once

#include "tests/app/kiosk/transcripts/staged_kiosk.h"

#include <span>
#include <string>
#include <string_view>

namespace touchline {

/// Somebody who goes by keys and ids of items, never by what they are called.
struct VisitPlan {
    std::string_view name;
    void (*act)(StagedKiosk& kiosk);
    int two_switches = 0;  // as Settings has it
};

/// Eight.
[[nodiscard]] std::span<const VisitPlan> visit_plans();

/// O(its time): a second or two for some minutes. `language`: code. Throws std::runtime_error where
/// the kiosk does not offer what the plan chooses.
[[nodiscard]] Transcript act_out(const VisitPlan& plan, const std::string& language);

/// "first-visit.en.txt".
[[nodiscard]] std::string file_of(const VisitPlan& plan, const std::string& language);

}  // namespace touchline
