// Tests the words of the visit and what the README says of the requirements, read from the sources.
#include "tests/audio-cues/words/po_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

const std::string root = TOUCHLINE_SOURCE_DIR;

std::string read(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Returns a source's literals; blanks between two join them. Skips comments and includes.
std::vector<std::string> literals_of(const std::string& source) {
    std::vector<std::string> found;
    std::istringstream lines(source);
    bool joins = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("#")) continue;
        for (std::size_t at = 0; at < line.size(); ++at) {
            if (line.compare(at, 2, "//") == 0) break;
            if (line[at] != '"') {
                joins = joins && std::isspace(static_cast<unsigned char>(line[at])) != 0;
                continue;
            }
            const std::size_t end = line.find('"', at + 1);
            const std::string text = line.substr(at + 1, end - at - 1);
            if (joins) {
                found.back() += text;
            } else {
                found.push_back(text);
            }
            joins = true;
            at = end;
        }
    }
    return found;
}

TEST(VisitWords, EveryTextInTheSourcesIsInTheCatalogue) {
    std::set<std::string> known;
    std::set<std::string> contexts;
    for (const auto& [key, entry] : read_po(root + "/audio-cues/words/catalogue/touchline.pot")) {
        known.insert(key.second);
        known.insert(entry.plural);
        contexts.insert(key.first);
    }
    std::size_t count = 0;
    for (const auto& file : std::filesystem::directory_iterator(root + "/app/visit")) {
        const std::string name = file.path().filename().string();
        if (!name.starts_with("visit") || file.path().extension() != ".cpp") continue;
        for (const std::string& text : literals_of(read(file.path()))) {
            if (contexts.contains(text) || text.size() < 3) continue;
            EXPECT_TRUE(known.contains(text)) << name << ": " << text;
            ++count;
        }
    }
    EXPECT_GT(count, 180U);
    EXPECT_EQ(literals_of("a(\"One \"\n  \"two\", \"three\");  // \"four\""),
              (std::vector<std::string>{"One two", "three"}));
}

/// LA-2: the catalogue's rules hold for all texts; this tests that the visit has no others.
TEST(Visit, LA2_TextsOfTheVisitAreThoseOfTheCatalogueAndShort) {
    std::size_t count = 0;
    for (const auto& [key, entry] : read_po(root + "/audio-cues/words/catalogue/touchline.pot")) {
        if (key.first != "visit") continue;
        ++count;
        std::istringstream stream(key.second);
        std::size_t words = 0;
        for (std::string word; stream >> word;) {
            ++words;
            EXPECT_LE(words, 15U) << key.second;
            const bool is_end = word.back() == '.' || word.back() == '?';
            if (is_end) words = 0;
        }
    }
    EXPECT_GT(count, 180U);
}

/// Returns rows such as "| SP-1 | Visit.SP1_... |" of the README's table.
std::vector<std::pair<std::string, std::string>> conformance_rows() {
    std::vector<std::pair<std::string, std::string>> rows;
    std::istringstream lines(read(root + "/app/visit/README.md"));
    bool is_table = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("## ")) is_table = line == "## Conformance";
        if (!is_table || !line.starts_with("| ") || line.find('-') == std::string::npos) continue;
        const std::size_t bar = line.find(" | ");
        const std::size_t end = line.rfind(" |");
        rows.emplace_back(line.substr(2, bar - 2), line.substr(bar + 3, end - bar - 3));
    }
    return rows;
}

TEST(VisitWords, EveryRequirementOfTheReadmeHasItsTest) {
    std::string tests;
    for (const auto& file : std::filesystem::directory_iterator(root + "/tests/app/visit")) {
        if (!file.is_regular_file()) continue;
        if (file.path().extension() == ".cpp") tests += read(file.path());
    }
    std::set<std::string> ids;
    for (const auto& [id, names] : conformance_rows()) {
        ids.insert(id);
        std::istringstream list(names);
        std::size_t count = 0;
        for (std::string name; list >> name;) {
            name.erase(std::remove_if(name.begin(), name.end(),
                                      [](char c) { return c == '`' || c == ','; }),
                       name.end());
            const std::size_t dot = name.find('.');
            ASSERT_NE(dot, std::string::npos) << name;
            const std::string head =
                "TEST(" + name.substr(0, dot) + ", " + name.substr(dot + 1) + ")";
            EXPECT_NE(tests.find(head), std::string::npos) << id << ": " << name;
            ++count;
        }
        EXPECT_GT(count, 0U) << id;
    }
    for (const char* id :
         {"SP-1", "SP-2", "SP-3", "SP-5", "SP-7", "SP-9", "SP-10", "VO-2", "VO-5", "IN-1", "IN-2",
          "IN-3", "IN-5", "IN-6", "IN-7", "VI-5", "VI-7", "TI-1",  "TI-2", "TI-3", "TI-5", "TI-6",
          "ER-1", "ER-2", "ER-3", "ER-4", "LA-1", "LA-2", "HA-1",  "HA-4", "HA-5"}) {
        EXPECT_TRUE(ids.contains(id)) << id;
    }
}

/// Conversely, every test that names a requirement is in the table.
TEST(VisitWords, EveryTestThatNamesARequirementIsInTheReadme) {
    const std::string readme = read(root + "/app/visit/README.md");
    for (const auto& file : std::filesystem::directory_iterator(root + "/tests/app/visit")) {
        if (!file.is_regular_file()) continue;
        const std::string source = read(file.path());
        for (std::size_t at = source.find("TEST(Visit, "); at != std::string::npos;
             at = source.find("TEST(Visit, ", at + 1)) {
            const std::size_t begin = at + 12;
            const std::string name = source.substr(begin, source.find(')', begin) - begin);
            const std::size_t line = name.find('_');
            const bool names_one = line != std::string::npos && line >= 3 && line <= 5 &&
                                   std::isdigit(static_cast<unsigned char>(name[line - 1])) != 0;
            if (!names_one) continue;
            EXPECT_NE(readme.find("`Visit." + name + "`"), std::string::npos) << name;
        }
    }
}

}  // namespace
}  // namespace touchline
