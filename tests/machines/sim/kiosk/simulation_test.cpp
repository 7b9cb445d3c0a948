// Tests short simulated sites every day: none fails, seeds that once failed now hold, a seed
// repeats exactly, and sabotage is noticed.
#include "tests/machines/sim/kiosk/simulation.h"

#include "tests/machines/sim/kiosk/sim_report.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double short_s = 420.0;

Plan plan_of(std::uint64_t seed, double span_s = short_s) {
    PlanOptions options;
    options.seed = seed;
    options.span_s = span_s;
    return make_plan(options);
}

/// Reads a line "SEED SPAN SITE reason" for each, SITE plain or whole; # begins a comment.
std::vector<PlanOptions> seeds_that_failed() {
    std::ifstream file(TOUCHLINE_SOURCE_DIR "/tests/machines/sim/kiosk/seeds");
    std::vector<PlanOptions> seeds;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.front() == '#') continue;
        PlanOptions options;
        std::string site;
        std::istringstream(line) >> options.seed >> options.span_s >> site;
        options.is_plain = site == "plain";
        seeds.push_back(options);
    }
    return seeds;
}

void expect_held(const Plan& plan, const SimFigures& figures) {
    if (!figures.failure) return;
    ADD_FAILURE() << text_of(plan) << figures.failure->at_s << " s: " << figures.failure->checker
                  << ": " << figures.failure->words;
}

TEST(Simulation, HousesHoldWhateverGoesWrong) {
    SimFigures all;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Plan plan = plan_of(seed);
        const SimFigures figures = simulate(plan);
        expect_held(plan, figures);
        all.add(figures);
    }
    EXPECT_GT(all.ticks, 100'000U);
    EXPECT_GT(all.pictures, 3U);
    EXPECT_GT(all.cues, 20U);
    EXPECT_GT(all.most_N, 0.5) << "somebody has felt something";
}

TEST(Simulation, SeedsThatOnceFailedHold) {
    const std::vector<PlanOptions> seeds = seeds_that_failed();
    EXPECT_FALSE(seeds.empty());
    for (const PlanOptions& options : seeds) {
        const Plan plan = make_plan(options);
        expect_held(plan, simulate(plan));
    }
}

TEST(Simulation, ASeedIsItselfAgain) {
    const SimFigures first = simulate(plan_of(4, 240.0));
    const SimFigures again = simulate(plan_of(4, 240.0));
    EXPECT_GT(first.hashes.size(), 200U);
    EXPECT_EQ(first.hashes, again.hashes);
    EXPECT_NE(first.hashes, simulate(plan_of(5, 240.0)).hashes);
}

/// Returns the first checker that notices the sabotage, among some seeds.
std::string found_by(Sabotage sabotage) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const SimFigures figures = simulate(plan_of(seed), sabotage);
        if (figures.failure) return figures.failure->checker;
    }
    return "nobody";
}

TEST(Sabotage, TwiceTheTorqueIsSeen) {
    const std::string checker = found_by(Sabotage::doubled_torque);
    EXPECT_TRUE(checker == "force limits" || checker == "board truth") << checker;
}

TEST(Sabotage, TorqueThatNeverGoesIsSeen) {
    const std::string checker = found_by(Sabotage::held_torque);
    EXPECT_TRUE(checker == "zero deadline" || checker == "board truth" || checker == "no hand")
        << checker;
}

TEST(Sabotage, SilenceIsSeen) {
    EXPECT_EQ(found_by(Sabotage::silent_sound), "answers");
}

TEST(Sabotage, PicturesThatNeverComeAreSeen) {
    EXPECT_EQ(found_by(Sabotage::lost_jobs), "session rules");
}

/// The first checker that notices it at a site that offers something of SiteOffers.
std::string found_where(bool SiteOffers::*offered, Sabotage sabotage, double span_s) {
    for (std::uint64_t seed = 1, tried = 0; tried < 4; ++seed) {
        const Plan plan = plan_of(seed, span_s);
        if (!(plan.offers.*offered) || plan.visits.empty()) continue;
        ++tried;
        const SimFigures figures = simulate(plan, sabotage);
        if (figures.failure) return figures.failure->checker;
    }
    return "nobody";
}

TEST(Sabotage, APageThatStaysInTheSpoolIsSeen) {
    EXPECT_EQ(found_where(&SiteOffers::printer, Sabotage::kept_pages, 900.0), "pages");
}

TEST(Sabotage, ADisplayThatIsToldNothingIsSeen) {
    EXPECT_EQ(found_where(&SiteOffers::braille, Sabotage::deaf_display, short_s), "braille");
}

