#include "audio-cues/words/language.h"

#include "audio-cues/words/words_of.h"

#include <algorithm>
#include <array>
#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include <gtest/gtest.h>

namespace touchline {
namespace {

Language loaded(const std::string& code) {
    const auto language = Language::load(TOUCHLINE_CATALOGUES, code);
    EXPECT_TRUE(language) << (language ? "" : language.error().line);
    return language.value_or(Language());
}

TEST(Language, ThreeAtOnceSayTheirOwnWordsUnderAnyLocaleOfTheProcess) {
    for (const char* locale : {"C", "C.UTF-8"}) {
        ASSERT_NE(std::setlocale(LC_ALL, locale), nullptr);
        const Language german = loaded("de");
        const Language french = loaded("fr");
        const Language spanish = loaded("es");
        EXPECT_EQ(german.text("mode", "groove"), "Rille");
        EXPECT_EQ(french.text("mode", "groove"), "rainure");
        EXPECT_EQ(spanish.text("mode", "groove"), "surco");
        EXPECT_EQ(Language().text("mode", "groove"), "groove");
        EXPECT_STREQ(std::setlocale(LC_ALL, nullptr), locale) << "left as it was";
    }
}

TEST(Language, TheContextTellsTwoWordsApart) {
    const Language german = loaded("de");
    EXPECT_EQ(german.text("stiffness", "medium"), "mittel");
    EXPECT_EQ(german.text("visit", "medium"), "mittelschwer");
}

TEST(Language, WhatIsMissingIsSaidInEnglish) {
    EXPECT_EQ(loaded("de").text("mode", "no such {0}", {"thing"}), "no such thing");
    EXPECT_EQ(loaded("de").text("no such context", "wall"), "wall");
}

TEST(Language, PlacesAreFilledAndOthersStay) {
    EXPECT_EQ(Language().text("", "{1} and {0}, {2} {x} {", {"a", "b"}), "b and a, {2} {x} {");
    EXPECT_EQ(loaded("fr").text("screen", "{0} of {1}", {"2", "5"}), "2 sur 5");
    EXPECT_EQ(Language().text("", "{0}", {"{1}", "b"}), "{1}")
        << "what is filled in is not read again";
}

TEST(Language, CountsByItsOwnRule) {
    const auto outlines = [](const Language& language, int count) {
        return language.counted("count", "{0} outline", "{0} outlines", count);
    };
    EXPECT_EQ(outlines(Language(), 0), "0 outlines");
    EXPECT_EQ(outlines(Language(), 1), "1 outline");
    EXPECT_EQ(outlines(loaded("de"), 0), "0 Umrisse");
    EXPECT_EQ(outlines(loaded("de"), 1), "ein Umriss");
    EXPECT_EQ(outlines(loaded("fr"), 0), "0 contour");
    EXPECT_EQ(outlines(loaded("fr"), 1), "un contour");
    EXPECT_EQ(outlines(loaded("fr"), 2), "2 contours");
    EXPECT_EQ(outlines(loaded("es"), 7), "Contornos: 7");
    EXPECT_EQ(outlines(loaded("it"), 1), "un contorno");
    EXPECT_EQ(outlines(loaded("it"), 21), "21 contorni");
}

/// French decimals below 2 take the singular, "1,5 newton"; English takes the plural.
TEST(Language, MeasuresTakeTheFormOfTheirValue) {
    const auto newtons = [](const Language& language, double value) {
        return language.measured("unit", "{0} newton", "{0} newtons", value);
    };
    const auto expect = [&](const std::string& code, const std::vector<std::string>& said) {
        const std::array values{0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 500000.0};
        ASSERT_EQ(said.size(), values.size());
        for (std::size_t i = 0; i < said.size(); ++i)
            EXPECT_EQ(newtons(loaded(code), values[i]), said[i]) << code;
    };
    expect("en", {"0 newtons", "0.5 newtons", "1 newton", "1.5 newtons", "2 newtons", "2.5 newtons",
                  "500000 newtons"});
    expect("de", {"0 Newton", "0,5 Newton", "ein Newton", "1,5 Newton", "2 Newton", "2,5 Newton",
                  "500000 Newton"});
    expect("fr", {"0 newton", "0,5 newton", "un newton", "1,5 newton", "2 newtons", "2,5 newtons",
                  "500000 newtons"});
    expect("es", {"0 newtons", "0,5 newtons", "un newton", "1,5 newtons", "2 newtons",
                  "2,5 newtons", "500000 newtons"});
    expect("it", {"0 newton", "0,5 newton", "un newton", "1,5 newton", "2 newton", "2,5 newton",
                  "500000 newton"});
    EXPECT_EQ(newtons(loaded("fr"), -1.5), "-1,5 newton");
    EXPECT_EQ(newtons(loaded("en"), 0.9999999), "1 newton") << "of the digits that are said";
    EXPECT_EQ(newtons(loaded("de"), 1.0000001), "ein Newton");
    EXPECT_EQ(newtons(loaded("fr"), 1.9999999), "2 newtons");
    EXPECT_EQ(newtons(loaded("fr"), 1.99999), "1,99999 newton");
}

TEST(Language, NumbersHaveItsDecimalSign) {
    EXPECT_EQ(Language().number(1.25, 1), "1.2");
    EXPECT_EQ(loaded("de").number(1.26, 1), "1,3");
    EXPECT_EQ(loaded("fr").number(-3.0, 0), "-3");
}

TEST(Language, PlacesAndSoundsAreSaidInEveryLanguage) {
    EXPECT_EQ(words_of(Place::lower_right, loaded("es")), "abajo a la derecha");
    EXPECT_EQ(words_of(Place::upper_left, Language()), "upper left");
    EXPECT_EQ(words_of(Cue::touch, loaded("fr")), "toucher");
}

TEST(Language, AFileThatIsMissingOrNoneIsOneClearLine) {
    for (const char* code : {"xx", "../de", "", "de.mo"}) {
        const auto language = Language::load(TOUCHLINE_CATALOGUES, code);
        ASSERT_FALSE(language);
        EXPECT_EQ(language.error().line.find('\n'), std::string::npos);
    }
}

TEST(Language, AFileMoreIsALanguageMore) {
    std::string folder = testing::TempDir() + "languagesXXXXXX";
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    std::filesystem::copy_file(TOUCHLINE_CATALOGUES "/de.mo", folder + "/xy.mo");
    std::ofstream(folder + "/no.mo") << "not a catalogue";
    EXPECT_EQ(languages_in(folder).value(), (std::vector<std::string>{"en", "no", "xy"}));
    const auto language = Language::load(folder, "xy");
    ASSERT_TRUE(language) << language.error().line;
    EXPECT_EQ(language->name(), "Deutsch");
    EXPECT_EQ(language->code(), "xy");
    EXPECT_FALSE(Language::load(folder, "no"));
    std::filesystem::remove_all(folder);
    EXPECT_FALSE(languages_in(folder));
}

TEST(Language, EveryShippedOneNamesItselfAndItsVoice) {
    const auto codes = languages_in(TOUCHLINE_CATALOGUES);
    ASSERT_TRUE(codes);
    for (const char* code : {"en", "de", "es", "fr", "it"})
        EXPECT_EQ(std::ranges::count(*codes, code), 1) << code;
    std::set<std::string> names;
    for (const std::string& code : *codes)
        EXPECT_TRUE(names.insert(loaded(code).name()).second) << code;
    EXPECT_EQ(loaded("de").name(), "Deutsch");
    EXPECT_EQ(loaded("es").name(), "Español");
    EXPECT_EQ(loaded("fr").voice(), "fr-fr");
    EXPECT_EQ(loaded("en").voice(), "en");
    EXPECT_EQ(loaded("en").pace(), 1.0);
    EXPECT_EQ(loaded("fr").pace(), 1.05);
}

}  // namespace
}  // namespace touchline
