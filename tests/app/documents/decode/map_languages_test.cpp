// Tests that a map's words come in the requested language.
#include "app/documents/decode/map_svg.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

std::string svg_with_line(const std::string& content, const std::string& attributes = "") {
    return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 116 84' " + attributes + ">" +
           content + "<path d='M1 1L2 2'/></svg>";
}

TactileMap parsed(const std::string& content, const std::string& language) {
    return parse_map_svg(svg_with_line(content), {language}).value();
}

constexpr auto fish = R"(
    <title>A fish</title><title xml:lang="de">Ein  Fisch</title><title xml:lang="fr">Un poisson</title>
    <desc>It swims.</desc><desc xml:lang="de">Er schwimmt.</desc>
    <path id="body" d="M1 1L9 9"><title>Body</title><title xml:lang="de">Körper</title></path>
    <path id="fin" data-label="Fin" d="M1 1L9 9"><title xml:lang="fr">Nageoire</title></path>
    <text x="3" y="4">Head <title xml:lang="de">Kopf</title><desc>No word of it</desc>end</text>)";

TEST(MapLanguages, EachWordIsInTheLanguageOrInNone) {
    const TactileMap german = parsed(fish, "de");
    EXPECT_EQ(german.title, "Ein Fisch");
    EXPECT_EQ(german.description, "Er schwimmt.");
    EXPECT_EQ(german.outlines[0].label, "Körper");
    EXPECT_EQ(german.outlines[1].label, "Fin");
    EXPECT_EQ(german.labels.at(0).text, "Kopf");
    const TactileMap french = parsed(fish, "fr");
    EXPECT_EQ(french.title, "Un poisson");
    EXPECT_EQ(french.description, "It swims.");
    EXPECT_EQ(french.outlines[0].label, "Body");
    EXPECT_EQ(french.outlines[1].label, "Nageoire");
    EXPECT_EQ(french.labels.at(0).text, "Head end");
}

TEST(MapLanguages, EnglishAndWhatNobodyWroteInAreTheWordsWithoutALanguage) {
    for (const char* language :
         {"en", "", "EN", "en-GB", "es", "d", "deu", "-", "x-unknown", "\xff"}) {
        const TactileMap map = parsed(fish, language);
        EXPECT_EQ(map.title, "A fish") << language;
        EXPECT_EQ(map.outlines[0].label, "Body") << language;
        EXPECT_EQ(map.outlines[1].label, "Fin") << language;
    }
    EXPECT_EQ(parse_map_svg(svg_with_line(fish)).value().title, "A fish");
}

TEST(MapLanguages, ARegionIsServedByItsLanguageAndTheVeryTagComesFirst) {
    EXPECT_EQ(parsed(fish, "de-AT").title, "Ein Fisch");
    EXPECT_EQ(parsed(fish, "DE").title, "Ein Fisch");
    constexpr auto two =
        "<title xml:lang='pt-PT'>Comboio</title><title xml:lang='pt-br'>Trem</title>";
    EXPECT_EQ(parsed(two, "pt-BR").title, "Trem");
    EXPECT_EQ(parsed(two, "pt").title, "Comboio");
    EXPECT_EQ(parsed("<title xml:lang='en'>One</title><title>Any</title>", "en").title, "One");
}

TEST(MapLanguages, EmptyDoubledAndMissingWords) {
    EXPECT_EQ(parsed("<title>A</title><title xml:lang='de'> </title>", "de").title, "A");
    EXPECT_EQ(parsed("<title/><title>B</title>", "de").title, "B");
    EXPECT_EQ(parsed("<title xml:lang='de'>1</title><title xml:lang='de'>2</title>", "de").title,
              "1");
    EXPECT_EQ(parsed("<title>1</title><title>2</title>", "de").title, "1");
    EXPECT_EQ(parsed("<title xml:lang=''>A</title><title xml:lang='fr'>F</title>", "de").title,
              "A");
    EXPECT_EQ(parsed("<title xml:lang='fr'>F</title><title xml:lang='es'>E</title>", "de").title,
              "F");
    EXPECT_EQ(parsed("<title>A</title><title lang='de'>L</title>", "de").title, "L");
    EXPECT_EQ(parsed("<title>A</title><title lang='de' xml:lang='fr'>F</title>", "de").title, "A");
    EXPECT_EQ(parsed("", "de").title, "");
    EXPECT_EQ(words_of_svg(svg_with_line("<title xml:lang='de'>D</title><title>E</title>")).title,
              "E");
    EXPECT_EQ(words_of_svg(svg_with_line("<desc xml:lang='de'>D</desc>")).description, "D");
    EXPECT_EQ(
        words_of_svg(svg_with_line("<title xml:lang='de'>D</title><title>E</title>"), {"de"}).title,
        "D");
}