TEST(Sabotage, AGuardThatLooksAwayIsSeen) {
    // While torque is off, another checker notices it a little later.
    std::string checker = "nobody";
    for (std::uint64_t seed = 1; seed < 200 && checker != "zero deadline"; ++seed) {
        PlanOptions options;
        options.seed = seed;
        options.span_s = short_s;
        options.faults = bit_of(SimFault::servo_frozen);
        const Plan plan = make_plan(options);
        if (plan.causes.empty()) continue;
        const SimFigures figures = simulate(plan, Sabotage::deaf_guard);
        if (figures.failure) checker = figures.failure->checker;
    }
    EXPECT_EQ(checker, "zero deadline");
}

TEST(Plan, LeavingAKindOutChangesNothingOfTheOthers) {
    PlanOptions options;
    options.seed = 104;
    const Plan whole = make_plan(options);
    ASSERT_GT(whole.causes.size(), 2U);
    options.faults &= ~bit_of(whole.causes.front().fault);
    const Plan fewer = make_plan(options);
    EXPECT_LT(fewer.causes.size(), whole.causes.size());
    for (const PlannedCause& cause : fewer.causes) {
        const bool is_there = std::ranges::any_of(whole.causes, [&](const PlannedCause& other) {
            return other.at_s == cause.at_s && other.fault == cause.fault &&
                   other.span_s == cause.span_s && other.seed == cause.seed;
        });
        EXPECT_TRUE(is_there) << kind_of(cause.fault).name;
    }
}

TEST(Plan, APlainSiteIsTheSameWithoutWhatItOffers) {
    int offering = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        PlanOptions options;
        options.seed = seed;
        const Plan whole = make_plan(options);
        options.is_plain = true;
        const Plan plain = make_plan(options);
        ASSERT_EQ(plain.visits.size(), whole.visits.size());
        ASSERT_EQ(plain.causes.size(), whole.causes.size());
        for (std::size_t i = 0; i < plain.visits.size(); ++i) {
            const PlannedVisit& visit = plain.visits[i];
            EXPECT_EQ(visit.seed, whole.visits[i].seed);
            EXPECT_FALSE(visit.draws || visit.prints || visit.reads);
        }
        const SiteOffers& offers = whole.offers;
        offering += offers.drawing && offers.printer ? 1 : 0;
    }
    EXPECT_GT(offering, 2) << "also several things at one site";
}

TEST(Plan, SomeSeedsHaveNoFaultAtAllAndEveryKindComesInSome) {
    std::array<int, sim_fault_count> planned{};
    int without = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const Plan plan = plan_of(seed, 3600.0);
        without += plan.causes.empty() ? 1 : 0;
        for (const PlannedCause& cause : plan.causes)
            ++planned[static_cast<std::size_t>(cause.fault)];
    }
    EXPECT_GT(without, 20);
    for (const int count : planned) EXPECT_GT(count, 20);
}

TEST(Shrink, LeavesTheOneFaultThatMatters) {
    PlanOptions options;
    Plan plan = make_plan(options);
    while (plan.causes.size() < 6) {
        ++options.seed;
        plan = make_plan(options);
    }
    const SimFault guilty = plan.causes[2].fault;
    const auto run = [guilty](const Plan& tried) -> std::optional<SimFailure> {
        for (const PlannedCause& cause : tried.causes)
            if (cause.fault == guilty) return SimFailure{cause.at_s, "made up", ""};
        return std::nullopt;
    };
    const Plan smallest = shrunk(plan, run);
    ASSERT_EQ(smallest.causes.size(), 1U);
    EXPECT_EQ(smallest.causes.front().fault, guilty);
}

TEST(SimReport, FiguresComeBackFromTheirFile) {
    SimFigures figures;
    figures.seeds = 3;
    figures.most_N = 2.5;
    figures.fired[4] = 7;
    figures.zero_s[5] = 0.25e-3;
    const auto read = read_stored(stored(figures));
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(stored(*read), stored(figures));
    EXPECT_FALSE(read_stored("seeds 3\n").has_value());
}

TEST(SimReport, RowsOfTheTableSayWhetherTheyPassed) {
    SimFigures figures;
    figures.failed_seeds = 1;
    const std::string csv = reliability_csv(figures, "here");
    EXPECT_TRUE(csv.starts_with("row,figure,value,bar,passed,how\n"));
    EXPECT_NE(csv.find("\"seeds; of these failed\",\"0; 1\",\"0 failed\",\"no\",\"here\""),
              std::string::npos)
        << csv;
}

}  // namespace
}  // namespace touchline
