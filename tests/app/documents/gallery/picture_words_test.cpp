// Tests what a listener needs of the words of every shipped picture, in each language.
#include "app/documents/decode/files.h"
#include "app/documents/decode/map_svg.h"
#include "tests/app/documents/gallery/pictures.h"
#include "tests/audio-cues/words/glossary.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using Words = std::vector<std::string>;

constexpr std::size_t longest_sentence_words = 12;
constexpr std::size_t longest_name_words = 7;

/// Words that are unfit for people who cannot see: colours, and "look". In lower case, whole words.
const std::map<std::string, std::set<std::string>> unfit_words{
    {"en",
     {"see", "sees", "seen", "saw", "view", "look", "looks", "looking", "watch", "red", "green",
      "blue", "yellow", "black", "white", "brown", "grey", "colour"}},
    {"fr", {"voir",     "voit",    "voyez", "vu",    "vue",     "vus",  "regarder",
            "regardez", "regarde", "rouge", "vert",  "verte",   "bleu", "bleue",
            "jaune",    "noir",    "noire", "blanc", "blanche", "gris"}},
    {"de",
     {"sehen", "sieht", "siehst", "gesehen", "schau", "schauen", "schaut", "blick", "blickt", "rot",
      "grün", "blau", "gelb", "schwarz", "weiß", "braun", "grau"}},
    {"es",
     {"ver", "ve", "vea", "visto", "vista", "mira", "mirar", "mirando", "rojo", "roja", "verde",
      "azul", "amarillo", "negro", "negra", "blanco", "blanca", "gris"}},
    {"it",
     {"vedere", "vede", "veda", "visto", "vista", "guarda", "guardare", "guardando", "rosso",
      "rossa", "verde", "blu", "azzurro", "giallo", "nero", "nera", "bianco", "bianca", "grigio"}}};

/// Words that the ear takes for something else (the kiosk's level, the handle in the visitor's
/// hand, the white stick), or that the voice says as another word.
const std::map<std::string, std::set<std::string>> misheard_words{
    {"en", {"level", "stick", "bow", "bows"}},
    {"fr", {"dos", "roues", "ouïe", "l’est"}},
    {"de", {"griff", "stock", "taille", "kirchstraße"}},
    {"es", {"mango", "palo", "bastón"}},
    {"it", {"impugnatura", "bastone"}}};

constexpr std::string_view no_break_blank = "\u00a0";
constexpr std::string_view narrow_no_break_blank = "\u202f";

std::string with_plain_blanks(std::string text) {
    for (const std::string_view blank : {no_break_blank, narrow_no_break_blank}) {
        for (auto at = text.find(blank); at != std::string::npos; at = text.find(blank))
            text.replace(at, blank.size(), " ");
    }
    return text;
}

/// Returns the words in lower case, without marks at their ends.
Words words_in(const std::string& sentence) {
    Words words;
    std::istringstream stream(with_plain_blanks(sentence));
    for (std::string word; stream >> word;) {
        const auto is_mark = [](char c) {
            return std::string_view(".,;:!?()").find(c) != std::string_view::npos;
        };
        while (!word.empty() && is_mark(word.back())) word.pop_back();
        std::transform(word.begin(), word.end(), word.begin(), [](char c) {
            return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        });
        if (!word.empty()) words.push_back(word);
    }
    return words;
}

/// A colon and a semicolon also end one, as they are heard so.
Words sentences_in(const std::string& text) {
    Words sentences;
    std::size_t begin = 0;
    for (std::size_t end = 0; end < text.size(); ++end) {
        if (std::string_view(".:;!?").find(text[end]) == std::string_view::npos) continue;
        sentences.push_back(text.substr(begin, end + 1 - begin));
        begin = end + 1;
    }
    if (!words_in(text.substr(begin)).empty()) sentences.push_back(text.substr(begin));
    return sentences;
}

void expect_fit(const std::string& text, const std::string& language) {
    for (const std::string& word : words_in(text)) {
        EXPECT_EQ(unfit_words.at(language).count(word), 0U) << word << " in: " << text;
        EXPECT_EQ(misheard_words.at(language).count(word), 0U) << word << " in: " << text;
    }
}

/// Returns the marks that lack the blank that French puts before them.
std::string marks_without_blank(const std::string& text) {
    std::string marks;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::string_view before = std::string_view(text).substr(0, at);
        const bool is_colon = text[at] == ':';
        const bool is_other = text[at] == ';' || text[at] == '!' || text[at] == '?';
        if ((is_colon && !before.ends_with(no_break_blank)) ||
            (is_other && !before.ends_with(narrow_no_break_blank)))
            marks += text[at];
    }
    return marks;
}

constexpr auto gap = "nobody said it";

/// Replaces the text between every `opening` and the next '<' by the gap.
std::string with_gaps(std::string text, const std::string& opening) {
    for (auto at = text.find(opening); at != std::string::npos; at = text.find(opening, at + 1)) {
        const auto begin = at + opening.size();
        text.replace(begin, text.find('<', begin) - begin, gap);
    }
    return text;
}

/// Replaces the text between the last '>' and every `closing` by the gap.
std::string with_gaps_before(std::string text, const std::string& closing) {
    for (auto at = text.find(closing); at != std::string::npos; at = text.find(closing, at + 1)) {
        const auto begin = text.rfind('>', at) + 1;
        text.replace(begin, at - begin, gap);
        at = text.find(closing, begin);
    }
    return text;
}

/// Replaces every text of the file that has no language tag.
std::string without_english(const std::string& text) {
    return with_gaps_before(with_gaps(with_gaps(text, "<title>"), "<desc>"), "</text>");
}

