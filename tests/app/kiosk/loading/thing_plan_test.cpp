// Tests photographs: their main things, and the thing under a hand.
#include "tests/app/kiosk/loading/loading_world.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// A photograph with so many main things, felt as a whole; the search has not started.
World photograph(int things) {
    World world({MadeUpDocument{.figures = {0}, .photos = {{1, things}}}}, {}, {}, true);
    world.want(1, 1);
    world.until_felt();
    return world;
}

TEST(Loading, APhotographIsFeltAtOnceAndItsMainThingsAreViewsOfItLater) {
    World world = photograph(2);
    EXPECT_EQ(world.last(), "0 1 1 3");
    EXPECT_FALSE(world.loader.take_things());
    world.until_idle();
    const auto things = world.loader.take_things();
    ASSERT_TRUE(things);
    EXPECT_EQ(things->request, 1U);
    EXPECT_EQ(things->place, (PagePlace{1, 1, 3, 3, ThingSearch::found}));
    EXPECT_EQ(world.delivered.size(), 1U) << "nothing is taken from under a hand";
    const int found = world.stages->found;
    world.want(1, 1);
    world.until_felt();
    EXPECT_EQ(world.last(), "0 1 1 3");
    EXPECT_EQ(world.delivered.back().place, (PagePlace{1, 1, 1, 3, ThingSearch::found}));
    EXPECT_EQ(world.stages->found, found) << "its first thing was traced meanwhile";
    world.want(1, 3);
    world.until_felt();
    EXPECT_EQ(world.last(), "0 1 3 3");
    world.until_idle();
    EXPECT_EQ(world.stages->looked_count, 1);
    EXPECT_FALSE(world.loader.take_things());
}

TEST(Loading, APhotographWithoutAClearThingIsToldSoOnce) {
    World world = photograph(0);
    world.until_idle();
    const auto things = world.loader.take_things();
    ASSERT_TRUE(things);
    EXPECT_EQ(things->place, (PagePlace{1, 1, 1, 1, ThingSearch::unclear}));
    ASSERT_EQ(things->names.size(), 1U) << "what it is taken for is told all the same";
    world.want(1, 1, 5);
    world.until_idle();
    EXPECT_EQ(world.stages->looked_count, 1);
    EXPECT_EQ(world.last(), "0 1 1 5");
}

TEST(Loading, WithoutTheNetworkOfMainThingsItIsToldWhatNamesItHas) {
    World world = photograph(-2);
    EXPECT_TRUE(world.delivered.back().scene->facts.names.empty());
    world.until_idle();
    const auto things = world.loader.take_things();
    ASSERT_TRUE(things);
    EXPECT_EQ(things->place, (PagePlace{1, 1, 1, 1, ThingSearch::absent}));
    EXPECT_EQ(things->names.size(), 1U);
    world.want(1, 1, 5);
    world.until_felt();
    const LoadedFacts& facts = world.delivered.back().scene->facts;
    EXPECT_EQ(facts.place.things, ThingSearch::absent);
    EXPECT_EQ(facts.names.size(), 1U);
}

TEST(Loading, APhotographThatCannotBeLookedAtIsToldWithTheReason) {
    World world = photograph(-1);
    world.until_idle();
    const auto things = world.loader.take_things();
    ASSERT_TRUE(things);
    EXPECT_EQ(things->place, (PagePlace{1, 1, 1, 1, ThingSearch::impossible}));
    EXPECT_EQ(things->why_not, "no memory");
    world.want(1, 1, 5);
    world.until_idle();
    EXPECT_EQ(world.delivered.back().scene->facts.place.things, ThingSearch::impossible);
    EXPECT_EQ(world.stages->looked_count, 1);
}

TEST(Loading, APhotographThatStaysUnderTheHandIsReadAfterItsThingsAreKnown) {
    World world({MadeUpDocument{.figures = {0}, .photos = {{1, 1}}}}, MadeUpStages::Places{{1, 2}},
                {}, true);
    world.want(1, 1);
    world.until_idle();
    EXPECT_EQ(world.last(), "0 1 2 3+");
    EXPECT_TRUE(world.delivered.back().is_better);
    EXPECT_EQ(world.delivered.back().place, (PagePlace{1, 1, 2, 2, ThingSearch::found}));
    const int found = world.stages->found;
    world.want(1, 2, 5);
    world.until_felt();
    EXPECT_EQ(world.stages->found, found) << "another detail of what is felt";
    world.want(1, 1);
    world.until_felt();
    world.want(1, 2);
    world.until_felt();
    EXPECT_EQ(world.stages->found, found + 1) << "who comes back feels it with its things";
}

