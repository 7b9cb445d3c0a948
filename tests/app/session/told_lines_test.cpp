// Every line that can reach a visitor has a sentence of its own, in every language.
#include "app/session/told_lines.h"

#include "tests/audio-cues/words/po_file.h"

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

const fs::path source = TOUCHLINE_SOURCE_DIR;

std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Texts between quotes; those that stand side by side, or around a value, are one. Comments and
/// #include lines are none.
std::vector<std::string> literals_in(const std::string& code) {
    static const std::regex comment("//[^\n]*|#include[^\n]*");
    static const std::regex side_by_side("\"\\s*\n\\s*\"");
    static const std::regex quoted("\"((?:[^\"\\\\\n]|\\\\.)*)\"");
    static const std::regex around_a_value("\"\\)?\\s*\\+[^\"]*\\+\\s*\"");
    std::string joined =
        std::regex_replace(std::regex_replace(code, comment, ""), side_by_side, "");
    joined = std::regex_replace(joined, around_a_value, "7");
    std::vector<std::string> all;
    for (std::sregex_iterator at(joined.begin(), joined.end(), quoted), end; at != end; ++at)
        all.push_back((*at)[1]);
    return all;
}

/// Where what a visitor brings is opened, read, traced and built.
std::vector<fs::path> files_of_reasons() {
    std::vector<fs::path> files;
    for (const char* folder : {"app/decode", "app/trace", "app/loading", "app/sticks",
                               "vision/simplify", "vision/prepare", "haptics/curve"})
        for (const auto& entry : fs::directory_iterator(source / folder))
            if (entry.path().extension() == ".cpp") files.push_back(entry.path());
    files.push_back(source / "config/types/map_bytes.cpp");
    files.push_back(source / "app/process/memory.cpp");
    return files;
}

/// They reach the command line alone, or are never told: what reads words or looks for main things
/// leaves a picture as it was.
bool is_of_the_command_line(const fs::path& file) {
    static const std::set<std::string> names{
        "files.cpp",       "png_writer.cpp",     "word_reader.cpp", "words_in_picture.cpp",
        "found_words.cpp", "finding_things.cpp", "main_things.cpp", "import_main.cpp",
        "spacing.cpp"};
    return names.contains(file.filename().string());
}

/// A Result's line: what happened; what to do. What is wrong with an order is the kiosk's own.
bool is_reason(const std::string& literal) {
    const bool is_of_an_order = literal.find("it must be 1 to") != std::string::npos ||
                                literal.find("the kiosk starts it by itself") != std::string::npos;
    return literal.find("; ") != std::string::npos && !is_of_an_order;
}

std::string with_sample_values(std::string pattern) {
    static const std::regex place("\\{[^}]*\\}");
    return std::regex_replace(pattern, place, "7");
}

const PoFile& english() {
    static const PoFile file =
        read_po((source / "audio-cues/words/catalogue/touchline.pot").string());
    return file;
}

constexpr std::string_view unknown = "nobody said why";

std::string told(const std::string& line) {
    return told_of_file(line, unknown, Language());
}

TEST(ToldLines, EveryReasonOfThePicturesSourcesHasASentence) {
    int count = 0;
    for (const fs::path& file : files_of_reasons()) {
        if (is_of_the_command_line(file)) continue;
        for (const std::string& literal : literals_in(text_of(file))) {
            if (!is_reason(literal)) continue;
            ++count;
            const std::string line = with_sample_values(literal);
            EXPECT_NE(told(line), unknown) << file << ": " << line;
        }
    }
    EXPECT_GT(count, 45) << "the sources are read";
}

/// A whole sentence is a text of the catalogue as it is.
TEST(ToldLines, EverySentenceOfThoseSourcesIsInTheCatalogue) {
    int count = 0;
    for (const char* name : {"vision/prepare/capture_trouble.cpp", "app/sticks/stick_rules.cpp"}) {
        for (const std::string& literal : literals_in(text_of(source / name))) {
            if (!literal.ends_with('.') || literal.find(' ') == std::string::npos) continue;
            if (literal.starts_with("No sheet is found")) continue;  // then it is a photograph
            ++count;
            EXPECT_TRUE(english().contains({"trouble", literal})) << literal;
            EXPECT_EQ(told_of_file(literal, picture_trouble, Language()), literal);
        }
    }
    EXPECT_GE(count, 12);
}

