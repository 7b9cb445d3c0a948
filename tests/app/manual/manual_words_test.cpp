#include "app/manual/manual_words.h"

#include "app/operator/setting_words.h"
#include "tests/audio-cues/words/po_file.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

Language loaded(const std::string& code) {
    const auto language = Language::load(TOUCHLINE_CATALOGUES, code);
    EXPECT_TRUE(language) << (language ? "" : language.error().line);
    return language.value_or(Language());
}

std::size_t count_of(std::string_view what, std::string_view text) {
    std::size_t count = 0;
    for (auto at = text.find(what); at != std::string_view::npos; at = text.find(what, at + 1))
        ++count;
    return count;
}

TEST(ManualWords, NamesAreFoundOnOneLineAndOverTwo) {
    EXPECT_EQ(quoted_names("Choose \"Upkeep\", then\n  \"Copy from\n  a stick\" and \"open"),
              (std::vector<std::string>{"Upkeep", "Copy from a stick"}));
    EXPECT_TRUE(quoted_names("Nothing “here”.").empty());
}

TEST(ManualWords, AnItemHasTheNameThatTheKioskSays) {
    const std::string page = "The item \"Clean the\nhandle\", or \"Kind of line\".\n";
    EXPECT_EQ(filled_page(page, Language()), "The item “Clean the handle”, or “Kind of line”.\n");
    const Language german = loaded("de");
    EXPECT_EQ(filled_page(page, german),
              "The item „" + german.text("operator", "Clean the handle") + "“, or „" +
                  german.text("setting", "Kind of line") + "“.\n");
    EXPECT_EQ(filled_page("\"no such item\"", loaded("fr")), "«\u00a0no such item\u00a0»");
}

TEST(ManualWords, WhatMayBeWrittenStaysAsItIsWritten) {
    const auto allowed = [](const char* table, const char* key, const Language& language) {
        return allowed_values(*find_setting(table, key), language);
    };
    const Language german = loaded("de");
    EXPECT_EQ(allowed("feel", "give_way_N", german), "eine Zahl von 0.5 bis 3");
    EXPECT_EQ(allowed("picture", "detail", Language()), "a whole number from 1 to 5");
    EXPECT_EQ(allowed("care", "maintenance", german), "true (an) oder false (aus)");
    EXPECT_EQ(allowed("sound", "amount", Language()), "\"none\" or \"short\" or \"all\"");
    EXPECT_EQ(allowed("feel", "mode", german).find("\"wall\" (Wand) oder \"groove\" (Rille)"), 0U);
    EXPECT_EQ(allowed("language", "first", loaded("es")), "el código de un idioma como \"en\"");
}

TEST(ManualWords, TheSettingsAreAllThereInEveryLanguage) {
    const auto codes = languages_in(TOUCHLINE_CATALOGUES);
    ASSERT_TRUE(codes);
    for (const std::string& code : *codes) {
        const Language language = loaded(code);
        const std::string page = filled_page("One.\n\n<!-- settings -->\n", language);
        EXPECT_EQ(page.find("<!--"), std::string::npos);
        EXPECT_EQ(count_of("#### ", page), setting_rows().size());
        for (const SettingRow& row : setting_rows()) {
            const std::string name = "#### " + setting_name(row, language) + "\n\n";
            EXPECT_NE(page.find(name + setting_help(row, language)), std::string::npos) << name;
            const std::string key = std::string(row.table) + '.' + std::string(row.key);
            EXPECT_EQ(count_of('`' + key + '`', page), 1U) << code << ' ' << key;
        }
    }
}

/// Every text that is looked up in the context "manual" exists; otherwise a page would be half
/// English.
TEST(ManualWords, NoPageSaysTheSettingsHalfInEnglish) {
    const PoFile texts = read_po(TOUCHLINE_SOURCE_DIR "/audio-cues/words/catalogue/touchline.pot");
    for (const SettingRow& row : setting_rows()) {
        if (!std::holds_alternative<std::string Settings::*>(row.field)) continue;
        EXPECT_TRUE(texts.contains({"manual", allowed_values(row)})) << allowed_values(row);
    }
    for (const char* code : {"de", "es", "fr", "it"}) {
        const std::string page = settings_page(loaded(code));
        for (const char* english :
             {" is ", "At first", "section", " sets it", " set it", " or ", " from ", "for none"}) {
            if (std::string_view(code) == "fr" && std::string_view(english) == "section") continue;
            EXPECT_EQ(count_of(english, page), 0U) << code << ": " << english;
        }
    }
}

}  // namespace
}  // namespace touchline
