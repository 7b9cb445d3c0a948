#include "app/braille/translation.h"

#include "config/types/utf8.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <set>
#include <thread>

#include <gtest/gtest.h>
#include <liblouis/liblouis.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

using std::string_literals::operator""s;

constexpr std::array languages{"en", "de", "fr", "es", "it"};
constexpr std::array grades{BrailleGrade::uncontracted, BrailleGrade::contracted};

BrailleText cells_of(const std::string& text, const std::string& language, BrailleGrade grade) {
    const auto braille = braille_of(text, language, grade);
    EXPECT_TRUE(braille) << braille.error().line;
    return braille.value_or(BrailleText{});
}

/// Returns the cells as the characters of Unicode's braille patterns.
std::string patterns_of(const std::vector<std::uint8_t>& cells) {
    std::string text;
    for (const std::uint8_t cell : cells) {
        text += {'\xe2', static_cast<char>(0xa0 + (cell >> 6U)),
                 static_cast<char>(0x80 + (cell & 0x3fU))};
    }
    return text;
}

std::string patterns_of(const std::string& text, const std::string& language, BrailleGrade grade) {
    return patterns_of(cells_of(text, language, grade).cells);
}

int characters_in(std::string_view text) {
    int count = 0;
    while (!text.empty()) {
        text.remove_prefix(std::max(utf8_character_bytes(text), std::size_t{1}));
        ++count;
    }
    return count;
}

/// Reads the cells back by another table's rules than ours: liblouis's own way from braille to
/// text. ASCII only.
std::string read_back(const std::vector<std::uint8_t>& cells, const char* table) {
    std::vector<widechar> patterns;
    for (const std::uint8_t cell : cells) patterns.push_back(0x8000U + cell);
    std::vector<widechar> text(cells.size() * 16 + 64);
    int given = static_cast<int>(patterns.size());
    int made = static_cast<int>(text.size());
    EXPECT_NE(lou_backTranslateString(table, patterns.data(), &given, text.data(), &made, nullptr,
                                      nullptr, dotsIO),
              0);
    std::string ascii;
    for (int i = 0; i < made; ++i) {
        const widechar code = text[static_cast<std::size_t>(i)];
        ascii += code < 0x80U ? static_cast<char>(code) : '?';
    }
    return ascii;
}

struct Word {
    const char* language;
    BrailleGrade grade;
    const char* text;
    const char* patterns;
};

/// From the primers of each country's code.
const std::array known_words{
    Word{"en", BrailleGrade::uncontracted, "the house", "⠞⠓⠑⠀⠓⠕⠥⠎⠑"},
    Word{"en", BrailleGrade::contracted, "the people", "⠮⠀⠏"},
    Word{"en", BrailleGrade::contracted, "House 12", "⠠⠓⠳⠎⠑⠀⠼⠁⠃"},
    Word{"de", BrailleGrade::uncontracted, "das Haus", "⠙⠁⠎⠀⠓⠁⠥⠎"},
    Word{"de", BrailleGrade::contracted, "das Haus", "⠙⠀⠓⠡⠎"},
    Word{"de", BrailleGrade::uncontracted, "größer", "⠛⠗⠪⠮⠑⠗"},
    Word{"fr", BrailleGrade::uncontracted, "élève", "⠿⠇⠮⠧⠑"},
    Word{"es", BrailleGrade::uncontracted, "niño", "⠝⠊⠻⠕"},
    Word{"es", BrailleGrade::uncontracted, "¿qué?", "⠢⠟⠥⠮⠢"},
    Word{"it", BrailleGrade::uncontracted, "città", "⠉⠊⠞⠞⠷"},
};

TEST(BrailleTranslation, KnownWordsReadAsThePrimersHaveThem) {
    for (const Word& word : known_words) {
        const std::string made = patterns_of(word.text, word.language, word.grade);
        EXPECT_EQ(made, word.patterns) << word.language << ": " << word.text;
    }
}

/// liblouis reads German Kurzschrift and Italian back wrongly, whoever wrote them: words of the
/// first are above, the second's bare letters are those of Spanish.
TEST(BrailleTranslation, WordsComeBackFromBothGrades) {
    struct Sentence {
        const char* language;
        BrailleGrade grade;
        const char* text;
        const char* table;
    };
    using enum BrailleGrade;
    for (const Sentence& each :
         {Sentence{"en", uncontracted, "a small house with a door", "en-ueb-g1.ctb"},
          Sentence{"en", contracted, "a small house with a door", "en-ueb-g2.ctb"},
          Sentence{"de", uncontracted, "ein kleines haus mit einem tor", "de-g0.utb"},
          Sentence{"fr", uncontracted, "une petite maison sur la mer", "fr-bfu-comp6.utb"},
          Sentence{"fr", contracted, "une petite maison sur la mer", "fr-bfu-g2.ctb"},
          Sentence{"es", uncontracted, "una casa con dos puertas", "es-g1.ctb"},
          Sentence{"es", contracted, "una casa con dos puertas", "es-g2.ctb"},
          Sentence{"it", uncontracted, "una piccola casa sul mare", "es-g1.ctb"}}) {
        const BrailleText braille = cells_of(each.text, each.language, each.grade);
        EXPECT_EQ(read_back(braille.cells, each.table), each.text) << each.table;
    }
}