TEST(ToldLines, EverySentenceOfTheTablesIsInTheCatalogue) {
    const auto expect = [](std::string_view text) {
        EXPECT_TRUE(english().contains({"trouble", std::string(text)})) << text;
        EXPECT_TRUE(text.ends_with('.')) << text;
        EXPECT_NE(text.find(". "), std::string_view::npos) << "why, and what to do: " << text;
    };
    for (const LineRow& row : file_lines()) expect(row.told);
    for (const LineRow& row : device_lines()) expect(row.told);
    for (const auto text : {picture_trouble, stick_trouble, device_trouble, crowded_picture})
        expect(text);
}

/// A row that another one before it always hides is dead.
TEST(ToldLines, EveryRowIsReached) {
    for (const auto rows : {file_lines(), device_lines()}) {
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (std::size_t before = 0; before < i; ++before)
                EXPECT_EQ(rows[i].part.find(rows[before].part), std::string_view::npos)
                    << rows[i].part << " never comes after " << rows[before].part;
    }
}

/// Nobody should translate what no program says.
TEST(ToldLines, AndFaultsAndTheLiveViewLeaveNoTextUnused) {
    std::set<std::string> literals;
    for (const char* folder : {"app/session", "app/kiosk", "app/loading", "app/main", "app/sticks",
                               "app/trace", "vision/prepare"})
        for (const auto& entry : fs::directory_iterator(source / folder))
            if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h")
                for (const std::string& literal : literals_in(text_of(entry.path())))
                    literals.insert(literal);
    const std::set<std::string> contexts{"event", "contact", "force", "level", "detail", "panel",
                                         "fault", "trouble", "page",  "shape", "mode"};
    for (const auto& [key, entry] : english()) {
        if (contexts.contains(key.first)) {
            EXPECT_TRUE(literals.contains(key.second)) << key.first << ": " << key.second;
        }
    }
}

TEST(ToldLines, AreTheReasonAndNotTheGeneralSentence) {
    EXPECT_EQ(told(": the PNG picture is cut short or damaged (CRC error); copy it again"),
              "The file is damaged. Copy it again, or choose another one.");
    EXPECT_EQ(told(", page 3: the file is empty; copy it again"),
              "The file is empty. Copy it again, or choose another one.");
    EXPECT_EQ(
        told(": the JPEG picture has 99 x 99 pixels, more than 120 megapixels or 8 on a side"),
        "The picture is too large. Save it smaller and bring it again.");
    EXPECT_EQ(told(" cannot be read because the stick was pulled out; put it in again"),
              "The USB stick was pulled out. Put it in again.");
    EXPECT_EQ(told(""), "") << "a stick that was pulled out needs no reason";
    EXPECT_EQ(told("something quite new"), unknown);
    EXPECT_EQ(told("It is too dark here. Ask the staff for more light."),
              "It is too dark here. Ask the staff for more light.");
}

TEST(ToldLines, AreInTheVisitorsLanguage) {
    const auto codes = languages_in(TOUCHLINE_CATALOGUES).value();
    for (const std::string& code : codes) {
        if (code == "en") continue;
        const Language language = Language::load(TOUCHLINE_CATALOGUES, code).value();
        for (const LineRow& row : file_lines()) {
            std::string line(row.part);
            for (auto star = line.find('*'); star != line.npos; star = line.find('*'))
                line.replace(star, 1, "7");
            const std::string words = told_of_file(line, picture_trouble, language);
            EXPECT_NE(words, row.told) << code;
            EXPECT_EQ(words, language.text("trouble", std::string(row.told))) << line;
        }
    }
}

TEST(ToldLines, OfTheDeviceAreSentenceBySentenceWithTheirNumbers) {
    const Language german = Language::load(TOUCHLINE_CATALOGUES, "de").value();
    EXPECT_EQ(
        told_of_device("Not there yet. It is 12 millimetres off. Hold it still there.", german),
        german.text("device", "Not there yet.") + " Der Abstand beträgt noch 12 Millimeter. " +
            german.text("device", "Hold it still there."));
    EXPECT_EQ(told_of_device("The motor on plug 1 did not move the handle.", german),
              german.text("device", "The motor on plug 1 did not move the handle."));
    EXPECT_EQ(told_of_device("", german), "");
    EXPECT_EQ(told_of_device("Quite new.", german),
              german.text("trouble", std::string(device_trouble)));
    EXPECT_EQ(told_of_device("One moment.", Language()), "One moment.");
    EXPECT_EQ(
        told_of_device("homing ended: the board was unplugged or gave up; plug it in", german),
        german.text("trouble", "The handle is unplugged. Please call the staff."));
    EXPECT_EQ(told_of_device("the servo died of signal 11", german),
              german.text("trouble", std::string(device_trouble)));
}

}  // namespace
}  // namespace touchline