/// Returns everything that a map says.
Words said_by(const TactileMap& map) {
    Words said{map.title, map.description};
    for (const Outline& outline : map.outlines) said.push_back(outline.label);
    for (const Label& label : map.labels) said.push_back(label.text);
    return said;
}

class PictureWords : public testing::TestWithParam<std::string> {};

TEST_P(PictureWords, EveryTextIsThereInTheLanguageItself) {
    for (const ShippedPicture& picture : shipped_pictures()) {
        const bool is_english = GetParam() == "en";
        const auto map =
            parse_map_svg(is_english ? picture.text : without_english(picture.text), {GetParam()});
        ASSERT_TRUE(map) << map.error().line;
        for (const std::string& text : said_by(*map)) {
            EXPECT_FALSE(words_in(text).empty()) << picture.name;
            EXPECT_NE(text, gap) << picture.name;
        }
    }
}

TEST_P(PictureWords, SentencesAreShortAndPlain) {
    for (const auto& [name, text, map] : shipped_pictures({GetParam()})) {
        SCOPED_TRACE(name);
        const Words sentences = sentences_in(map.description);
        EXPECT_GE(sentences.size(), 2U);
        for (const std::string& sentence : sentences)
            EXPECT_LE(words_in(sentence).size(), longest_sentence_words) << sentence;
        EXPECT_EQ(map.description.back(), '.');
        for (const std::string& said : said_by(map)) expect_fit(said, GetParam());
    }
}

/// The title is said before the description.
TEST_P(PictureWords, TheDescriptionGoesOnWhereTheTitleEnds) {
    for (const ShippedPicture& picture : shipped_pictures({GetParam()}))
        EXPECT_FALSE(picture.map.description.starts_with(picture.map.title)) << picture.name;
}

TEST_P(PictureWords, MarksAreThoseOfTheLanguage) {
    for (const ShippedPicture& picture : shipped_pictures({GetParam()})) {
        for (const std::string& text : said_by(picture.map)) {
            EXPECT_EQ(text.find('\''), std::string::npos) << text;
            if (GetParam() == "fr") {
                EXPECT_EQ(marks_without_blank(text), "") << text;
            } else {
                EXPECT_EQ(with_plain_blanks(text), text);
            }
        }
    }
}

TEST_P(PictureWords, EveryPartHasAShortNameOfItsOwn) {
    for (const auto& [name, text, map] : shipped_pictures({GetParam()})) {
        SCOPED_TRACE(name);
        std::set<std::string> used;
        for (const std::string& part : part_names(map)) {
            EXPECT_LE(words_in(part).size(), longest_name_words) << part;
            EXPECT_TRUE(used.insert(part).second) << part;
        }
        for (const Label& label : map.labels)
            EXPECT_LE(words_in(label.text).size(), longest_name_words) << label.text;
        EXPECT_LE(words_in(map.title).size(), longest_name_words) << map.title;
    }
}

const std::vector<GlossaryRow>& glossary() {
    static const std::vector<GlossaryRow> rows = [] {
        return glossary_of(read_text(TOUCHLINE_SOURCE_DIR "/audio-cues/words/glossary.md").value());
    }();
    return rows;
}

TEST_P(PictureWords, KeepToTheGlossary) {
    const auto english = shipped_pictures();
    const auto pictures = shipped_pictures({GetParam()});
    ASSERT_EQ(pictures.size(), english.size());
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const Words said = said_by(pictures[i].map);
        const Words meant = said_by(english[i].map);
        ASSERT_EQ(said.size(), meant.size()) << pictures[i].name;
        for (std::size_t text = 0; text < said.size(); ++text) {
            for (const auto& found : barred_in(glossary(), GetParam(), said[text], meant[text]))
                ADD_FAILURE() << GetParam() << ": " << found << ": " << said[text];
        }
    }
}

TEST_P(PictureWords, EveryTitleIsDifferent) {
    std::set<std::string> used;
    for (const auto& [name, text, map] : shipped_pictures({GetParam()}))
        EXPECT_TRUE(used.insert(map.title).second) << map.title;
}

INSTANTIATE_TEST_SUITE_P(Gallery, PictureWords, testing::Values("en", "fr", "de", "es", "it"),
                         [](const auto& language) { return language.param; });

TEST(Pictures, ThereAreFortyAndEachIsAMapOfTheDrawingArea) {
    const auto pictures = shipped_pictures();
    EXPECT_GE(pictures.size(), 40U);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        EXPECT_EQ(pictures[i].map.area, Area{}) << pictures[i].name;
        const std::string number = std::to_string(100 + i + 1).substr(1);
        EXPECT_TRUE(pictures[i].name.starts_with(number + "-")) << pictures[i].name;
    }
}

TEST(Pictures, GradesRiseWithThePartsAndNoneIsEmpty) {
    const std::map<int, std::size_t> most_parts{{1, 1}, {2, 4}, {3, 6}, {4, 9}, {5, 12}};
    std::map<int, int> pictures_of;
    for (const auto& [name, text, map] : shipped_pictures()) {
        const auto grade = difficulty_of_map_svg(text).value();
        ASSERT_TRUE(grade) << name;
        EXPECT_LE(part_names(map).size(), most_parts.at(*grade)) << name;
        ++pictures_of[*grade];
    }
    for (int grade = 1; grade <= 5; ++grade) EXPECT_GE(pictures_of[grade], 3) << grade;
}

/// If this fails, run gallery_sheet, which also draws them all in one picture.
TEST(Pictures, TheReadmeListsThem) {
    const auto readme = read_text(TOUCHLINE_SOURCE_DIR "/app/documents/gallery/README.md").value();
    const std::string table = table_of_pictures();
    EXPECT_NE(readme.find(table), std::string::npos) << table;
}

}  // namespace
}  // namespace touchline
