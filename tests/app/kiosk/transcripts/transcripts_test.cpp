// Tests that whole visits say what people have reviewed, in every language.
#include "tests/app/kiosk/transcripts/staged_kiosk.h"
#include "tests/app/kiosk/transcripts/visit_plans.h"
#include "tests/machines/sim/kiosk/house.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

const std::string kept = TOUCHLINE_SOURCE_DIR "/tests/data/transcripts/";
const std::string catalogues = TOUCHLINE_SOURCE_DIR "/audio-cues/words/catalogue/";

constexpr const char* how_to_renew =
    "What is said has changed. Read the difference aloud, and if it is good:\n"
    "  build/release/tests/app/kiosk/transcripts/transcripts tests/data/transcripts";

/// Returns what the page of the language holds of the visit; empty if it does not know it.
std::string kept_text(const VisitPlan& plan, const std::string& language) {
    std::ifstream stream(kept + language + ".txt", std::ios::binary);
    const std::string page = "\n" + std::string(std::istreambuf_iterator<char>(stream), {});
    const std::string heading = "\n" + heading_of(plan);
    const std::size_t at = page.find(heading);
    if (at == std::string::npos) return {};
    const std::size_t begin = at + heading.size();
    const std::size_t next = page.find("\n\n# ", begin);
    return page.substr(begin, next == std::string::npos ? next : next + 1 - begin);
}

/// Titles of the gallery that are said in English to a visitor of another language.
std::vector<std::string> titles_in_english(const Transcript& heard, std::size_t language) {
    const auto& titles = gallery_without_workers().titles;
    std::vector<std::string> faults;
    for (const TranscriptLine& line : heard) {
        for (const std::string& sentence : sentences_of(line.text)) {
            const std::string first = sentence.substr(0, sentence.find_first_of(",."));
            const bool is_english = std::ranges::any_of(
                titles.front(), [&](const GalleryTitle& each) { return each.title == first; });
            const bool is_own = std::ranges::any_of(
                titles[language], [&](const GalleryTitle& each) { return each.title == first; });
            if (is_english && !is_own) faults.push_back(sentence);
        }
    }
    return faults;
}

class Transcripts : public testing::TestWithParam<VisitPlan> {};

TEST_P(Transcripts, AreThoseThatWereRead) {
    const std::vector<Language> languages = all_languages();
    for (std::size_t i = 0; i < languages.size(); ++i) {
        const Language& language = languages[i];
        SCOPED_TRACE(language.code());
        const Transcript heard = act_out(GetParam(), language.code());
        EXPECT_EQ(text_of(heard, language.code()), kept_text(GetParam(), language.code()))
            << how_to_renew;
        EXPECT_EQ(said_twice(heard), std::vector<std::string>{});
        if (language.code() == "en") continue;
        EXPECT_EQ(
            left_in_english(heard, language.code(), read_po(catalogues + language.code() + ".po")),
            std::vector<std::string>{});
        EXPECT_EQ(titles_in_english(heard, i), std::vector<std::string>{});
    }
}

INSTANTIATE_TEST_SUITE_P(OfVisits, Transcripts, testing::ValuesIn(visit_plans()),
                         [](const auto& plan) {
                             std::string name(plan.param.name);
                             std::erase(name, '-');
                             return name;
                         });

/// There Back is no item of its own, and Help comes one press sooner.
TEST(StagedKiosk, FindsTheKeyHelpWhereTheLastItemIsBack) {
    StagedKiosk kiosk({"en", SwitchUse::move_and_select});
    for (int i = 0; i < 2; ++i) {
        kiosk.press(KeyRole::select);
        kiosk.listen();
    }
    kiosk.choose(VisitItem::gallery);
    ASSERT_EQ(kiosk.screen().items.back().name, "Back");
    kiosk.choose_key(KeyRole::help);
    EXPECT_EQ(kiosk.screen().title, "Help");
}

TranscriptLine said(double at_s, double end_s, const char* text, bool is_asked) {
    return {at_s, end_s, "de", text, false, is_asked};
}

TEST(TranscriptRules, ASentenceSaidAgainSoonIsFoundUnlessAKeyAskedForIt) {
    const auto first = said(1.0, 3.0, "Eins. Zwei.", true);
    EXPECT_EQ(said_twice({first, said(12.0, 13.0, "Drei. Zwei.", false)}),
              std::vector<std::string>{"00:12.0 Zwei."});
    EXPECT_TRUE(said_twice({first, said(13.5, 14.0, "Zwei.", false)}).empty());
    EXPECT_TRUE(said_twice({first, said(4.0, 5.0, "Zwei.", true)}).empty());
    EXPECT_EQ(said_twice({said(1.0, 3.0, "Eins. Eins", true)}).size(), 1U);
}

TEST(TranscriptRules, EnglishIsFoundInASentenceAnItemAndAFilledText) {
    PoFile catalogue;
    catalogue[{"visit", "Goodbye"}].said = {"Auf Wiedersehen"};
    catalogue[{"visit", "Zoom"}].said = {"Zoom"};
    catalogue[{"visit", "{0} of {1}"}].said = {"{0} von {1}"};
    catalogue[{"visit", "On: {0}."}].said = {"Auf: {0}."};
    const auto left = [&](const char* text) {
        return left_in_english({said(0.0, 1.0, text, false)}, "de", catalogue).size();
    };
    EXPECT_EQ(left("Ja. Goodbye."), 1U);
    EXPECT_EQ(left("Wand, 2 of 3"), 1U);
    EXPECT_EQ(left("On: Nase. Ja."), 1U);
    EXPECT_EQ(left("Auf Wiedersehen. Zoom, 2 von 3. Auf: Nase."), 0U);
}

}  // namespace
}  // namespace touchline
