// Tests lists of names as they are said: no two sound alike, and none is longer than that needs.
#include "app/documents/sticks/spoken_name.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unicode/unistr.h>

namespace touchline {
namespace {

using Names = std::vector<std::string>;

std::vector<Language> read_all() {
    std::vector<Language> languages;
    const auto codes = languages_in(TOUCHLINE_CATALOGUES).value();
    for (const std::string& code : codes)
        languages.push_back(Language::load(TOUCHLINE_CATALOGUES, code).value());
    return languages;
}

const std::vector<Language>& all_languages() {
    static const std::vector<Language> languages = read_all();
    return languages;
}

const Language& language_of(const std::string& code) {
    return *std::ranges::find(all_languages(), code, &Language::code);
}

Names said_in(const Language& language, const Names& names, const std::vector<NameForm>& forms) {
    Names said;
    for (std::size_t i = 0; i < names.size(); ++i)
        said.push_back(spoken_name(names[i], language, forms[i]));
    return said;
}

Names said_list(const Names& names, const Language& language = language_of("en")) {
    return said_in(language, names, spoken_forms(names, all_languages()));
}

TEST(SpokenForms, AreAsPlainAsTellsThemApart) {
    EXPECT_EQ(said_list({"IMG_4512.jpg", "IMG_4513.jpg"}), (Names{"photo 45 12", "photo 45 13"}));
    EXPECT_EQ(said_list({"IMG_4512.jpg", "boat.png", "IMG_4512.heic"}),
              (Names{"photo 45 12, J P G", "boat", "photo 45 12, H E I C"}));
    EXPECT_EQ(said_list({"DSC04512.JPG", "IMG_4512.JPG"}),
              (Names{"D S C 045 12, J P G", "I M G 45 12, J P G"}));
    EXPECT_EQ(said_list({"IMG_20240511_142233.jpg", "IMG_20240511_142234.jpg"}),
              (Names{"photo of 11th May 2024, 14:22 and 33 seconds",
                     "photo of 11th May 2024, 14:22 and 34 seconds"}));
    EXPECT_EQ(said_list({"IMG_20240511_142233.jpg", "IMG_20240511_142234.jpg"}, language_of("de")),
              (Names{"Foto vom elften Mai 2024, 14:22 und 33 Sekunden",
                     "Foto vom elften Mai 2024, 14:22 und 34 Sekunden"}));
}

TEST(SpokenForms, NumberWhatHasTheSameWords) {
    EXPECT_EQ(said_list({"boat.png", "Boat.PNG", "boat_.png"}),
              (Names{"boat, P N G, number 1", "Boat, P N G, number 2", "boat, P N G, number 3"}));
    EXPECT_EQ(said_list({"", "\xff"}),
              (Names{"a file without a name, number 1", "a file without a name, number 2"}));
    const std::string start(90, 'w');
    EXPECT_EQ(said_list({start + "1.png", start + "2.png"}),
              (Names{start.substr(0, 80) + ", P N G, number 1",
                     start.substr(0, 80) + ", P N G, number 2"}));
    EXPECT_EQ(said_list({}), Names{});
}

/// Returns true if two sound the same; the tests' names have accents only on "a" and "e".
bool are_two_alike(const Names& said) {
    Names heard;
    for (const std::string& text : said) {
        auto folded = icu::UnicodeString::fromUTF8(text).foldCase();
        folded.findAndReplace(u"a\u0308", u"\u00e4").findAndReplace(u"e\u0301", u"\u00e9");
        heard.emplace_back();
        folded.toUTF8String(heard.back());
    }
    std::ranges::sort(heard);
    return std::ranges::adjacent_find(heard) != heard.end();
}

/// German says "Foto" for a camera's picture.
TEST(SpokenForms, TellApartWhatSoundsAlikeInOneLanguage) {
    const Names names{"IMG_4512.jpg", "Foto 4512.jpg", "photo 4512.jpg", "boat.png"};
    ASSERT_GE(all_languages().size(), 5U);
    for (const Language& language : all_languages())
        EXPECT_FALSE(are_two_alike(said_list(names, language))) << language.code();
    EXPECT_EQ(said_list(names, language_of("de")),
              (Names{"I M G 45 12, J P G", "Foto 45 12, J P G", "photo 45 12, J P G", "boat"}));
    const auto forms = spoken_forms(names, std::vector{language_of("de")});
    EXPECT_EQ(forms[2], NameForm{}) << "German says photo of no camera";
}

TEST(SpokenForms, CapitalsAndTheWayOfAnAccentAreNotHeard) {
    EXPECT_EQ(said_list({"\u00c4pfel.jpg", "\u00e4pfel.jpg"}),
              (Names{"\u00c4pfel, J P G, number 1", "\u00e4pfel, J P G, number 2"}));
    EXPECT_EQ(said_list({"caf\u00e9.jpg", "cafe\u0301.jpg", "cafe.jpg"}),
              (Names{"caf\u00e9, J P G, number 1", "cafe\u0301, J P G, number 2", "cafe"}));
    EXPECT_EQ(said_list({"CAFE\u0301.png", "caf\u00e9.jpg"}),
              (Names{"CAFE\u0301, P N G", "caf\u00e9, J P G"}));
    EXPECT_EQ(said_list({"\u0416.jpg", "\u0436.jpg"}),
              (Names{"\u0416, J P G, number 1", "\u0436, J P G, number 2"}));
}

/// The date sounds like the first name in German and like the last one in French.
TEST(SpokenForms, NumberAllThatAreJoined) {
    const Names names{"vom f\u00fcnften April 2023", "2023-04-05", "5 avril 2023"};
    const auto forms = spoken_forms(names, all_languages());
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(forms[static_cast<std::size_t>(i)], (NameForm{NameDetail::whole, i + 1})) << i;
    for (const Language& language : all_languages())
        EXPECT_FALSE(are_two_alike(said_in(language, names, forms))) << language.code();
}

/// Names of a few letters and signs often sound alike.
RC_GTEST_PROP(SpokenForms, NoTwoOfAListSoundAlike, ()) {
    const auto beginning =
        rc::gen::elementOf(Names{"", "IMG_4512", "img_4512", "Foto 4512", "foto 45", "photo 4512"});
    const auto part = rc::gen::elementOf(
        Names{"IMG",  "DSC",  "_",      "0",      "7",       "12",     "a",      "A",
              "2024", "0511", "-",      " ",      ".jpg",    ".JPG",   ".png",   "THE ",
              "CAT",  "cat",  "\u00c4", "\u00e4", "a\u0308", "\u00e9", "e\u0301"});
    const auto name = rc::gen::apply(
        [](std::string text, const Names& parts) {
            for (const std::string& one : parts) text += one;
            return text;
        },
        beginning, rc::gen::resize(4, rc::gen::container<Names>(part)));
    const auto names = *rc::gen::container<Names>(name);
    const auto forms = spoken_forms(names, all_languages());
    for (const Language& language : all_languages())
        RC_ASSERT(!are_two_alike(said_in(language, names, forms)));
}

TEST(SpokenForms, OfTenThousandFilesAreThereAtOnce) {
    Names names;
    for (int i = 0; i < 10000; ++i) names.push_back(fmt::format("IMG_{:05}.jpg", i));
    const auto begin = std::chrono::steady_clock::now();
    const auto forms = spoken_forms(names, all_languages());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(forms.size(), names.size());
    RecordProperty("seconds", std::to_string(took.count()));
    EXPECT_LT(took.count(),
              5.0);  // a tenth of a second without sanitizers; n squared takes minutes
}

}  // namespace
}  // namespace touchline