TEST(Loading, NothingIsRenumberedUnderAnOrder) {
    World world = photograph(2);
    ASSERT_EQ(world.jobs->held(), 1U);  // looking
    world.want(1, 1, 5);
    world.end(0);  // looked at before the other detail is built
    EXPECT_FALSE(world.loader.take_things());
    world.until_felt();
    EXPECT_EQ(world.last(), "0 1 1 5");
    EXPECT_EQ(world.delivered.back().place.view_count, 1);
    world.until_idle();
    EXPECT_EQ(world.stages->looked_count, 2) << "and looked at again";
    const auto things = world.loader.take_things();
    ASSERT_TRUE(things);
    EXPECT_EQ(things->request, 2U);
    EXPECT_EQ(things->place.view, 3);
}

TEST(Loading, APhotographThatWasLookedAtIsNotSaidToBeLookedForAgain) {
    World world = photograph(0);
    EXPECT_EQ(world.delivered.back().scene->facts.place.things, ThingSearch::under_way);
    world.until_idle();
    world.want(1, 1, 5);
    world.until_idle();
    EXPECT_EQ(world.delivered.back().scene->facts.place.things, ThingSearch::unclear);
}

TEST(Loading, TheThingUnderAHandIsTheLastViewBeforeTheWhole) {
    World world = photograph(2);
    world.until_idle();
    (void)world.loader.take_things();
    world.want_thing(3, {-0.01, 0.0});
    world.until_felt();
    EXPECT_EQ(world.last(), "0 1 3 3");
    EXPECT_EQ(world.delivered.back().request, 2U);
    EXPECT_EQ(world.delivered.back().place, (PagePlace{1, 1, 3, 4, ThingSearch::found}));
    world.until_idle();
    EXPECT_EQ(world.stages->looked_at_count, 1);
    const int found = world.stages->found;
    world.want(1, 1);
    world.until_felt();
    EXPECT_EQ(world.delivered.back().place, (PagePlace{1, 1, 1, 4, ThingSearch::found}));
    EXPECT_EQ(world.stages->found, found) << "the other things stay known";
    world.want(1, 4);
    world.until_felt();
    EXPECT_EQ(world.delivered.back().place.view, 4);
}

TEST(Loading, AThingIsFoundByHandWhereNoneWasClear) {
    World world = photograph(0);
    world.until_idle();
    world.want_thing(1, {-0.01, 0.0});
    world.until_felt();
    EXPECT_EQ(world.delivered.back().place, (PagePlace{1, 1, 1, 2, ThingSearch::found}));
    world.want(1, last_view);
    world.until_felt();
    EXPECT_EQ(world.delivered.back().place, (PagePlace{1, 1, 2, 2, ThingSearch::found}));
}

TEST(Loading, WhereNothingLiesUnderTheHandAllStaysAsItWas) {
    World world({MadeUpDocument{.figures = {0}, .photos = {{1, 2}}}}, MadeUpStages::Places{{1, 3}},
                {}, true);
    world.want(1, 1);
    world.until_felt();
    world.end();  // looked at
    world.want_thing(3, {0.01, 0.0});
    world.until_felt();
    EXPECT_EQ(world.last(),
              "Nothing clear was found there. Move the handle elsewhere and try again.");
    world.want_thing(3, {0.0, 0.04});
    world.until_felt();
    EXPECT_EQ(world.last(), "no memory");
    world.until_idle();
    EXPECT_EQ(world.delivered.back().request, 1U) << "what is felt is read in";
    EXPECT_EQ(world.last(), "0 1 3 3+");
    world.want(1, 3, 5);
    world.until_felt();
    EXPECT_EQ(world.last(), "0 1 3 5+");
    EXPECT_EQ(world.delivered.back().place.view_count, 3);
}

