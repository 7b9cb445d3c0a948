// Tests workers that lie, bombs and noise: the kiosk gets a page or one line, keeps its memory, and
// keeps nothing of the worker.
#include "app/documents/decode/opening.h"
#include "tests/app/documents/decode/encoders.h"
#include "tests/app/documents/decode/files_of_formats.h"
#include "tests/app/documents/decode/liar_in_place.h"
#include "tests/config/mutated.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using encoders::Bytes;

Result<Page> told(const std::string& lie) {
    return open_page(encoders::bytes_of("liar " + lie));
}

TEST(Liar, IsBelievedOnlyWhenItIsHonest) {
    const LiarInPlace liar(TOUCHLINE_LIARS);
    const auto page = told("honest");
    ASSERT_TRUE(page.has_value()) << page.error().line;
    EXPECT_EQ(page->told.title, "honest");
}

class Lies : public testing::TestWithParam<const char*> {};

TEST_P(Lies, EndInOneSentenceAndLeaveNothing) {
    const LiarInPlace liar(TOUCHLINE_LIARS);
    (void)told("honest");
    const int descriptors = open_descriptors();
    const long before_kB = resident_kB();
    const auto page = told(GetParam());
    ASSERT_FALSE(page.has_value());
    EXPECT_TRUE(is_one_sentence(page.error().line)) << page.error().line;
    EXPECT_EQ(open_descriptors(), descriptors);
    EXPECT_FALSE(has_a_child());
    EXPECT_LT(resident_kB() - before_kB, 1024);
}

INSTANTIATE_TEST_SUITE_P(All, Lies,
                         testing::Values("wrong magic", "wrong size", "huge header", "short",
                                         "long", "second header", "header alone", "half a header",
                                         "noise", "figure outside", "hole", "nothing", "status",
                                         "abort", "crash", "fork", "connect", "fill", "eat", "spin",
                                         "sleep"));

/// The liar's error output is dropped, however much it writes.
TEST(Liar, ShoutsUnheard) {
    const LiarInPlace liar(TOUCHLINE_LIARS);
    EXPECT_TRUE(told("shout").has_value());
}

struct Bomb {
    std::string name;
    Bytes bytes;
};

/// Reports the worst one for the table of reliability.
TEST(Bombs, AreRefusedWithoutHarm) {
    long worst_kB = 0;
    double worst_ms = 0.0;
    for (const auto& [name, bytes] : bombs()) {
        SCOPED_TRACE(name);
        (void)open_page(encoders::bytes_of("warm"));
        const long before_kB = resident_kB();
        const auto start = std::chrono::steady_clock::now();
        const auto page = open_page(bytes);
        const std::chrono::duration<double, std::milli> took =
            std::chrono::steady_clock::now() - start;
        ASSERT_FALSE(page.has_value());
        EXPECT_TRUE(is_one_sentence(page.error().line)) << page.error().line;
        // The true reason tells its owner what to do.
        const bool is_large = name.find("megapixels") != std::string::npos;
        EXPECT_TRUE(!is_large || page.error().line.find("megapixels") != std::string::npos)
            << page.error().line;
        const long grown_kB = resident_kB() - before_kB;
        EXPECT_LT(grown_kB, 1024);
        worst_kB = std::max(worst_kB, grown_kB);
        worst_ms = std::max(worst_ms, took.count());
        std::printf("%s: %.1f ms: %s\n", name.c_str(), took.count(), page.error().line.c_str());
    }
    RecordProperty("tried", static_cast<int>(bombs().size()));
    RecordProperty("worst_kB", static_cast<int>(worst_kB));
    RecordProperty("worst_ms", static_cast<int>(std::ceil(worst_ms)));
}

/// Returns a few for each day's test run; the environment sets more for the hazard table.
int count_of(const char* name, int a_day) {
    const char* const wished = std::getenv(name);
    return wished != nullptr ? std::atoi(wished) : a_day;
}

class Mutations : public testing::TestWithParam<std::size_t> {};

TEST_P(Mutations, AreAPageOrOneSentence) {
    const int count = count_of("TOUCHLINE_MUTATIONS", 10);
    const auto [name, bytes] = files_of_formats().at(GetParam());
    std::mt19937 random(2026);
    int opened = 0;
    for (int i = 0; i < count; ++i) {
        const auto page = open_page(mutated(bytes, random));
        opened += page ? 1 : 0;
        ASSERT_TRUE(page.has_value() || is_one_sentence(page.error().line)) << name;
    }
    std::printf("%s: %d of %d opened\n", name.c_str(), opened, count);
}

constexpr std::size_t formats = 11;

INSTANTIATE_TEST_SUITE_P(All, Mutations, testing::Range(std::size_t{0}, formats));

TEST(MutationsOf, EveryFormatAreTried) {
    EXPECT_EQ(files_of_formats().size(), formats);
}

/// Opening a file any number of times leaves no descriptor, no zombie and no memory.
TEST(Opening, ManyDocumentsLeaveNothing) {
    const int count = count_of("TOUCHLINE_DOCUMENTS", 200);
    const Bytes file = encoders::png(encoders::test_picture());
    for (int i = 0; i < 20; ++i) (void)open_page(file);
    const int descriptors = open_descriptors();
    const long before_kB = resident_kB();
    for (int i = 0; i < count; ++i) ASSERT_TRUE(open_page(file).has_value()) << i;
    EXPECT_EQ(open_descriptors(), descriptors);
    EXPECT_FALSE(has_a_child());
    EXPECT_LT(resident_kB() - before_kB, 1024);
}

}  // namespace
}  // namespace touchline
