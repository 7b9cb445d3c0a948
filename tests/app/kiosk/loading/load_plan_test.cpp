// Tests loading as a state machine, on an executor that ends jobs in any order, or never.
#include "app/kiosk/loading/load_plan.h"

#include "tests/app/kiosk/loading/loading_world.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

TEST(Loading, GoesFromFileToSceneInThreeJobs) {
    World world({three_pages()});
    world.want(1, 1);
    ASSERT_EQ(world.jobs->held(), 1U);
    world.end();
    world.end();
    EXPECT_TRUE(world.delivered.empty());
    world.end();
    ASSERT_EQ(world.delivered.size(), 1U);
    EXPECT_EQ(world.last(), "0 1 1 3");
    EXPECT_FALSE(world.delivered[0].is_better);
    const PagePlace place{1, 3, 1, 3};
    EXPECT_EQ(world.delivered[0].place, place);
}

TEST(Loading, AChangeOfDetailOpensAndTracesNothing) {
    World world({three_pages()});
    world.want(1, 1);
    world.until_idle();
    const int opened = world.stages->opened;
    const int found = world.stages->found;
    world.want(1, 1, 5);
    ASSERT_EQ(world.jobs->held(), 1U);
    world.end();
    EXPECT_EQ(world.last(), "0 1 1 5");
    EXPECT_EQ(world.stages->opened, opened);
    EXPECT_EQ(world.stages->found, found);
}

TEST(Loading, FetchesTheNextViewAndPageOnceThePresentIsFelt) {
    World world({three_pages()});
    world.want(1, 1);
    world.until_felt();
    EXPECT_EQ(world.stages->opened, 1);
    world.until_idle();
    EXPECT_EQ(world.stages->opened, 2);
    EXPECT_EQ(world.stages->found, 3);  // this view, the next, the first of the next page
    for (const auto& [page, view] : {std::pair(1, 2), std::pair(2, 1)}) {
        world.want(page, view);
        ASSERT_GE(world.jobs->held(), 1U);
        world.end();  // only the scene
        EXPECT_EQ(world.last(), "0 " + std::to_string(page) + " " + std::to_string(view) + " 3");
        world.until_idle();
    }
}

TEST(Loading, NothingIsFetchedBeyondTheLastPage) {
    World world({three_pages()});
    world.want(3, last_view);
    world.until_idle();
    EXPECT_EQ(world.last(), "0 3 2 3");
    EXPECT_EQ(world.stages->opened, 1);
    EXPECT_EQ(world.stages->found, 1);
}

TEST(Loading, APageThatIsBeingFetchedIsNotOpenedTwice) {
    World world({three_pages()});
    world.want(1, 3);
    world.until_felt();
    ASSERT_EQ(world.jobs->held(), 1U);  // for page 2
    world.want(2, 1);
    EXPECT_EQ(world.jobs->held(), 1U);
    world.until_felt();
    EXPECT_EQ(world.last(), "0 2 1 3");
    EXPECT_EQ(world.stages->opened, 2);
}

TEST(Loading, WhatIsWantedNextDoesNotWaitForWhatIsNotWantedAnyMore) {
    World world({three_pages(), three_pages()});
    world.want(1, 1);
    world.want(1, 1, 3, 1);
    ASSERT_EQ(world.jobs->held(), 2U);
    while (world.delivered.empty()) world.end(world.jobs->held() - 1);
    EXPECT_EQ(world.last(), "1 1 1 3");
    EXPECT_EQ(world.delivered.back().request, 2U);
}

TEST(Loading, AJobThatIsNotWantedAnyMoreIsNeverBegun) {
    World world({three_pages(), three_pages(), three_pages()});
    for (std::size_t file = 0; file < 3; ++file) world.want(1, 1, 3, file);
    world.want(1, 1, 4, 2);
    EXPECT_EQ(world.jobs->held(), 2U);  // for the first two: no more fit
    world.until_idle();
    ASSERT_EQ(world.delivered.size(), 1U);
    EXPECT_EQ(world.last(), "2 1 1 4");
    EXPECT_EQ(world.stages->built, 1);
}

