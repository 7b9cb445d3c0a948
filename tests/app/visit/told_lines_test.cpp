// Tests that every line that can reach a visitor has its own sentence, in every language.
#include "app/visit/told_lines.h"

#include "app/visit/status.h"
#include "tests/audio-cues/words/po_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
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

/// Joins texts that stand side by side or around a value, and drops comments and #include lines.
std::string joined(const std::string& code) {
    static const std::regex comment("//[^\n]*|#include[^\n]*");
    static const std::regex side_by_side("\"\\s*\n\\s*\"");
    static const std::regex around_a_value("\"\\)?\\s*\\+[^\"]*\\+\\s*\"");
    const std::string told = std::regex_replace(code, comment, "");
    return std::regex_replace(std::regex_replace(told, side_by_side, ""), around_a_value, "7");
}

/// Returns the texts between quotes of joined code.
std::vector<std::string> quoted_in(const std::string& code) {
    static const std::regex quoted("\"((?:[^\"\\\\\n]|\\\\.)*)\"");
    std::vector<std::string> all;
    for (std::sregex_iterator at(code.begin(), code.end(), quoted), end; at != end; ++at)
        all.push_back((*at)[1]);
    return all;
}

std::vector<std::string> literals_in(const std::string& code) {
    return quoted_in(joined(code));
}

/// Returns where the parenthesis that opens before `at` closes.
std::size_t closing(const std::string& code, std::size_t at) {
    bool is_quoted = false;
    for (int depth = 1; at < code.size(); ++at) {
        const char sign = code[at];
        if (sign == '\\') ++at;
        if (sign == '"') is_quoted = !is_quoted;
        if (is_quoted) continue;
        depth += (sign == '(' ? 1 : 0) - (sign == ')' ? 1 : 0);
        if (depth == 0) return at;
    }
    return at;
}

/// Returns the joined texts of each call of failure(). Skips calls with only a name.
std::vector<std::string> failures_in(const std::string& code) {
    static const std::string call = "failure(";
    const std::string whole = joined(code);
    std::vector<std::string> all;
    for (std::size_t at = 0; (at = whole.find(call, at)) != std::string::npos;) {
        at += call.size();
        std::string line;
        for (const std::string& text : quoted_in(whole.substr(at, closing(whole, at) - at)))
            line += text;
        if (line.find_first_not_of(" :") != std::string::npos) all.push_back(line);
    }
    return all;
}

/// Returns the sources that open, read, trace and build what a visitor brings.
std::vector<fs::path> files_of_reasons() {
    std::vector<fs::path> files;
    for (const char* folder :
         {"app/documents/decode", "app/documents/trace", "app/kiosk/loading",
          "app/documents/sticks", "vision/simplify", "vision/prepare", "haptics/curve"})
        for (const auto& entry : fs::directory_iterator(source / folder))
            if (entry.path().extension() == ".cpp") files.push_back(entry.path());
    files.push_back(source / "config/types/map_bytes.cpp");
    files.push_back(source / "app/isolation/process/memory.cpp");
    return files;
}

/// Their lines reach only the command line, or nobody: code that reads words or looks for main
/// things leaves a picture as it was if it fails.
bool is_of_the_command_line(const fs::path& file) {
    static const std::set<std::string> names{
        "files.cpp",       "png_writer.cpp",     "word_reader.cpp", "words_in_picture.cpp",
        "found_words.cpp", "finding_things.cpp", "main_things.cpp", "import_main.cpp",
        "spacing.cpp",     "simplify.cpp",       "figure_main.cpp"};
    return names.contains(file.filename().string());
}

/// A bad order is the kiosk's own fault; a bad shape becomes part of the map's line; an SVG that is
/// not one of our maps is a picture.
bool is_told_to_nobody(const std::string& line) {
    static const std::array parts{"it must be 1 to",
                                  "the kiosk starts it by itself",
                                  "what the kiosk starts it with",
                                  "must be between 1 mm and 1 m",
                                  "at character ",
                                  "is no finite length",
                                  "is a picture, no map"};
    return std::ranges::any_of(
        parts, [&line](const char* part) { return line.find(part) != std::string::npos; });
}

/// Ends that somebody wanted, orders that no kiosk gives, and parts of lines that are told whole.
bool is_told_to_no_person(const std::string& line) {
    static const std::array parts{"nobody wants the Inverse3",
                                  "what the kiosk starts it with",
                                  "numbers are out of range",
                                  "did not confirm that",
                                  "see device.port",
                                  "not tried",
                                  " stopped with "};
    return std::ranges::any_of(
        parts, [&line](const char* part) { return line.find(part) != std::string::npos; });
}

