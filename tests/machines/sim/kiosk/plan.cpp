#include "tests/machines/sim/kiosk/plan.h"

#include "tests/haptics/tick.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr double stale_s = 5e-3;
constexpr double lost_peer_s = 20e-3;
// Clearing a halt takes a millisecond: a tick that comes early after a late one finds it
// unfinished.
constexpr double halted_s = 2.0 * tick_s;
constexpr std::optional<double> goes_on{};

constexpr std::array kinds{
    SimFaultKind{"short send", LinkFault::short_send, 0.0, 0.0, tick_s},
    SimFaultKind{"late send", LinkFault::late_send, 1e-3, 1e-2, goes_on},
    SimFaultKind{"lost send", LinkFault::lost_send, 0.0, 0.0, goes_on},
    SimFaultKind{"stall, out", LinkFault::stalled_send, 0.0, 0.0, halted_s},
    SimFaultKind{"late reply", LinkFault::late_reply, 1e-3, 3e-2, stale_s},
    SimFaultKind{"lost reply", LinkFault::lost_reply, 0.0, 0.0, goes_on},
    SimFaultKind{"garbled reply", LinkFault::garbled_reply, 0.0, 0.0, goes_on},
    SimFaultKind{"wrong length", LinkFault::cut_reply, 0.0, 0.0, tick_s},
    SimFaultKind{"duplicate", LinkFault::duplicate_reply, 0.0, 0.0, tick_s},
    SimFaultKind{"zero-length packet", LinkFault::empty_packet, 0.0, 0.0, goes_on},
    SimFaultKind{"stall, in", LinkFault::stalled_reply, 0.0, 0.0, halted_s},
    SimFaultKind{"failed transfer", LinkFault::failed_reply, 0.0, 0.0, tick_s},
    SimFaultKind{"unconfigured", LinkFault::reset_board, 0.0, 0.0, stale_s + tick_s},
    SimFaultKind{"unplugged", LinkFault::unplugged_before, 0.3, 6.0, tick_s},
    SimFaultKind{"unplugged in mid-transfer", LinkFault::unplugged_after, 0.3, 6.0, tick_s},
    SimFaultKind{"encoder jump", LinkFault::lost_counts, 0.0, 0.0, tick_s},
    SimFaultKind{"angle not a number", LinkFault::none, 0.0, 0.0, tick_s},
    SimFaultKind{"servo late", LinkFault::none, 1e-4, 8e-3, goes_on},
    SimFaultKind{"machine stands still", LinkFault::none, 1e-2, 5e-2, goes_on},
    SimFaultKind{"kiosk frozen", LinkFault::none, 0.03, 1.5, lost_peer_s},
    SimFaultKind{"kiosk's main thread hangs", LinkFault::none, 0.6, 2.0, lost_peer_s},
    SimFaultKind{"screen starved", LinkFault::none, 0.05, 0.4, goes_on},
    SimFaultKind{"kiosk killed", LinkFault::none, 0.5, 2.0, lost_peer_s},
    SimFaultKind{"servo killed", LinkFault::none, 0.0, 0.0, lost_peer_s},
    SimFaultKind{"servo frozen", LinkFault::none, 0.0, 0.0, lost_peer_s + 10e-3},
    SimFaultKind{"emergency stop", LinkFault::none, 0.5, 4.0, tick_s},
    SimFaultKind{"hand off", LinkFault::none, 0.5, 25.0, goes_on},
    SimFaultKind{"handle thrown", LinkFault::none, 0.2, 0.5, goes_on},
    SimFaultKind{"decoder hangs", LinkFault::none, 6.0, 6.0, goes_on},
    SimFaultKind{"decoder crashes", LinkFault::none, 0.01, 0.5, goes_on},
    SimFaultKind{"decoder lies", LinkFault::none, 0.01, 1.0, goes_on},
    SimFaultKind{"decoder slow", LinkFault::none, 1.0, 5.5, goes_on},
    SimFaultKind{"stick yanked", LinkFault::none, 0.01, 12.0, goes_on},
    SimFaultKind{"camera lost", LinkFault::none, 0.5, 15.0, goes_on},
    SimFaultKind{"disk full", LinkFault::none, 5.0, 60.0, goes_on},
    SimFaultKind{"clock step", LinkFault::none, 5.0, 60.0, goes_on},
    SimFaultKind{"settings corrupt", LinkFault::none, 1.0, 20.0, goes_on},
    SimFaultKind{"sound lost", LinkFault::none, 1.0, 15.0, goes_on},
    SimFaultKind{"headphones out", LinkFault::none, 0.5, 20.0, goes_on},
};
static_assert(kinds.size() == sim_fault_count);

// Purposes of dice.
constexpr std::uint64_t of_visits = 1;
constexpr std::uint64_t of_swarm = 2;
constexpr std::uint64_t of_offers = 4;
constexpr std::uint64_t of_kind = 100;

constexpr double first_visit_s = 20.0;
constexpr double apart_s = 240.0;    // leaves room for the longest end of a visit
constexpr double settling_s = 12.0;  // at the start of a visit nothing goes wrong
constexpr double calm_s = 20.0;      // nor at its end
constexpr double no_faults_at_all = 0.12;
constexpr double kind_is_there = 0.4;
constexpr double at_a_visit = 0.3;  // for a kind that is there
constexpr double is_offered = 0.3;
constexpr double is_taken = 0.7;  // of what is offered, by a visitor

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

/// What the site offers, and who takes it.
SiteOffers offers(const PlanOptions& options, std::vector<PlannedVisit>& visits) {
    if (options.is_plain) return {};
    Dice dice = Dice::of(options.seed, of_offers);
    SiteOffers offered;
    offered.drawing = dice.is_hit(is_offered);
    offered.printer = dice.is_hit(is_offered);
    offered.braille = dice.is_hit(is_offered);
    for (PlannedVisit& visit : visits) {
        visit.draws = dice.is_hit(is_taken) && offered.drawing;
        visit.prints = dice.is_hit(is_taken) && offered.printer;
        visit.reads = dice.is_hit(is_taken) && offered.braille;
    }
    return offered;
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

std::span<const SimFaultKind> sim_fault_kinds() {
    return kinds;
}

const SimFaultKind& kind_of(SimFault fault) {
    return kinds.at(static_cast<std::size_t>(fault));
}

std::optional<SimFault> fault_named(std::string_view name) {
    const auto at = std::ranges::find(kinds, name, &SimFaultKind::name);
    if (at == kinds.end()) return std::nullopt;
    return static_cast<SimFault>(at - kinds.begin());
}

Plan make_plan(const PlanOptions& options) {
    Plan plan{options, {}, visits(options), {}};
    plan.offers = offers(options, plan.visits);
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
        text +=
            fmt::format("  {:9.3f} s  a visitor{}{}{}, {:.0f} s\n", visit.at_s,
                        visit.draws ? " who is drawn for" : "", visit.prints ? " who prints" : "",
                        visit.reads ? " who reads braille" : "", visit.length_s);
    for (const PlannedCause& cause : plan.causes)
        text += fmt::format("  {:9.3f} s  {}, {:.4f} s\n", cause.at_s, kind_of(cause.fault).name,
                            cause.span_s);
    return text;
}

}  // namespace touchline