TEST(BrailleTranslation, ContractionsAreShorterWhereThereAreAny) {
    const std::string text =
        "The people know that children have everything and nothing. "
        "Die Menschen und der Mann haben einen Hund. "
        "Les enfants sont toujours avec nous, mais vous pouvez parler. "
        "Los hombres tienen todo para nosotros y algunos saben.";
    for (const char* language : languages) {
        const auto plain = cells_of(text, language, BrailleGrade::uncontracted).cells.size();
        const auto short_form = cells_of(text, language, BrailleGrade::contracted).cells.size();
        if (has_contractions(language)) {
            EXPECT_LT(short_form, plain) << language;
        } else {
            EXPECT_EQ(short_form, plain) << language;
        }
    }
    EXPECT_FALSE(has_contractions("it"));
    EXPECT_TRUE(has_contractions("en-GB"));
}

TEST(BrailleTranslation, ARegionIsThatOfItsLanguage) {
    EXPECT_EQ(cells_of("Straße", "de-AT", BrailleGrade::contracted),
              cells_of("Straße", "de", BrailleGrade::contracted));
    EXPECT_EQ(cells_of("colour", "en_GB", BrailleGrade::contracted),
              cells_of("colour", "en", BrailleGrade::contracted));
}

TEST(BrailleTranslation, ALanguageWithoutATableIsRefusedInOneLine) {
    for (const char* language : {"xx", "", "e", "eng", "-", "../../etc/passwd"}) {
        EXPECT_FALSE(has_braille(language));
        const auto braille = braille_of("house", language, BrailleGrade::contracted);
        ASSERT_FALSE(braille) << language;
        EXPECT_NE(braille.error().line.find("en, de, fr, es and it"), std::string::npos);
        EXPECT_EQ(braille.error().line.find('\n'), std::string::npos);
    }
}

TEST(BrailleTranslation, NothingGivesNothing) {
    for (const char* language : languages) {
        EXPECT_EQ(cells_of("", language, BrailleGrade::contracted), BrailleText());
    }
}

TEST(BrailleTranslation, WhatTheTableLacksIsWrittenByItsLike) {
    struct Alike {
        const char* language;
        const char* text;
        const char* like;
    };

    const std::array alike{
        Alike{"it", "l’albero", "l'albero"}, Alike{"it", "“sì”", "\"sì\""},
        Alike{"it", "e poi…", "e poi..."},   Alike{"es", "città", "citta"},
        Alike{"it", "señor", "senor"},       Alike{"es", "a_b", "a-b"},
        Alike{"it", "a — b", "a - b"},       Alike{"de", "東京", "??"},
        Alike{"fr", "東京", "??"},           Alike{"es", "smørrebrød", "smorrebrod"},
        Alike{"it", "Œuvre", "Oeuvre"},      Alike{"en", "\xff\xc3 a", "?? a"},
        Alike{"de", "a\u00a0b\tc", "a b c"}, Alike{"es", "mar\u00adco", "marco"},
    };
    for (const Alike& pair : alike) {
        EXPECT_EQ(patterns_of(pair.text, pair.language, BrailleGrade::uncontracted),
                  patterns_of(pair.like, pair.language, BrailleGrade::uncontracted))
            << pair.language << ": " << pair.text;
    }
    // The hyphen, which the Italian table lacks.
    EXPECT_EQ(patterns_of("a-b", "it", BrailleGrade::uncontracted), "⠁⠤⠃");
}

TEST(BrailleTranslation, ALetterWithAnAccentBehindItIsOneLetter) {
    for (const char* language : languages) {
        for (const BrailleGrade grade : grades) {
            EXPECT_EQ(patterns_of("e\u0301le\u0300ve", language, grade),
                      patterns_of("élève", language, grade))
                << language;
        }
    }
}