/// Returns the lines of a Result: the arguments of failure(), and what happened and what to do.
std::vector<std::string> reasons_in(const std::string& code) {
    std::vector<std::string> reasons = failures_in(code);
    for (const std::string& literal : literals_in(code))
        if (literal.find("; ") != std::string::npos) reasons.push_back(literal);
    std::erase_if(reasons, is_told_to_nobody);
    return reasons;
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
        for (const std::string& reason : reasons_in(text_of(file))) {
            ++count;
            const std::string line = with_sample_values(reason);
            EXPECT_NE(told(line), unknown) << file << ": " << line;
        }
    }
    EXPECT_GT(count, 100) << "the sources are read";
}

TEST(ToldLines, AFailureIsReadWithOrWithoutWhatToDo) {
    EXPECT_EQ(failures_in("return failure(name + \": \" + why(\")\") + \"gone\");"),
              std::vector<std::string>{": )gone"});
    EXPECT_EQ(failures_in("failure(std::string(line)); failure(\"one \"\n  \"page\")"),
              std::vector<std::string>{"one page"});
    EXPECT_EQ(told("what came is no shared memory of a fixed size"), told("no sealed memory"));
}

/// "*" matches anything.
bool holds(const std::string& line, std::string_view part) {
    std::size_t at = 0;
    for (std::size_t star = 0; star != std::string_view::npos;) {
        star = part.find('*');
        at = line.find(part.substr(0, star), at);
        if (at == std::string::npos) return false;
        at += std::min(star, part.size());
        if (star != std::string_view::npos) part.remove_prefix(star + 1);
    }
    return true;
}

/// What controllers, ports and services say of themselves: what is wrong, a colon, what to do.
TEST(ToldLines, EveryTroubleOfADeviceHasASentenceForTheStaff) {
    int count = 0;
    for (const char* name :
         {"haptics/device/moteus/moteus_words.cpp", "haptics/device/odrive/odrive_words.cpp",
          "haptics/device/inverse3/inverse3_session.cpp",
          "haptics/device/inverse3/inverse3_service.cpp", "haptics/device/moteus/can_socket.cpp",
          "haptics/device/serial/serial_port.cpp", "app/force/servo/inverse3_arm.cpp",
          "app/force/servo/motors_device.cpp"}) {
        const std::string code = text_of(source / name);
        std::vector<std::string> lines = failures_in(code);
        const bool has_halves = code.find("could not be opened: ") != std::string::npos;
        for (const std::string& literal : literals_in(code))
            if (!has_halves && literal.find(": ") != std::string::npos) lines.push_back(literal);
        std::erase_if(lines, is_told_to_no_person);
        for (const std::string& pattern : lines) {
            ++count;
            const std::string line = with_sample_values(pattern);
            EXPECT_NE(told_of_device(line, Language(), ToldTo::staff), staffs_device_trouble)
                << name << ": " << line;
        }
    }
    EXPECT_GT(count, 40) << "the sources are read";
}

/// A row is dead if no program gives its line any more.
TEST(ToldLines, EveryRowIsOfALineInASource) {
    std::vector<fs::path> files = files_of_reasons();
    for (const char* folder : {"app/force", "haptics/device", "vision/camera"})
        for (const auto& entry : fs::recursive_directory_iterator(source / folder))
            if (!entry.is_directory()) files.push_back(entry.path());
    std::vector<std::string> lines;
    for (const fs::path& file : files)
        for (const std::string& literal : literals_in(text_of(file))) lines.push_back(literal);
    for (const auto rows : {file_lines(), device_lines()}) {
        for (const LineRow& row : rows) {
            EXPECT_TRUE(std::ranges::any_of(lines, [&row](const std::string& line) {
                return holds(line, row.part);
            })) << row.part;
        }
    }
}

/// The catalogue has each whole sentence as it is.
TEST(ToldLines, EverySentenceOfThoseSourcesIsInTheCatalogue) {
    int count = 0;
    for (const char* name :
         {"vision/prepare/document.cpp", "app/documents/sticks/mount_rules.cpp"}) {
        for (const std::string& literal : literals_in(text_of(source / name))) {
            if (!literal.ends_with('.') || literal.find(' ') == std::string::npos) continue;
            if (literal.starts_with("No sheet is found")) continue;  // then it is a photograph
            ++count;
            EXPECT_TRUE(english().contains({"trouble", literal})) << literal;
            EXPECT_EQ(told_of_file(literal, picture_trouble, Language()), literal);
        }
    }
    EXPECT_GE(count, 11);
}