TEST(Loading, AThingThatIsNoLongerWantedChangesNothing) {
    World world = photograph(2);
    world.until_idle();
    world.want_thing(3, {-0.01, 0.0});
    ASSERT_EQ(world.jobs->held(), 1U);
    world.loader.cancel();
    const std::size_t before = world.delivered.size();
    world.until_idle();
    EXPECT_EQ(world.delivered.size(), before);
    world.want(1, 3, 5);
    world.until_felt();
    EXPECT_EQ(world.delivered.back().place, (PagePlace{1, 1, 3, 3, ThingSearch::found}));
}

TEST(Loading, AThingThatWasFoundButNotFeltRenumbersNothing) {
    World world = photograph(0);
    world.until_idle();
    world.want_thing(1, {-0.01, 0.0});
    world.end();  // found
    world.end();  // and traced, but not built
    world.loader.cancel();
    world.until_idle();
    world.want(1, 1, 5);
    world.until_felt();
    EXPECT_EQ(world.last(), "0 1 1 5");
    EXPECT_EQ(world.delivered.back().place.view_count, 1) << "the whole, as it was felt";
}

TEST(Loading, AThingWithoutALineLeavesAllAsItWas) {
    MadeUpDocument document{.figures = {0}, .photos = {{1, 2}}};
    document.empty_views = {{1, 3}};
    World world({document}, {}, {}, true);
    world.want(1, 1);
    world.until_idle();
    const auto things = world.loader.take_things();
    ASSERT_TRUE(things);
    world.want_thing(1, {-0.01, 0.0});
    world.until_felt();
    EXPECT_EQ(world.last(), "empty view");
    world.want(1, 1);
    world.until_felt();
    EXPECT_EQ(world.delivered.back().place, (PagePlace{1, 1, 1, 3, ThingSearch::found}));
}

TEST(Loading, ALookThatEndsWhileAnotherPictureIsOpenedIsDoneAgainForWhoComesBack) {
    World world({MadeUpDocument{.figures = {0}, .photos = {{1, 2}}}, three_pages()}, {}, {}, true);
    world.want(1, 1);
    world.until_felt();
    ASSERT_EQ(world.jobs->held(), 1U);  // looking
    world.want(1, 1, 3, 1);
    world.end(0);  // looked at while the other one is opened
    world.loader.cancel();
    world.until_idle();
    const auto things = world.loader.take_things();
    ASSERT_TRUE(things) << "whoever feels it is told";
    EXPECT_EQ(things->request, 1U);
    EXPECT_EQ(things->place, (PagePlace{1, 1, 3, 3, ThingSearch::found}));
}

TEST(Loading, APictureThatFailsLeavesThePhotographToBeLookedAt) {
    MadeUpDocument torn = three_pages();
    torn.torn_pages = {1};
    World world({MadeUpDocument{.figures = {0}, .photos = {{1, 2}}}, torn}, {}, {}, true);
    world.want(1, 1);
    world.until_felt();
    world.want(1, 1, 3, 1);
    while (world.last() != "torn page") world.end(world.jobs->held() - 1);
    world.until_idle();
    const auto things = world.loader.take_things();
    ASSERT_TRUE(things);
    EXPECT_EQ(things->request, 1U);
}

TEST(Loading, OneThingIsLookedForAtATime) {
    World world = photograph(2);
    world.until_idle();
    world.want_thing(3, {-0.01, 0.0});
    world.loader.cancel();
    world.want_thing(3, {-0.02, 0.0});
    world.poll();
    EXPECT_EQ(world.jobs->held(), 1U);
    world.until_felt();
    EXPECT_EQ(world.delivered.back().request, 3U);
    EXPECT_EQ(world.delivered.back().place, (PagePlace{1, 1, 3, 4, ThingSearch::found}));
}

TEST(Loading, WhatWasFoundOfAPhotographThatNobodyFeelsAnyMoreIsNotTold) {
    World world = photograph(1);
    ASSERT_EQ(world.jobs->held(), 1U);  // looking
    world.loader.forget();
    world.until_idle();
    EXPECT_FALSE(world.loader.take_things());
    EXPECT_EQ(world.loader.kept_bytes(), 0U);
}

}  // namespace
}  // namespace touchline