TEST(Loading, AFailureSaysWhatIsKnownOfTheDocument) {
    MadeUpDocument document = three_pages();
    document.empty_views = {{1, 1}};
    document.torn_pages = {3};
    World world({document});
    world.want(1, 1);
    world.until_felt();
    EXPECT_EQ(world.last(), "empty view");
    const PagePlace known{1, 3, 1, 3};
    EXPECT_EQ(world.delivered.back().place, known);
    world.want(3, 1);
    world.until_felt();
    EXPECT_EQ(world.last(), "torn page");
    EXPECT_EQ(world.delivered.back().place.page, 3);
    EXPECT_EQ(world.delivered.back().place.page_count, 0);
}

TEST(Loading, WhatFailedInTheBackgroundIsToldOnlyWhenItIsWanted) {
    MadeUpDocument document = three_pages();
    document.torn_pages = {2};
    World world({document});
    world.want(1, 3);
    world.until_idle();
    ASSERT_EQ(world.delivered.size(), 1U);
    EXPECT_EQ(world.stages->opened, 2);  // tried once
    world.want(2, 1);
    world.until_idle();
    EXPECT_EQ(world.last(), "torn page");
}

TEST(Loading, WordsThatAreReadLaterTakeThePlaceOfTheFirstResult) {
    World world({MadeUpDocument{.figures = {0}}}, MadeUpStages::Places{{1, 1}});
    world.want(1, 1);
    world.until_felt();
    EXPECT_EQ(world.last(), "0 1 1 3");
    EXPECT_EQ(world.stages->reread_count, 0);
    world.until_idle();
    ASSERT_EQ(world.delivered.size(), 2U);
    EXPECT_EQ(world.last(), "0 1 1 3+");
    EXPECT_TRUE(world.delivered[1].is_better);
    EXPECT_EQ(world.delivered[1].request, 1U);
    world.want(1, 1, 5);
    world.until_idle();
    EXPECT_EQ(world.last(), "0 1 1 5+");
    EXPECT_EQ(world.delivered.size(), 3U);  // words are read only once
    EXPECT_EQ(world.stages->reread_count, 1);
}

TEST(Loading, NobodyWaitsForWordsToBeRead) {
    World world({MadeUpDocument{.figures = {0}}}, MadeUpStages::Places{{1, 1}});
    world.want(1, 1);
    world.until_felt();
    world.poll();
    ASSERT_EQ(world.jobs->held(), 1U);  // reading
    world.want(1, 1, 4);
    ASSERT_EQ(world.jobs->held(), 2U);
    world.end(1);
    EXPECT_EQ(world.last(), "0 1 1 4");
    world.until_idle();
    EXPECT_EQ(world.last(), "0 1 1 4+");
    EXPECT_EQ(world.delivered.back().request, 2U);
}

TEST(Loading, WhereNoWordsAreNothingComesAgain) {
    World world({MadeUpDocument{.figures = {0}}}, MadeUpStages::Places{});
    world.want(1, 1);
    world.until_idle();
    EXPECT_EQ(world.delivered.size(), 1U);
    EXPECT_EQ(world.stages->reread_count, 1);
}

TEST(Loading, NothingStaysAfterAVisitNorComesOfItsJobs) {
    World world({three_pages()});
    world.want(1, 1);
    world.until_felt();
    ASSERT_GT(world.jobs->held(), 0U) << "the next view is fetched";
    world.want(2, 1);
    const auto delivered = world.delivered.size();
    world.loader.forget();
    EXPECT_EQ(world.loader.kept_bytes(), 0U);
    world.until_idle();
    EXPECT_EQ(world.delivered.size(), delivered);
    EXPECT_EQ(world.loader.kept_bytes(), 0U);
    world.want(1, 1);
    world.until_felt();
    EXPECT_EQ(world.last(), "0 1 1 3");
}

TEST(Loading, WhatIsKeptIsBounded) {
    MadeUpDocument long_one{.figures = std::vector<int>(50, 1), .page_px = 64};
    const std::size_t page_bytes = 3 * 64 * 64;
    World world({long_one}, {}, {.jobs = 2, .kept_bytes = 6 * page_bytes});
    for (int page = 1; page <= 50; ++page) {
        world.want(page, 1);
        world.until_idle();
        EXPECT_LE(world.loader.kept_bytes(), 6 * page_bytes);
    }
    EXPECT_EQ(world.stages->opened, 50);
}

