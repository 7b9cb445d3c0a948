// Tests that every text of the catalogues keeps to audio-cues/words/glossary.md.
#include "tests/audio-cues/words/glossary.h"

#include "audio-cues/words/language.h"
#include "tests/audio-cues/words/po_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace touchline {
namespace {

const std::string words_folder = TOUCHLINE_SOURCE_DIR "/audio-cues/words";

using Lines = std::vector<std::string>;

const std::vector<GlossaryRow>& glossary() {
    static const std::vector<GlossaryRow> rows = [] {
        std::ifstream file(words_folder + "/glossary.md");
        return glossary_of(std::string(std::istreambuf_iterator<char>(file), {}));
    }();
    return rows;
}

void expect_kept(const std::string& code, const std::string& text, const std::string& english) {
    for (const std::string& found : barred_in(glossary(), code, text, english))
        ADD_FAILURE() << code << ": " << found << ": " << text;
    for (const std::string& missing : missing_in(glossary(), code, text, english))
        ADD_FAILURE() << code << ": " << missing << ": " << text;
}

TEST(Glossary, EveryTextOfEveryLanguageKeepsToIt) {
    for (const auto& [key, entry] : read_po(words_folder + "/catalogue/touchline.pot")) {
        if (key.first == "respelling") continue;
        expect_kept("en", key.second, key.second);
        expect_kept("en", entry.plural, entry.plural);
    }
    for (const auto& file : std::filesystem::directory_iterator(words_folder + "/catalogue")) {
        if (file.path().extension() != ".po") continue;
        for (const auto& [key, entry] : read_po(file.path().string())) {
            if (key.second.empty() || key.first == "respelling") continue;
            for (const std::string& said : entry.said)
                expect_kept(file.path().stem().string(), said, key.second);
        }
    }
}

TEST(Glossary, IsATableWithAWordForEveryTermInEveryLanguageOfIt) {
    ASSERT_GT(glossary().size(), 50U);
    for (const GlossaryRow& row : glossary()) {
        for (const char* code : {"de", "en", "es", "fr", "it"})
            EXPECT_TRUE(row.said.contains(code));
        for (const auto& [code, said] : row.said) EXPECT_FALSE(said.empty()) << row.english;
        for (const auto& [code, words] : row.barred) {
            EXPECT_TRUE(row.said.contains(code)) << row.english << ": " << code;
            for (const BarredWord& word : words) EXPECT_FALSE(word.word.empty()) << row.english;
        }
    }
}

/// Otherwise nobody could keep to it.
TEST(Glossary, BarsNoTermOfItsOwn) {
    for (const GlossaryRow& row : glossary()) {
        for (const auto& [code, said] : row.said)
            EXPECT_EQ(barred_in(glossary(), code, said, row.english), Lines()) << row.english;
    }
}

constexpr auto made_up = R"(
| term | English (en) | French (fr) | not |
|---|---|---|---|
| with files | **USB stick** | la clé USB | en: stick (USB stick); fr: clé (clé USB or key) |
| key | Select | Choisir | fr: Valider, l’écran |
)";

TEST(Glossary, ATermInBoldIsSaidByItsWord) {
    const auto rows = glossary_of(made_up);
    const auto missing = [&rows](const std::string& text, const std::string& english) {
        return missing_in(rows, "fr", text, english);
    };
    EXPECT_EQ(missing("Retirez-la.", "Pull the USB sticks out."),
              Lines{"\"USB stick\" is \"la clé USB\""});
    EXPECT_EQ(missing("Retirez la Clé.", "Pull the USB stick out."), Lines());
    EXPECT_EQ(missing("Retirez les clés USB.", "Pull the USB sticks out."), Lines());
    EXPECT_EQ(missing("Retirez-la.", "Pull it out, it is USB sticky."), Lines());
    EXPECT_EQ(missing("Validez.", "Press Select."), Lines()) << "not in bold";
    EXPECT_EQ(missing_in(rows, "it", "La tolga.", "Pull the USB stick out."), Lines());
}

TEST(Glossary, AMadeUpOneFindsWhatItBars) {
    const auto rows = glossary_of(made_up);
    ASSERT_EQ(rows.size(), 2U);
    const auto found = [&rows](const std::string& text, const std::string& english) {
        return barred_in(rows, "fr", text, english).size();
    };
    EXPECT_EQ(barred_in(rows, "fr", "Une clé est là.", "A USB stick is in."),
              Lines{"not \"clé\" but \"la clé USB\""});
    EXPECT_EQ(found("Clé USB, puis la clé.", "It is in."), 1U) << "the second one";
    EXPECT_EQ(found("La clé USB est là.", "It is in."), 0U);
    EXPECT_EQ(found("Une clé, trois clefs", "A key"), 0U) << "a key is one";
    EXPECT_EQ(found("Une clé", "A monkey"), 1U) << "no word begins so";
    EXPECT_EQ(found("Clé", "It"), 1U) << "a small letter bars its capital";
    EXPECT_EQ(found("«\u00a0Valider\u00a0» ou valider", "Select"), 1U) << "a capital bars itself";
    EXPECT_EQ(found("Validera la clétte", "Select"), 0U) << "whole words alone";
    EXPECT_EQ(found("de l'écran", "Select"), 1U) << "of either apostrophe";
    EXPECT_EQ(barred_in(rows, "en", "Sticks stick.", "Sticks stick.").size(), 1U);
    EXPECT_EQ(barred_in(rows, "it", "clé", "stick"), Lines()) << "a language without a column";
}

}  // namespace
}  // namespace touchline
