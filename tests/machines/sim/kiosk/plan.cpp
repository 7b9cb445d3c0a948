#include "tests/machines/sim/kiosk/plan.h"

#include "tests/machines/sim/kiosk/dice.h"

#include <algorithm>

#include <fmt/format.h>

namespace touchline {
namespace {

// Purposes of dice.
constexpr std::uint64_t of_visits = 1;
constexpr std::uint64_t of_swarm = 2;
constexpr std::uint64_t of_kind = 100;

constexpr double first_visit_s = 20.0;
constexpr double apart_s = 240.0;    // leaves room for the longest end of a visit
constexpr double settling_s = 12.0;  // at the start of a visit nothing goes wrong
constexpr double calm_s = 20.0;      // nor at its end
constexpr double no_faults_at_all = 0.12;
constexpr double kind_is_there = 0.4;
constexpr double at_a_visit = 0.3;  // for a kind that is there

std::vector<PlannedVisit> visits(const PlanOptions& options) {
    Dice dice = Dice::of(options.seed, of_visits);
    std::vector<PlannedVisit> planned;
    double at_s = first_visit_s + dice.between(0.0, 60.0);
    while (at_s + apart_s < options.span_s) {
        const double length_s = dice.between(45.0, 180.0);
        planned.push_back({at_s, length_s, dice.next()});
        at_s += length_s + apart_s + dice.between(0.0, 4500.0);
    }
    return planned;
}

/// Adds the causes of one kind, independent of other kinds.
void add_kind(SimFault fault, const PlanOptions& options, const std::vector<PlannedVisit>& visits,
              std::vector<PlannedCause>& causes) {
    Dice dice = Dice::of(options.seed, of_kind + static_cast<std::uint64_t>(fault));
    const bool is_there = dice.is_hit(kind_is_there);
    const SimFaultKind& kind = kind_of(fault);
    for (const PlannedVisit& visit : visits) {
        const bool is_due = dice.is_hit(at_a_visit);
        const double at_s =
            visit.at_s + dice.between(settling_s, std::max(settling_s, visit.length_s - calm_s));
        const double span_s = dice.between(kind.shortest_s, kind.longest_s);
        const std::uint64_t seed = dice.next();
        const bool is_wanted = (options.faults & bit_of(fault)) != 0 && at_s < options.until_s;
        if (is_there && is_due && is_wanted) causes.push_back({at_s, fault, span_s, seed});
    }
}

}  // namespace

Plan make_plan(const PlanOptions& options) {
    Plan plan{options, visits(options), {}};
    Dice swarm = Dice::of(options.seed, of_swarm);
    if (swarm.is_hit(no_faults_at_all)) return plan;
    for (std::size_t i = 0; i < sim_fault_count; ++i)
        add_kind(static_cast<SimFault>(i), options, plan.visits, plan.causes);
    std::ranges::stable_sort(plan.causes, {}, &PlannedCause::at_s);
    return plan;
}

std::string text_of(const Plan& plan) {
    std::string text = fmt::format("seed {}, {:.0f} s\n", plan.options.seed, plan.options.span_s);
    for (const PlannedVisit& visit : plan.visits)
        text += fmt::format("  {:9.3f} s  a visitor, {:.0f} s\n", visit.at_s, visit.length_s);
    for (const PlannedCause& cause : plan.causes)
        text += fmt::format("  {:9.3f} s  {}, {:.4f} s\n", cause.at_s, kind_of(cause.fault).name,
                            cause.span_s);
    return text;
}

}  // namespace touchline
