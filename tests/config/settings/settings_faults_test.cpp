// Tests that all faults of a settings file are reported at once, each with its line.
#include "config/settings/settings_text.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

using Lines = std::vector<std::string>;

const Lines& shipped_languages() {
    static const Lines codes{"de", "en", "es", "fr", "it"};
    return codes;
}

Lines faults_of(std::string_view text) {
    return settings_faults(text, "f", SettingLayer::site, shipped_languages());
}

/// Returns the lines that the faults name, as "2 4".
std::string lines_of(std::string_view text) {
    std::string lines;
    for (const std::string& fault : faults_of(text)) {
        const std::string number = fault.substr(2, fault.find(':', 2) - 2);
        lines += (lines.empty() ? "" : " ") + number;
    }
    return lines;
}

TEST(SettingsFaults, OfAGoodFileAreNone) {
    for (const std::string text :
         {"", "\n", "[feel]", "[feel]\nstiffness_N_per_m = 400", "\xef\xbb\xbf[feel]\n",
          "[feel]\r\nstiffness_N_per_m = 400\r\n", "[picture]\ndetail = 3.0\n", "feel.friction = 1",
          "[care]\nnotice = \"\"\"Closed.\"\"\"\n",
          "[language]\noffered = \"fr de\"\nfirst = 'fr'"})
        EXPECT_EQ(faults_of(text), Lines{}) << text;
    EXPECT_EQ(faults_of(settings_text(Settings{})), Lines{});
}

TEST(SettingsFaults, AreAllToldInTheOrderOfTheirLines) {
    const Lines told = faults_of(
        "[feel]\n"
        "stifness = 5\n"
        "friction = 7\n"
        "mode = groove\n"
        "stiffness_N_per_m = 400,5\n"
        "capture_mm = 3\n"
        "[sounds]\n"
        "amount = 1\n"
        "[picture]\n"
        "detail = \"3\"\n"
        "detail = 4\n");
    ASSERT_EQ(told.size(), 7U);
    EXPECT_EQ(told[0], "f:2: 'feel.stifness' is not a setting");
    EXPECT_EQ(told[1], "f:3: 'feel.friction' must be a number from 0 to 1");
    EXPECT_TRUE(told[2].starts_with("f:4: ")) << told[2];
    EXPECT_TRUE(told[3].starts_with("f:5: ")) << told[3];
    EXPECT_EQ(told[4], "f:7: 'sounds' is no table of settings");
    EXPECT_EQ(told[5], "f:10: 'picture.detail' must be a whole number from 1 to 5");
    EXPECT_TRUE(told[6].starts_with("f:11: ")) << told[6];
}

