// Tests a reader of words that lies, and damaged input to the honest one: the kiosk gets words or
// one line.
#include "app/documents/decode/opening.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/process/places.h"
#include "app/isolation/sandbox/worker.h"
#include "tests/app/documents/decode/encoders.h"
#include "tests/app/documents/decode/files_of_formats.h"
#include "tests/app/documents/decode/liar_in_place.h"
#include "tests/config/mutated.h"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Puts the lie in the pixels.
Result<FoundWords> read_lie(const std::string& lie) {
    Picture picture{20, 1, std::vector<std::uint8_t>(60), 1.0};
    const std::string text = "liar " + lie;
    std::copy(text.begin(), text.end(), picture.bgr.begin());
    return read_words(picture);
}

TEST(ReadingLiar, IsBelievedOnlyWhenItIsHonest) {
    const LiarInPlace liar(TOUCHLINE_LIARS);
    const auto words = read_lie("honest");
    ASSERT_TRUE(words.has_value()) << words.error().line;
    EXPECT_EQ(words->labels.at(0).text, "honest");
}

class ReadingLies : public testing::TestWithParam<const char*> {};

TEST_P(ReadingLies, EndInOneSentenceAndLeaveNothing) {
    const LiarInPlace liar(TOUCHLINE_LIARS);
    (void)read_lie("honest");
    const int descriptors = open_descriptors();
    const long before_kB = resident_kB();
    const auto words = read_lie(GetParam());
    ASSERT_FALSE(words.has_value());
    EXPECT_TRUE(is_one_sentence(words.error().line)) << words.error().line;
    EXPECT_EQ(open_descriptors(), descriptors);
    EXPECT_FALSE(has_a_child());
    EXPECT_LT(resident_kB() - before_kB, 1024);
}

// A worker that spins or sleeps ends as every worker does (liar_test.cpp), only later.
INSTANTIATE_TEST_SUITE_P(All, ReadingLies,
                         testing::Values("a page", "elsewhere", "wrong magic", "wrong size",
                                         "huge header", "short", "long", "second header",
                                         "header alone", "half a header", "noise", "hole",
                                         "nothing", "status", "abort", "crash", "fork", "connect",
                                         "fill", "eat"));

Result<Mapping, WorkerEnd> run_reader(const encoders::Bytes& input,
                                      const std::vector<std::string>& words) {
    return call_worker({companion("touchline-read"), words, WorkerKind::ocr},
                       sealed_copy(input).value());
}

/// Our input crosses whole between two of our programs. The worker need not fear a captured kiosk,
/// but one of our errors should have no worse effect.
TEST(Reader, DamagedInputIsWordsOrOneSentence) {
    const Picture picture = encoders::test_picture(60, 40);
    const auto whole = answer_of(picture).value();
    std::mt19937 random(2026);
    for (int i = 0; i < 12; ++i) {
        const auto answer = run_reader(mutated(whole, random), {"eng"});
        ASSERT_TRUE(answer.has_value());
        const auto words = words_of(answer->bytes(), picture.width, picture.height);
        EXPECT_TRUE(words.has_value() || is_one_sentence(words.error().line));
    }
}

TEST(Reader, KnowsNoOtherArguments) {
    const auto input = answer_of(encoders::test_picture()).value();
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{}, {"osd"}, {"eng", "eng"}, {"../eng"}, {"3", "1", "150"}})
        EXPECT_EQ(run_reader(input, words).error(), WorkerEnd::crashed);
    EXPECT_TRUE(run_reader(input, {"deu", "eng"}).has_value());
}

}  // namespace
}  // namespace touchline
