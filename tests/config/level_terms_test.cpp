#include "config/types/level_terms.h"

#include <algorithm>
#include <array>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

struct Named {
    LevelTerm term;
    double LevelTerms::*value;
};

constexpr std::array floors{
    Named{LevelTerm::speed, &LevelTerms::speed},   Named{LevelTerm::percept, &LevelTerms::percept},
    Named{LevelTerm::finest, &LevelTerms::finest}, Named{LevelTerm::encoder, &LevelTerms::encoder},
    Named{LevelTerm::radius, &LevelTerms::radius}, Named{LevelTerm::cost, &LevelTerms::cost}};
constexpr std::array ceilings{Named{LevelTerm::coarsest, &LevelTerms::coarsest},
                              Named{LevelTerm::safe, &LevelTerms::safe}};

LevelTerms any_terms() {
    const auto level = [] { return *rc::gen::inRange(0, 34) / 2.0; };
    return {level(), level(), level(), level(), level(), level(), level(), level()};
}

TEST(LevelTerms, EachFloorAloneDecides) {
    EXPECT_EQ(choose_level({}).level, 0.0);
    EXPECT_EQ(choose_level({}).by, LevelTerm::speed);
    for (const Named& floor : floors) {
        LevelTerms terms;
        terms.*floor.value = 3.0;
        EXPECT_EQ(choose_level(terms).level, 3.0);
        EXPECT_EQ(choose_level(terms).by, floor.term);
    }
}

TEST(LevelTerms, EachCeilingAloneDecidesAboveAFastHand) {
    for (const Named& ceiling : ceilings) {
        LevelTerms terms;
        terms.speed = 9.0;
        terms.*ceiling.value = 2.0;
        EXPECT_EQ(choose_level(terms).level, 2.0);
        EXPECT_EQ(choose_level(terms).by, ceiling.term);
    }
}

TEST(LevelTerms, AFixedLevelIsThatLevelUnlessItCannotBe) {
    LevelTerms terms;
    terms.finest = terms.coarsest = 1.5;
    for (const double speed : {0.0, 1.0, 9.0}) {
        terms.speed = speed;
        EXPECT_EQ(choose_level(terms).level, 1.5);
    }
    terms.cost = 4.0;
    EXPECT_EQ(choose_level(terms).level, 4.0);
    EXPECT_EQ(choose_level(terms).by, LevelTerm::cost);
    terms.safe = 1.0;
    EXPECT_EQ(choose_level(terms).level, 1.0);
    EXPECT_EQ(choose_level(terms).by, LevelTerm::safe);
}

RC_GTEST_PROP(LevelTerms, LeastOfTheCeilingsAndTheLargestFloor, ()) {
    LevelTerms terms = any_terms();
    terms.coarsest = std::max({terms.coarsest, terms.encoder, terms.radius, terms.cost});
    double largest = 0.0;
    for (const Named& floor : floors) largest = std::max(largest, terms.*floor.value);
    RC_ASSERT(choose_level(terms).level == std::min({terms.safe, terms.coarsest, largest}));
}

RC_GTEST_PROP(LevelTerms, NeverCoarserThanSafeNorFinerThanDeviceProxyAndTimeAllow, ()) {
    const LevelTerms terms = any_terms();
    const double level = choose_level(terms).level;
    RC_ASSERT(level <= terms.safe);
    RC_ASSERT(level >= std::min(terms.safe, std::max({terms.encoder, terms.radius, terms.cost})));
}

RC_GTEST_PROP(LevelTerms, TheTermNamedHasTheLevel, ()) {
    const LevelTerms terms = any_terms();
    const LevelChoice chosen = choose_level(terms);
    for (const Named& named : floors) {
        if (named.term == chosen.by && chosen.level > 0.0) {
            RC_ASSERT((terms.*named.value) == chosen.level);
        }
    }
    for (const Named& named : ceilings) {
        if (named.term == chosen.by) RC_ASSERT((terms.*named.value) == chosen.level);
    }
}

TEST(LevelTerms, ATermThatIsNoNumberBoundsNothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Named& named : floors) {
        LevelTerms terms;
        terms.*named.value = nan;
        EXPECT_EQ(choose_level(terms).level, 0.0);
    }
    for (const Named& named : ceilings) {
        LevelTerms terms;
        terms.speed = 5.0;
        terms.*named.value = nan;
        EXPECT_EQ(choose_level(terms).level, 5.0);
    }
}

}  // namespace
}  // namespace touchline