TEST(Loading, ThePresentViewIsKeptHoweverLarge) {
    MadeUpDocument large{.figures = {1, 1}, .page_px = 64};
    World world({large}, {}, {.jobs = 2, .kept_bytes = 1});
    world.want(1, 1);
    world.until_idle();
    const int opened = world.stages->opened;
    world.want(1, 1, 5);
    world.until_felt();
    EXPECT_EQ(world.last(), "0 1 1 5");
    EXPECT_LE(world.stages->opened, opened);
}

/// Returns what a request must lead to, without the state machine.
std::string expected(const MadeUpStages& stages, const FilePtr& file, int page, int view,
                     int detail) {
    const MadeUpDocument& document = stages.document(file);
    if (document.torn_pages.contains(page)) return "torn page";
    const int views = document.figures.at(static_cast<std::size_t>(page - 1)) + 1;
    const int clamped = std::min(view, views);
    if (document.empty_views.contains({page, clamped})) return "empty view";
    return MadeUpStages::title(file->name, page, clamped, detail);
}

MadeUpDocument any_document() {
    MadeUpDocument document;
    document.figures =
        *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 3)));
    const int pages = static_cast<int>(document.figures.size());
    if (*rc::gen::inRange(0, 3) == 0) document.torn_pages.insert(*rc::gen::inRange(1, pages + 1));
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i)
        document.empty_views.insert({*rc::gen::inRange(1, pages + 1), *rc::gen::inRange(1, 4)});
    return document;
}

RC_GTEST_PROP(Loading, AnyHistoryEndsWithWhatWasWantedLast, ()) {
    const std::vector<MadeUpDocument> documents{any_document(), any_document()};
    const auto with_words = *rc::gen::element<std::optional<MadeUpStages::Places>>(
        std::nullopt, MadeUpStages::Places{{1, 1}, {1, 2}, {2, 1}});
    const auto kept = static_cast<std::size_t>(*rc::gen::inRange(0, 600));
    World world(documents, with_words, {.jobs = 2, .kept_bytes = kept});
    std::map<std::uint64_t, std::string> wanted;
    std::set<std::uint64_t> cancelled;
    for (int moves = *rc::gen::inRange(1, 60); moves > 0; --moves) {
        const auto held = static_cast<int>(world.jobs->held());
        if (held == 0 || *rc::gen::inRange(0, 3) == 0) {
            const auto file = static_cast<std::size_t>(*rc::gen::inRange(0, 2));
            const auto& figures = documents[file].figures;
            const int page = *rc::gen::inRange(1, static_cast<int>(figures.size()) + 1);
            const int view = *rc::gen::element(1, 2, 3, last_view);
            const int detail = *rc::gen::inRange(1, 6);
            world.want(page, view, detail, file);
            wanted[world.request] =
                expected(*world.stages, world.stages->files()[file], page, view, detail);
        } else if (*rc::gen::inRange(0, 6) == 0) {
            world.loader.cancel();
            cancelled.insert(world.request);
        } else {
            world.end(static_cast<std::size_t>(*rc::gen::inRange(0, held)));
        }
        RC_ASSERT(world.jobs->most_at_once <= 2U);
    }
    world.until_idle();
    std::map<std::uint64_t, int> answers;
    std::uint64_t newest = 0;
    std::uint64_t felt = 0;
    for (const Delivery& delivery : world.delivered) {
        const bool is_in_turn =
            delivery.is_better ? delivery.request == felt : delivery.request > newest;
        RC_ASSERT(is_in_turn);
        newest = std::max(newest, delivery.request);
        if (delivery.scene) felt = delivery.request;
        std::string words =
            delivery.scene ? delivery.scene->facts.title : delivery.scene.error().line;
        const bool is_read = words.back() == '+';
        if (is_read) words.pop_back();
        RC_ASSERT(words == wanted.at(delivery.request));
        RC_ASSERT(delivery.is_better == (answers[delivery.request] > 0));
        RC_ASSERT(!delivery.is_better || is_read);
        ++answers[delivery.request];
    }
    RC_ASSERT(answers[world.request] >= 1 || cancelled.contains(world.request));
    for (const auto& [request, count] : answers) RC_ASSERT(count <= 2);
}

}  // namespace
}  // namespace touchline