TEST(BrailleTranslation, PlacesSayWhichCellIsWhichCharacter) {
    const BrailleText braille = cells_of("the house", "en", BrailleGrade::contracted);
    EXPECT_EQ(patterns_of(braille.cells), "⠮⠀⠓⠳⠎⠑");
    EXPECT_EQ(braille.first_cell, (std::vector<int>{0, 0, 0, 1, 2, 3, 3, 4, 5}));
    EXPECT_EQ(braille.character, (std::vector<int>{0, 3, 4, 5, 7, 8}));
    // A soft hyphen has no cell; a byte that is no character is one.
    const BrailleText odd = cells_of("a\u00ad\xff", "de", BrailleGrade::uncontracted);
    EXPECT_EQ(odd.first_cell, (std::vector<int>{0, 1, 1}));
    EXPECT_EQ(odd.character, (std::vector<int>{0, 2}));
}

/// What every translation keeps, whatever the text.
void expect_sound(const std::string& text, const std::string& language, BrailleGrade grade) {
    const BrailleText braille = cells_of(text, language, grade);
    const int count = characters_in(text);
    ASSERT_EQ(static_cast<int>(braille.first_cell.size()), count);
    ASSERT_EQ(braille.character.size(), braille.cells.size());
    EXPECT_TRUE(std::ranges::is_sorted(braille.first_cell));
    EXPECT_TRUE(std::ranges::is_sorted(braille.character));
    for (const int cell : braille.first_cell) {
        EXPECT_GE(cell, 0);
        EXPECT_LE(cell, static_cast<int>(braille.cells.size()));
    }
    for (const int character : braille.character) {
        EXPECT_GE(character, 0);
        EXPECT_LT(character, count);
    }
}

/// Returns texts of any bytes, and of characters that tables have rules for.
rc::Gen<std::string> any_text() {
    static const std::vector<std::string> pieces{
        "a", "A",      "B", "the ", "st",   "sch",  "1",  "2.5", "%",      "-",      "’",      "…",
        "é", "Ü",      "ß", "ñ",    "¿",    "\n",   " ",  "  ",  "\u0301", "\u200b", "\u00ad", "東",
        "⠿", "\u2800", "😀", "€",    "\xff", "\xc3", "\\", "_",   "#",      "ABC",    "q"};
    return rc::gen::map(
        rc::gen::container<std::vector<std::string>>(rc::gen::oneOf(
            rc::gen::elementOf(pieces),
            rc::gen::map(rc::gen::arbitrary<char>(), [](char c) { return std::string(1, c); }))),
        [](const std::vector<std::string>& chosen) {
            std::string text;
            for (const std::string& piece : chosen) text += piece;
            return text;
        });
}

RC_GTEST_PROP(BrailleTranslation, PlacesAreSoundForAnyBytes, ()) {
    const std::string text = *any_text();
    const std::string language = *rc::gen::elementOf(languages);
    const BrailleGrade grade = *rc::gen::elementOf(grades);
    expect_sound(text, language, grade);
}

RC_GTEST_PROP(BrailleTranslation, EveryVisibleCharacterHasADot, ()) {
    // One character alone: none of any script is lost.
    const auto code = *rc::gen::inRange(0x21, 0x2ffff);
    if (code >= 0xd800 && code <= 0xdfff) return;
    std::string text;
    const auto byte = [&](int bits, int mark) {
        text += static_cast<char>(static_cast<unsigned char>(bits | mark));
    };
    if (code < 0x80) {
        byte(code, 0);
    } else if (code < 0x800) {
        byte(code >> 6, 0xc0), byte(code & 0x3f, 0x80);
    } else if (code < 0x10000) {
        byte(code >> 12, 0xe0), byte((code >> 6) & 0x3f, 0x80), byte(code & 0x3f, 0x80);
    } else {
        byte(code >> 18, 0xf0), byte((code >> 12) & 0x3f, 0x80), byte((code >> 6) & 0x3f, 0x80),
            byte(code & 0x3f, 0x80);
    }
    // Blanks, control characters and unseen marks have none, as plain_line() has them too.
    if (plain_line(text) != text || code == 0x2800) return;
    const std::set<int> unseen{0xa0,    0xad,    0x600,   0x601,   0x602,   0x603,  0x604,  0x605,
                               0x6dd,   0x70f,   0x890,   0x891,   0x8e2,   0x1680, 0x180e, 0x2000,
                               0x2001,  0x2002,  0x2003,  0x2004,  0x2005,  0x2006, 0x2007, 0x2008,
                               0x2009,  0x200a,  0x202f,  0x205f,  0x3000,  0xfff9, 0xfffa, 0xfffb,
                               0x110bd, 0x110cd, 0x1bca0, 0x1bca1, 0x1bca2, 0x1bca3};
    if (unseen.contains(code) || (code >= 0x13430 && code <= 0x1343f) ||
        (code >= 0x1d173 && code <= 0x1d17a)) {
        return;
    }
    for (const char* language : languages) {
        const auto braille = cells_of("a" + text, language, BrailleGrade::uncontracted).cells;
        // An accent that no letter has may pile up on the a without a cell.
        const auto after = cells_of("a", language, BrailleGrade::uncontracted).cells;
        const bool has_dots = braille.size() > after.size() || braille != after;
        const auto alone = cells_of(text, language, BrailleGrade::uncontracted).cells;
        const bool is_alone = std::ranges::any_of(alone, [](auto cell) { return cell != 0; });
        RC_ASSERT(has_dots || is_alone || alone.empty());
    }
}