TEST(ToldLines, EverySentenceOfTheTablesIsInTheCatalogue) {
    const auto expect = [](std::string_view text) {
        EXPECT_TRUE(english().contains({"trouble", std::string(text)})) << text;
        EXPECT_TRUE(text.ends_with('.')) << text;
        EXPECT_NE(text.find(". "), std::string_view::npos) << "why, and what to do: " << text;
    };
    for (const auto rows : {file_lines(), device_lines()}) {
        for (const LineRow& row : rows) {
            expect(row.told);
            if (!row.staff_told.empty()) expect(row.staff_told);
        }
    }
    for (const auto text :
         {picture_trouble, stick_trouble, device_trouble, staffs_device_trouble, crowded_picture})
        expect(text);
}

TEST(ToldLines, EachEndOfASheetHasASentenceForVisitorsAndOneForTheStaff) {
    for (int i = 1; i < print_end_count; ++i) {
        for (const ToldTo to : {ToldTo::visitor, ToldTo::staff}) {
            const std::string told = told_of_print(static_cast<PrintEnd>(i), Language(), to);
            EXPECT_TRUE(english().contains({"trouble", told})) << told;
            EXPECT_NE(told.find(". "), std::string::npos) << "why, and what to do: " << told;
            const bool names_staff = told.find("staff") != std::string::npos;
            EXPECT_FALSE(to == ToldTo::staff && names_staff) << told;
        }
    }
}

bool calls_the_staff(std::string_view text) {
    return text.ends_with("all the staff.");
}

/// The staff cannot call themselves: they hear what to do.
TEST(ToldLines, TellTheStaffWhatToDoWhereAVisitorCallsThem) {
    int count = 0;
    for (const auto rows : {file_lines(), device_lines()}) {
        for (const LineRow& row : rows) {
            EXPECT_EQ(calls_the_staff(row.told), !row.staff_told.empty()) << row.told;
            EXPECT_EQ(row.staff_told.find("staff"), std::string_view::npos) << row.staff_told;
            count += row.staff_told.empty() ? 0 : 1;
        }
    }
    EXPECT_GT(count, 12);
    const Language language;
    EXPECT_EQ(told_of_device("no board is plugged in at 1-4", language, ToldTo::staff),
              "The handle is unplugged. Plug its cable in again.");
    EXPECT_EQ(told_of_device("the servo died of signal 11", language, ToldTo::staff),
              staffs_device_trouble);
    EXPECT_EQ(told_of_file("what came is no sealed memory", unknown, language, ToldTo::staff),
              "The file cannot be read. Copy it to the USB stick again.");
    EXPECT_EQ(told_of_file("the file is empty; copy it again", unknown, language, ToldTo::staff),
              told("the file is empty; copy it again"));
}

/// A row is dead if an earlier one always hides it.
TEST(ToldLines, EveryRowIsReached) {
    for (const auto rows : {file_lines(), device_lines()}) {
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (std::size_t before = 0; before < i; ++before)
                EXPECT_EQ(rows[i].part.find(rows[before].part), std::string_view::npos)
                    << rows[i].part << " never comes after " << rows[before].part;
    }
}

/// Nobody should translate text that no program says.
TEST(ToldLines, AndFaultsAndTheLiveViewLeaveNoTextUnused) {
    std::set<std::string> literals;
    for (const char* folder : {"app/visit", "app/kiosk", "app/kiosk/loading", "app/main",
                               "app/documents/sticks", "app/documents/trace", "vision/prepare"})
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

TEST(FaultWords, EveryFaultSaysWhyAndWhatToDo) {
    std::set<std::string_view> reasons;
    for (std::size_t i = 1; i < fault_count; ++i) {
        const auto fault = static_cast<Fault>(i);
        const FaultWords words = words_of(fault);
        for (const auto sentence : {words.why, words.visitor_does, words.staff_does}) {
            ASSERT_FALSE(sentence.empty()) << i;
            EXPECT_EQ(sentence.back(), '.') << sentence;
        }
        reasons.insert(words.why);
        EXPECT_EQ(spoken_fault(fault, Language()), "The force is off. " + std::string(words.why) +
                                                       ' ' + std::string(words.visitor_does));
    }
    EXPECT_EQ(reasons.size(), fault_count - 1);
    EXPECT_EQ(spoken_fault(Fault::none, Language()), "");
    EXPECT_EQ(staffs_fault(Fault::none, Language()), "");
}

TEST(FaultWords, EveryStateHasItsOwn) {
    std::set<std::string_view> words;
    for (std::size_t i = 0; i < force_state_count; ++i)
        words.insert(words_of(static_cast<ForceState>(i)));
    EXPECT_EQ(words.size(), force_state_count);
    EXPECT_FALSE(words.contains(""));
}

}  // namespace
}  // namespace touchline
