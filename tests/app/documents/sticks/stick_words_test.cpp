#include "app/documents/sticks/spoken_name.h"

#include <set>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(StickWords, SayWhatIsNotInTheList) {
    const Language english;
    EXPECT_EQ(words_of(StickRest{}, 17, english), "");
    EXPECT_EQ(words_of(StickRest{2345, false, false, false}, 10000, english),
              "The list has 10000 files of 12345. For others, bring fewer at a time.");
    EXPECT_EQ(words_of(StickRest{0, true, true, true}, 17, english),
              "Folders within eight others were left out. Put their files nearer to the top. Some "
              "folders could not be read. Copy their files to another USB stick. There was no time "
              "for all folders. Put other files outside of all folders.");
    EXPECT_EQ(words_of(StickRest{0, false, false, false, 1}, 17, english),
              "1 office file cannot be felt. Bring it as a PDF.");
    EXPECT_TRUE(nothing_words(StickRest{0, false, false, false, 2}, english)
                    .ends_with(" 2 office files cannot be felt. Bring them as PDFs."));
    EXPECT_EQ(nothing_words(StickRest{}, english),
              "There is no picture or PDF on the USB stick. Put some on it and bring it again.");
}

/// Each reason has its own words in every language.
TEST(StickWords, AreOfTheVisitorsLanguage) {
    std::set<std::string> said;
    std::size_t count = 0;
    const auto codes = languages_in(TOUCHLINE_CATALOGUES).value();
    for (const std::string& code : codes) {
        const auto language = Language::load(TOUCHLINE_CATALOGUES, code);
        ASSERT_TRUE(language.has_value());
        for (const StickRest& rest :
             {StickRest{1, false, false, false}, StickRest{0, true, false, false},
              StickRest{0, false, true, false}, StickRest{0, false, false, true},
              StickRest{0, false, false, false, 2}}) {
            said.insert(words_of(rest, 5, *language));
            said.insert(nothing_words(rest, *language));
            count += 2;
        }
    }
    EXPECT_EQ(said.size(), count);
}

}  // namespace
}  // namespace touchline