TEST(BrailleTranslation, AVeryLongTextIsWholeAndQuick) {
    const std::string sentence = "The big house has 12 doors, and a garden with trees. ";
    std::string text;
    while (text.size() < 20'000) text += sentence;
    for (const char* language : languages) {
        for (const BrailleGrade grade : grades) {
            const auto began = std::chrono::steady_clock::now();
            expect_sound(text, language, grade);
            const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
            EXPECT_LT(took.count(), 20.0) << language;  // 5 us a character, and slow machines
            // A piece ends at a blank, so that no word is cut: the text is its sentence, again and
            // again.
            const auto once = cells_of(sentence, language, grade).cells;
            const auto all = cells_of(text, language, grade).cells;
            ASSERT_EQ(all.size(), once.size() * (text.size() / sentence.size())) << language;
            for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(all[i], once[i % once.size()]);
        }
    }
    // Without a single blank, too.
    for (const char* language : languages) {
        expect_sound(std::string(5'000, 'a'), language, BrailleGrade::contracted);
    }
}

TEST(BrailleTranslation, ThreadsMayTranslateAtOnce) {
    std::vector<std::thread> threads;
    std::array<std::vector<std::string>, 4> made;
    for (auto& mine : made) {
        threads.emplace_back([&mine] {
            for (std::size_t i = 0; i < 20; ++i) {
                for (const char* language : languages) {
                    mine.push_back(patterns_of("the house é 12", language, grades[i % 2]));
                }
            }
        });
    }
    for (auto& thread : threads) thread.join();
    for (const auto& theirs : made) EXPECT_EQ(theirs, made[0]);
    EXPECT_EQ(made[0].size(), 100U);
}

TEST(BrailleAscii, IsTheNorthAmericanTable) {
    // From the table of the BRF format: each character once, by its dots.
    const std::map<char, std::string> dots{
        {'A', "1"},     {'B', "12"},    {'C', "14"},    {'J', "245"},   {'K', "13"},
        {'T', "2345"},  {'U', "136"},   {'W', "2456"},  {'Z', "1356"},  {'=', "123456"},
        {'#', "3456"},  {'1', "2"},     {'2', "23"},    {'6', "235"},   {'0', "356"},
        {',', "6"},     {'.', "46"},    {'\'', "3"},    {'-', "36"},    {'/', "34"},
        {'@', "4"},     {'^', "45"},    {'_', "456"},   {'"', "5"},     {'!', "2346"},
        {'&', "12346"}, {'(', "12356"}, {')', "23456"}, {'?', "1456"},  {':', "156"},
        {';', "56"},    {'<', "126"},   {'>', "345"},   {'%', "146"},   {'$', "1246"},
        {'+', "346"},   {'*', "16"},    {'[', "246"},   {']', "12456"}, {'\\', "1256"},
        {' ', ""}};
    for (const auto& [character, set] : dots) {
        unsigned int cell = 0;
        for (const char dot : set) cell |= 1U << static_cast<unsigned int>(dot - '1');
        EXPECT_EQ(braille_ascii(static_cast<std::uint8_t>(cell)), character) << set;
        EXPECT_EQ(braille_ascii(static_cast<std::uint8_t>(cell | 0xc0U)), character) << set;
    }
    std::set<char> all;
    for (unsigned int cell = 0; cell < 64; ++cell) {
        all.insert(braille_ascii(static_cast<std::uint8_t>(cell)));
    }
    EXPECT_EQ(all.size(), 64U);
    EXPECT_EQ(*all.begin(), ' ');
    EXPECT_EQ(*all.rbegin(), '_');
}

TEST(BrailleTranslation, TellsHowManySignsItLacks) {
    const auto lacking = [](std::string_view text) {
        return braille_of(text, "en", BrailleGrade::uncontracted).value().question_marks;
    };
    EXPECT_EQ(lacking("A house? Yes, caf\u00e9."), 0U);
    EXPECT_EQ(lacking("\u16a0\u16a2 and \u9c7c?"), 3U);
}

}  // namespace
}  // namespace touchline
