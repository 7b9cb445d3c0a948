// Tests the catalogues of the pages (app/manual/po), without po4a: complete, up to date with the
// pages, and true to code and options.
#include "app/manual/manual_words.h"
#include "tests/audio-cues/words/po_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

namespace touchline {
namespace {

const std::string manual_folder = TOUCHLINE_SOURCE_DIR "/app/manual";
const std::string words_folder = TOUCHLINE_SOURCE_DIR "/audio-cues/words/catalogue";

PoFile texts_of_pages() {
    PoFile file = read_po(manual_folder + "/po/pages.pot");
    file.erase({"", ""});
    return file;
}

std::set<std::string> codes_in(const std::string& folder) {
    std::set<std::string> codes;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".po") codes.insert(entry.path().stem().string());
    return codes;
}

/// Replaces each run of blanks and line ends by one blank; removes those at both ends.
std::string with_single_blanks(const std::string& text) {
    std::string single;
    for (const char c : text) {
        const bool is_blank = c == ' ' || c == '\n';
        if (!is_blank) single += c;
        if (is_blank && !single.empty() && single.back() != ' ') single += ' ';
    }
    while (single.ends_with(' ')) single.pop_back();
    return single;
}

std::string page_text(const std::string& name) {
    std::ifstream file(manual_folder + '/' + name);
    return with_single_blanks({std::istreambuf_iterator<char>(file), {}});
}

/// Returns the texts between two marks: "`" for code, "**" for commands and options.
std::multiset<std::string> spans(const std::string& text, const std::string& mark) {
    std::multiset<std::string> found;
    auto open = text.find(mark);
    while (open != std::string::npos) {
        const auto close = text.find(mark, open + mark.size());
        if (close == std::string::npos) break;
        found.insert(text.substr(open + mark.size(), close - open - mark.size()));
        open = text.find(mark, close + mark.size());
    }
    return found;
}

std::multiset<std::string> names(const std::string& text) {
    const auto found = quoted_names(text);
    return {found.begin(), found.end()};
}

/// A language of the kiosk may have no pages at first; pages in another language are made with its
/// words.
TEST(PageCatalogue, IsOfLanguagesThatTheKioskSpeaks) {
    const auto of_pages = codes_in(manual_folder + "/po");
    const auto of_kiosk = codes_in(words_folder);
    for (const char* code : {"de", "es", "fr"}) EXPECT_TRUE(of_pages.contains(code)) << code;
    EXPECT_TRUE(std::includes(of_kiosk.begin(), of_kiosk.end(), of_pages.begin(), of_pages.end()));
}

TEST(PageCatalogue, EveryTextIsTranslatedAndNoneDoubtful) {
    const PoFile texts = texts_of_pages();
    ASSERT_GT(texts.size(), 100U);
    for (const std::string& code : codes_in(manual_folder + "/po")) {
        const PoFile file = read_po(manual_folder + "/po/" + code + ".po");
        EXPECT_EQ(file.size(), texts.size() + 1) << code << ": the head and the texts";
        for (const auto& [key, entry] : texts) {
            const auto found = file.find(key);
            ASSERT_NE(found, file.end()) << code << " lacks: " << key.second;
            EXPECT_FALSE(found->second.is_doubtful) << code << ": " << key.second;
            ASSERT_EQ(found->second.said.size(), 1U);
            EXPECT_FALSE(found->second.said.front().empty()) << code << ": " << key.second;
        }
    }
}

/// A changed page has texts that the catalogue lacks, and vice versa.
TEST(PageCatalogue, IsOfThePagesAsTheyAre) {
    std::string left = page_text("manual.md") + ' ' + page_text("touchline.1.md");
    std::vector<std::string> texts;
    for (const auto& [key, entry] : texts_of_pages())
        texts.push_back(with_single_blanks(key.second));
    std::sort(texts.begin(), texts.end(),
              [](const auto& a, const auto& b) { return a.size() > b.size(); });
    for (const std::string& text : texts) {
        bool is_there = false;
        for (auto at = left.find(text); at != std::string::npos; at = left.find(text)) {
            left.replace(at, text.size(), " ");
            is_there = true;
        }
        EXPECT_TRUE(is_there) << "no page says any more: " << text;
    }
    for (const char c : left)
        ASSERT_FALSE(std::isalnum(static_cast<unsigned char>(c)))
            << "no catalogue has: " << left << "\npo4a brings it there: app/manual/README.md";
}

TEST(PageCatalogue, CommandsFilesAndNamesStayInEveryLanguage) {
    for (const std::string& code : codes_in(manual_folder + "/po")) {
        for (const auto& [key, entry] : read_po(manual_folder + "/po/" + code + ".po")) {
            if (key.second.empty()) continue;
            const std::string& said = entry.said.front();
            for (const char* mark : {"`", "**"})
                EXPECT_EQ(spans(said, mark), spans(key.second, mark)) << code << ": " << said;
            EXPECT_EQ(names(said), names(key.second)) << code << ": " << said;
        }
    }
}

TEST(PageCatalogue, ThePagesNameOnlyWhatTheKioskSays) {
    const PoFile words = read_po(words_folder + "/touchline.pot");
    const auto named = quoted_names(page_text("manual.md"));
    EXPECT_GT(named.size(), 5U);
    for (const std::string& name : named) {
        const auto contexts = name_contexts();
        EXPECT_TRUE(std::any_of(contexts.begin(), contexts.end(),
                                [&](const auto& context) {
                                    return words.contains({context, name});
                                }))
            << "the kiosk has no item: " << name;
    }
}

TEST(PageCatalogue, WhatIsNoWordIsFoundInAText) {
    EXPECT_EQ(spans("a `b` and **c** `d", "`"), (std::multiset<std::string>{"b"}));
    EXPECT_EQ(spans("**-h**, **--help**", "**"), (std::multiset<std::string>{"--help", "-h"}));
    EXPECT_EQ(with_single_blanks("  a\n  b \n"), "a b");
}

}  // namespace
}  // namespace touchline