/// A visitor who asks for English gets it on a machine that speaks German.
TEST(MapLanguages, TheProcessLocaleChangesNothing) {
    for (const char* name : {"LANG", "LC_ALL", "LANGUAGE"})
        ::setenv(name, "de_DE.UTF-8", 1);  // NOLINT(concurrency-mt-unsafe): one thread
    const std::string title = parse_map_svg(svg_with_line(fish)).value().title;
    for (const char* name : {"LANG", "LC_ALL", "LANGUAGE"})
        ::unsetenv(name);  // NOLINT(concurrency-mt-unsafe): one thread
    EXPECT_EQ(title, "A fish");
}

TEST(MapLanguages, AMapIsWrittenInTheOneItWasReadIn) {
    const TactileMap german = parsed(fish, "de");
    const TactileMap again = parse_map_svg(format_map_svg(german), {"fr"}).value();
    EXPECT_EQ(again.title, german.title);
    EXPECT_EQ(again.description, german.description);
    EXPECT_EQ(again.outlines[0].label, german.outlines[0].label);
    EXPECT_EQ(again.labels[0].text, german.labels[0].text);
    EXPECT_EQ(format_map_svg(german).find("poisson"), std::string::npos);
}

/// The first of the best kind is taken; the result is empty only if there is nothing.
RC_GTEST_PROP(MapLanguages, TheFirstOfTheBestKindIsTaken, ()) {
    const std::vector<std::string> tags{"", "de", "de-AT", "DE-at", "fr", "en", "es-MX"};
    const std::string wanted = *rc::gen::elementOf(tags);
    const auto has = *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(tags));
    const auto lower = [](std::string text) {
        std::transform(text.begin(), text.end(), text.begin(),
                       [](char c) { return static_cast<char>(std::tolower(c)); });
        return text;
    };
    const std::string asked = wanted.empty() ? "en" : lower(wanted);
    std::string content;
    for (std::size_t i = 0; i < has.size(); ++i) {
        content += "<title xml:lang='" + has[i] + "'>" + std::to_string(i) + "</title>";
    }
    const auto first = [&](auto&& serves) { return std::find_if(has.begin(), has.end(), serves); };
    auto expected = first([&](const auto& tag) { return lower(tag) == asked; });
    if (expected == has.end()) {
        expected =
            first([&](const auto& tag) { return lower(tag).substr(0, 2) == asked.substr(0, 2); });
    }
    if (expected == has.end()) expected = first([](const auto& tag) { return tag.empty(); });
    if (expected == has.end()) expected = has.begin();
    const std::string title = parsed(content, wanted).title;
    RC_ASSERT(title == (has.empty() ? "" : std::to_string(expected - has.begin())));
}

TEST(MapDifficulty, IsADigitOfTheRootOrNone) {
    EXPECT_EQ(difficulty_of_map_svg(svg_with_line("")).value(), std::nullopt);
    EXPECT_EQ(difficulty_of_map_svg(svg_with_line("<g data-difficulty='3'/>")).value(),
              std::nullopt);
    for (int grade = 1; grade <= 5; ++grade) {
        const std::string attribute = "data-difficulty='" + std::to_string(grade) + "'";
        EXPECT_EQ(difficulty_of_map_svg(svg_with_line("", attribute)).value(), grade);
    }
    for (const char* wrong : {"", "0", "6", "1.5", "-1", "12", "easy", " 1"}) {
        const auto refused = difficulty_of_map_svg(
            svg_with_line("", std::string("data-difficulty='") + wrong + "'"));
        ASSERT_FALSE(refused) << wrong;
        EXPECT_NE(refused.error().line.find("1, 2, 3, 4 or 5"), std::string::npos);
    }
    for (const char* none : {"", "x", "<html/>"}) EXPECT_FALSE(difficulty_of_map_svg(none)) << none;
}

}  // namespace
}  // namespace touchline