TEST(SettingsFaults, EachHasItsLine) {
    EXPECT_EQ(lines_of("[feel]\nstiffness_N_per_m = \"400\"\n"), "2");
    EXPECT_EQ(lines_of("[feel]\nstiffness_N_per_m = 99999999999999999999999\n"), "2");
    EXPECT_EQ(lines_of("[feel]\nfriction = nan\n"), "2");
    EXPECT_EQ(lines_of("[feel]\nfriction = 1e23\n"), "2");
    EXPECT_EQ(lines_of("[feel]\nmode = \"wall\"\nmode = \"groove\"\n"), "3");
    EXPECT_EQ(lines_of("[feel]\nmode = \"wall\nfriction = 7\n"), "2 3");
    EXPECT_EQ(lines_of("[feel\nfriction = 7\n"), "1 2");
    EXPECT_EQ(lines_of("feel]\n[picture]\ndetail = 9\n"), "1 3");
    EXPECT_EQ(lines_of("[feel]\nfriction 0.5\nfriction = = 1\nfriction =\nx\n"), "2 3 4 5");
    EXPECT_EQ(lines_of("[feel]\nfriction = 0.5\n[picture]\n[feel]\nfriction = 0.6\nmode = 1\n"),
              "4 5 6");
    EXPECT_EQ(lines_of("[language]\noffered = [\n'en'\nfirst = 'en'\n"), "2 3");
    EXPECT_EQ(lines_of("[care]\nnotice = \"\"\"Closed\n[feel]\nfriction = 3\n"), "2 4");
    EXPECT_EQ(lines_of("[care]\nnotice = \"caf\xe9\"\n[feel]\nfriction = 3\n"), "2 4");
    EXPECT_EQ(lines_of(std::string("[feel]\nfriction = \0"
                                   "1\nmode = 3\n",
                                   28)),
              "2 3");
    EXPECT_EQ(lines_of("[feel]\rfriction = 1\r"), "1");
    EXPECT_EQ(lines_of("[levels]\nfinest = 5\ncoarsest = 4\n[language]\nfirst = 'xx'\n"), "3 5");
    EXPECT_EQ(lines_of("[feel]\nfriction = 9" + std::string(500'000, '0') + "\nmode = 2"), "2 3");
}

TEST(SettingsFaults, ALanguageThatNobodyHasIsOne) {
    EXPECT_EQ(faults_of("[language]\noffered = \"de fr xx\"\nfirst = \"de\"\n"),
              Lines{"f:2: 'language.offered': there are no words of 'xx'; there are those of "
                    "de en es fr it"});
    EXPECT_EQ(settings_faults("[language]\noffered = 'en xx'", "f", SettingLayer::site, {}),
              Lines{});
}

TEST(SettingsFaults, OfOtherEncodingsIsOneLineThatSaysWhatToDo) {
    const std::string utf16("\xff\xfe[\0f\0", 6);
    for (const std::string& text : {utf16, std::string("\xfe\xff\0[\0f", 6), utf16.substr(2)})
        EXPECT_EQ(faults_of(text),
                  Lines{"f:1: this is UTF-16, or no text at all; save it as UTF-8"});
    EXPECT_EQ(faults_of(std::string(2'000'000, '#')),
              Lines{"f: is larger than 1 MB; no file of settings is"});
}

TEST(SettingsFaults, AreAHundredAtMost) {
    std::string text = "[feel]\n";
    for (int i = 0; i < 500; ++i) text += "a" + std::to_string(i) + " = 1\n";
    EXPECT_EQ(faults_of(text).size(), 101U);
    EXPECT_EQ(faults_of(text).back(), "f: there is more; correct these first");
    std::string broken;
    for (int i = 0; i < 500; ++i) broken += "= 1\n";
    EXPECT_GE(faults_of(broken).size(), 100U);
}

/// The kiosk reports the first fault; there are none if it accepts the file.
RC_GTEST_PROP(SettingsFaults, AreThereWhereTheKioskRefusesAndNowhereElse, ()) {
    std::string text = settings_text(Settings{});
    const int changes = *rc::gen::inRange(0, 6);
    for (int i = 0; i < changes && !text.empty(); ++i) {
        const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
        const int what = *rc::gen::inRange(0, 3);
        if (what == 0) text[at] = *rc::gen::arbitrary<char>();
        if (what == 1) text.erase(at, *rc::gen::inRange<std::size_t>(1, 40));
        if (what == 2) text.insert(at, text.substr(at, 20));
    }
    const auto settings = apply_settings({}, text, "f", SettingLayer::site);
    const Lines faults = settings_faults(text, "f", SettingLayer::site, {});
    RC_ASSERT(faults.empty() == settings.has_value());
    for (const std::string& fault : faults) {
        RC_ASSERT(fault.starts_with("f:"));
        RC_ASSERT(fault.find('\n') == std::string::npos);
    }
}

/// Spoils values in some lines of a good file: exactly those lines are reported.
RC_GTEST_PROP(SettingsFaults, NameTheLinesThatWereSpoiled, ()) {
    Lines lines;
    std::string line;
    for (const char c : settings_text(Settings{})) {
        if (c != '\n') {
            line += c;
            continue;
        }
        lines.push_back(std::exchange(line, {}));
    }
    std::string wanted;
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::size_t sign = lines[i].find(" = ");
        const bool is_key = sign != std::string::npos && lines[i][0] != '#';
        if (is_key && *rc::gen::inRange(0, 5) == 0) {
            lines[i] = lines[i].substr(0, sign) +
                       *rc::gen::elementOf(Lines{" = nan", " = [1]", " = 'x", " = 1,5", " =", " 5",
                                                 " = 1e301", "2 = 1", " = {", " = ["});
            wanted += (wanted.empty() ? "" : " ") + std::to_string(i + 1);
        }
        text += lines[i] + '\n';
    }
    // A missing value may bring two others into conflict.
    Lines told = settings_faults(text, "f", SettingLayer::site, {});
    std::erase_if(told, [](const std::string& fault) {
        return fault.find("must be one of '") != std::string::npos ||
               fault.find("must not be above") != std::string::npos;
    });
    std::string found;
    for (const std::string& fault : told)
        found += (found.empty() ? "" : " ") + fault.substr(2, fault.find(':', 2) - 2);
    RC_ASSERT(found == wanted);
}

}  // namespace
}  // namespace touchline
