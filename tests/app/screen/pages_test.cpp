#include "app/screen/pages.h"

#include "tests/app/screen/probes.h"

#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

RowBlock block_of(std::size_t rows, std::optional<std::size_t> item = {}) {
    RowBlock block{{}, item};
    for (std::size_t i = 0; i < rows; ++i) block.rows.push_back({Phrase{0.0, 10.0, "word"}});
    return block;
}

std::vector<std::size_t> phrases_a_page(const std::vector<SheetPage>& pages) {
    std::vector<std::size_t> counts;
    for (const SheetPage& page : pages) counts.push_back(page.phrases.size());
    return counts;
}

TEST(Pages, ABlockThatDoesNotFitGoesToTheNextPageWhole) {
    const std::vector<RowBlock> blocks{block_of(2), block_of(2), block_of(1)};
    EXPECT_EQ(phrases_a_page(pages_of(blocks, {30.0, 10.0})), (std::vector<std::size_t>{2, 3}));
}

std::vector<RowBlock> items_of_a_row(std::size_t count) {
    std::vector<RowBlock> blocks;
    for (std::size_t i = 0; i < count; ++i) blocks.push_back(block_of(1, i));
    return blocks;
}

TEST(Pages, TheLastItemIsNotAloneOnAPageIfPagesHoldThree) {
    using Counts = std::vector<std::size_t>;
    EXPECT_EQ(phrases_a_page(pages_of(items_of_a_row(8), {70.0, 10.0})), (Counts{6, 2}));
    EXPECT_EQ(phrases_a_page(pages_of(items_of_a_row(9), {70.0, 10.0})), (Counts{7, 2}));
    EXPECT_EQ(phrases_a_page(pages_of(items_of_a_row(4), {30.0, 10.0})), (Counts{2, 2}));
    EXPECT_EQ(phrases_a_page(pages_of(items_of_a_row(3), {20.0, 10.0})), (Counts{2, 1}));
    std::vector<RowBlock> tall = items_of_a_row(4);
    tall.back() = block_of(3, 3);
    EXPECT_EQ(phrases_a_page(pages_of(tall, {30.0, 10.0})), (Counts{3, 3})) << "not a page more";
}

TEST(Pages, ABlockLargerThanAPagePartsAndBeginsAPage) {
    const std::vector<RowBlock> blocks{block_of(1), block_of(5)};
    EXPECT_EQ(phrases_a_page(pages_of(blocks, {30.0, 10.0})), (std::vector<std::size_t>{1, 3, 2}));
}

TEST(Pages, RunningTextFillsWhatIsLeft) {
    std::vector<RowBlock> blocks{block_of(1), block_of(5)};
    blocks[1].is_running = true;
    EXPECT_EQ(phrases_a_page(pages_of(blocks, {30.0, 10.0})), (std::vector<std::size_t>{3, 3}));
}

TEST(Pages, APageTooLowStillHoldsARow) {
    EXPECT_EQ(phrases_a_page(pages_of(std::vector{block_of(2)}, {5.0, 10.0})),
              (std::vector<std::size_t>{1, 1}));
}

TEST(Pages, NothingIsOneEmptyPage) {
    EXPECT_EQ(phrases_a_page(pages_of({}, {30.0, 10.0})), (std::vector<std::size_t>{0}));
}

TEST(Pages, InsetAndGapTakeTheirRoom) {
    const std::vector<RowBlock> blocks{block_of(1, 0), block_of(1, 1)};
    const auto pages = pages_of(blocks, {35.0, 10.0, 2.0, 3.0});
    ASSERT_EQ(pages.size(), 1U);
    EXPECT_EQ(pages[0].items[1].top_px, 17.0);  // 2 + 10 + 2 and the gap
    EXPECT_EQ(pages[0].items[1].height_px, 14.0);
    EXPECT_EQ(pages[0].phrases[1].at.y, 19.0);
    EXPECT_EQ(pages_of(blocks, {30.0, 10.0, 2.0, 3.0}).size(), 2U);
}

TEST(Pages, AnItemOnThreePagesIsFoundOnAllThree) {
    const std::vector<RowBlock> blocks{block_of(1, 0), block_of(5, 1), block_of(2, 2)};
    const auto pages = pages_of(blocks, {20.0, 10.0});
    const PageRange range = pages_with(pages, 1);
    EXPECT_EQ(range.first, 1U);
    EXPECT_EQ(range.count, 3U);
}

TEST(Pages, TurnSlowlyThroughAllAndBeginAgain) {
    const auto pages = pages_of(std::vector{block_of(6)}, {20.0, 10.0});
    ASSERT_EQ(pages.size(), 3U);
    std::set<std::size_t> seen;
    std::size_t last = 0;
    int turns = 0;
    for (int second = 0; second < 12; ++second) {
        const std::size_t page = page_at(pages, {0, 3}, second * one_second_ns);
        turns += page != last;
        last = page;
        seen.insert(page);
    }
    EXPECT_EQ(seen.size(), 3U);
    EXPECT_GE(turns, 3);  // and from the first again
    EXPECT_LE(turns, 6);  // two seconds a page at least
}

TEST(Pages, OneWithMoreWordsStaysLonger) {
    const auto pages = pages_of(std::vector{block_of(3)}, {20.0, 10.0});
    EXPECT_GT(reading_time_ns(pages[0]), reading_time_ns(pages[1]));
}

}  // namespace
}  // namespace touchline
