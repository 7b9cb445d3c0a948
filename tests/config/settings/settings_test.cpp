// Tests the table of settings, and settings as text: every row, every wrong value, any bytes.
#include "config/settings/setting_rows.h"
#include "config/settings/settings_text.h"

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

std::string read(const std::string& name) {
    std::ifstream in(std::string(TOUCHLINE_SOURCE_DIR) + '/' + name);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string full_key(const SettingRow& row) {
    return std::string(row.table) + '.' + std::string(row.key);
}

std::string error_of(const std::string& text, SettingLayer layer = SettingLayer::site) {
    const auto settings = apply_settings({}, text, "site.toml", layer);
    return settings ? "no error" : settings.error().line;
}

/// The table as config/README.md shows it.
std::string settings_as_markdown() {
    constexpr std::array<std::string_view, 4> layers{"program", "site", "profile", "session"};
    const Settings defaults;
    std::string text =
        "| setting | allowed | at first | up to | of | what it does |\n|---|---|---|---|---|---|\n";
    for (const SettingRow& row : setting_rows()) {
        text += "| `" + std::string(row.table) + '.' + std::string(row.key) + "` | " +
                allowed_values(row) + " | " + value_in_words(defaults, row) + " | " +
                std::string(layers[static_cast<std::size_t>(row.last_layer)]) + " | " +
                (row.owner == SettingOwner::house ? "house" : "kiosk") + " | " +
                std::string(row.name) + ": " + std::string(row.help) + " |\n";
    }
    return text;
}

TEST(SettingRows, HaveNamesThatAreTheirOwnAndTextsForTheEar) {
    std::set<std::string> keys;
    std::set<std::string_view> names;
    for (const SettingRow& row : setting_rows()) {
        EXPECT_TRUE(keys.insert(full_key(row)).second) << full_key(row);
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_TRUE(row.help.ends_with('.')) << row.help;
        EXPECT_FALSE(allowed_values(row).empty());
        EXPECT_FALSE(value_in_words({}, row).empty());
    }
}

TEST(SettingRows, OfATableAreNeighbours) {
    std::set<std::string_view> ended;
    std::string_view table;
    for (const SettingRow& row : setting_rows()) {
        const bool is_next = row.table == table || ended.insert(row.table).second;
        EXPECT_TRUE(is_next) << row.table;
        table = row.table;
    }
}

/// The defaults are allowed, and no row leaves a member out.
TEST(SettingRows, TakeBackWhatTheySay) {
    for (const SettingRow& row : setting_rows()) {
        const auto same = with_value(Settings{}, row, value_of(Settings{}, row));
        ASSERT_TRUE(same.has_value()) << full_key(row);
        EXPECT_EQ(*same, Settings{});
    }
    EXPECT_TRUE(conflicts(Settings{}).empty());
}

TEST(SettingRows, NoNumberPassesItsRange) {
    for (const SettingRow& row : setting_rows()) {
        if (!std::holds_alternative<double>(value_of({}, row))) continue;
        const auto& [least, most, step] = row.range;
        ASSERT_LT(least, most) << full_key(row);
        ASSERT_GT(step, 0.0);
        EXPECT_TRUE(with_value({}, row, least));
        EXPECT_TRUE(with_value({}, row, most));
        for (const double value : {std::nextafter(least, -1e9), std::nextafter(most, 1e9),
                                   std::numeric_limits<double>::quiet_NaN(),
                                   std::numeric_limits<double>::infinity(), -1e300})
            EXPECT_FALSE(with_value({}, row, value)) << full_key(row) << ' ' << value;
        EXPECT_FALSE(with_value({}, row, true));
        EXPECT_FALSE(with_value({}, row, std::string("5")));
    }
}

TEST(SettingRows, ChoicesAndSwitchesTakeNothingElse) {
    for (const SettingRow& row : setting_rows()) {
        if (row.choices.empty() && !std::holds_alternative<bool>(value_of({}, row))) continue;
        EXPECT_FALSE(with_value({}, row, 1.0)) << full_key(row);
        EXPECT_FALSE(with_value({}, row, std::string("no such"))) << full_key(row);
    }
}

void expect_texts(const char* table, const char* key, const std::vector<std::string>& allowed,
                  const std::vector<std::string>& refused) {
    const SettingRow& row = *find_setting(table, key);
    for (const std::string& text : allowed) EXPECT_TRUE(with_value({}, row, text)) << text;
    for (const std::string& text : refused) EXPECT_FALSE(with_value({}, row, text)) << text;
}

TEST(SettingRows, TextsAreOfTheirKind) {
    expect_texts("operator", "device", {"", "/dev/input/by-id/kbd-event"},
                 {"/dev/sda", "/dev/input/", "/dev/input/../sda", "kbd"});
    expect_texts("hours", "opening", {"09:00-17:00", "22:00-06:30", "00:00-24:00"},
                 {"", "9:00-17:00", "09:00-09:00", "09:60-10:00", "25:00-26:00", "24:00-09:00",
                  "09:00-00:00", "09:00 17:00", "09:00-17:00 "});
    expect_texts("hours", "quiet", {"", "18:00-22:00"}, {"never", "18:00-"});
    expect_texts("language", "offered", {"en", "en de", "de fr en gsw"},
                 {"", "en en", "EN", "en  de", " en", "en ", "english", "en,de",
                  "aa bb cc dd ee ff gg hh ii jj kk ll mm nn oo pp qq"});
    expect_texts("language", "first", {"en", "de"}, {"", "e", "en de"});
    expect_texts("profile", "use", {"", "child", "class-3"}, {"../child", "Child", "a b"});
    expect_texts("print", "printer", {"", "swell-paper_2", "Drucker"},
                 {"a b", "a/b", "a#b", "a\nb", std::string(128, 'a')});
    expect_texts("device", "port", {"", "/dev/ttyACM0", "/dev/serial/by-id/usb-1", "can0"},
                 {"/dev/", "/etc/passwd", "/dev/../etc/passwd", "a b", "a/b", "a:b", "a\nb",
                  std::string(16, 'a')});
    expect_texts("care", "notice", {"", "Zurück um zwei."}, {"a\nb", std::string(201, 'a')});
}

TEST(SettingRows, HoursCanGoPastMidnight) {
    const HoursOfDay day = *hours_in("09:00-17:00");
    EXPECT_FALSE(is_within(day, 539));
    EXPECT_TRUE(is_within(day, 540));
    EXPECT_TRUE(is_within(day, 1019));
    EXPECT_FALSE(is_within(day, 1020));
    const HoursOfDay night = *hours_in("22:00-06:00");
    for (const int minute : {0, 359, 1320, 1439}) EXPECT_TRUE(is_within(night, minute)) << minute;
    for (const int minute : {360, 720, 1319}) EXPECT_FALSE(is_within(night, minute)) << minute;
    for (const char* text : {"09:00-17:00", "22:00-06:30", "00:00-24:00"})
        EXPECT_EQ(hours_text(*hours_in(text)), text);
}

TEST(SettingsText, NoProfileRaisesTheCeilingOfTheForce) {
    Settings site;
    site.force_ceiling_N = 2.0;
    const auto with = [&](const char* text, SettingLayer layer) {
        return apply_settings(site, text, "f", layer);
    };
    const auto raised = with("[feel]\nforce_ceiling_N = 2.5", SettingLayer::profile);
    ASSERT_FALSE(raised);
    EXPECT_EQ(raised.error().line, "f:2: 'feel.force_ceiling_N' must not be above the site's 2");
    EXPECT_TRUE(with("[feel]\nforce_ceiling_N = 1.5", SettingLayer::profile));
    EXPECT_TRUE(with("[feel]\nforce_ceiling_N = 3", SettingLayer::site));
    EXPECT_FALSE(with("[feel]\nforce_ceiling_N = 3.1", SettingLayer::site)) << "no file passes it";
}

TEST(SettingRows, APathIsWholeOrNone) {
    const SettingRow& row = *find_setting("stick", "watched_folder");
    EXPECT_TRUE(with_value({}, row, std::string("/srv/pictures of today")));
    for (const std::string& text :
         {std::string("pictures"), std::string("../x"), std::string("/a\0b", 4),
          std::string("/a\nb"), '/' + std::string(5000, 'a')})
        EXPECT_FALSE(with_value({}, row, text));
}

/// Steps up end at the top, steps down at the bottom, and never leave the range.
TEST(SettingRows, StepsComeToBothEnds) {
    for (const SettingRow& row : setting_rows()) {
        const SettingValue first = value_of({}, row);
        if (std::holds_alternative<std::string>(first) && row.choices.empty()) continue;
        Settings settings;
        for (int i = 0; i < 1000; ++i) settings = stepped(settings, row, false);
        std::set<std::string> heard;
        for (int i = 0; i < 1000; ++i) {
            heard.insert(value_in_words(settings, row));
            settings = stepped(settings, row, true);
        }
        const bool is_switch = std::holds_alternative<bool>(first);
        const double steps = (row.range.most - row.range.least) / row.range.step;
        const std::size_t wanted = is_switch ? 2
                                   : row.choices.empty()
                                       ? static_cast<std::size_t>(std::lround(steps)) + 1
                                       : row.choices.size();
        EXPECT_EQ(heard.size(), wanted) << full_key(row);
    }
}

TEST(SettingRows, AStepComesBack) {
    for (const SettingRow& row : setting_rows()) {
        const Settings up = stepped({}, row, true);
        if (up == Settings{}) continue;  // it is at its end
        EXPECT_EQ(value_in_words(stepped(up, row, false), row), value_in_words({}, row))
            << full_key(row);
    }
}

TEST(SettingsText, WhatIsInstalledIsWhatHoldsAtFirst) {
    const std::string installed = read("config/defaults/kiosk.toml");
    EXPECT_EQ(installed, settings_text(Settings{}))
        << "the file is `touchline settings print`, unchanged";
    EXPECT_EQ(apply_settings({}, installed, "kiosk.toml", SettingLayer::site), Settings{});
}

TEST(SettingsText, TheReferencePageIsTheTable) {
    EXPECT_NE(read("config/README.md").find(settings_as_markdown()), std::string::npos)
        << settings_as_markdown();
}

TEST(SettingsText, OnlyWhatIsSetIsChanged) {
    const auto settings = apply_settings({}, "[feel]\nfriction = 0.25\nmode = \"wall\"\n", "f",
                                         SettingLayer::session);
    ASSERT_TRUE(settings) << settings.error().line;
    Settings expected;
    expected.friction = 0.25;
    expected.mode = Mode::wall;
    EXPECT_EQ(*settings, expected);
    EXPECT_EQ(apply_settings({}, "", "f", SettingLayer::session), Settings{});
}

TEST(SettingsText, WhateverIsWrongIsOneLineWithItsPlace) {
    EXPECT_EQ(error_of("\n[feel]\nstifness = 5"), "site.toml:3: 'feel.stifness' is not a setting");
    EXPECT_EQ(error_of("[feel]\nfriction = 1.5"),
              "site.toml:2: 'feel.friction' must be a number from 0 to 1");
    EXPECT_EQ(error_of("[feel]\nfriction = nan"),
              "site.toml:2: 'feel.friction' must be a number from 0 to 1");
    EXPECT_EQ(error_of("[picture]\ndetail = 2.5"),
              "site.toml:2: 'picture.detail' must be a whole number from 1 to 5");
    EXPECT_EQ(error_of("[feel]\nmode = 'sponge'"),
              "site.toml:2: 'feel.mode' must be \"wall\" or \"groove\" or \"ridge\" or \"stay\"");
    EXPECT_EQ(error_of("[levels]\nautomatic = 1"),
              "site.toml:2: 'levels.automatic' must be true or false");
    EXPECT_EQ(error_of("[fel]\n"), "site.toml:1: 'fel' is no table of settings");
    EXPECT_EQ(error_of("feel = 3"), "site.toml:1: 'feel' is no table of settings");
    EXPECT_EQ(error_of("[levels]\nfinest = 5\ncoarsest = 4"),
              "site.toml:3: 'levels.finest' must not be above 'levels.coarsest'");
    EXPECT_EQ(error_of("[language]\nfirst = 'nl'"),
              "site.toml:2: 'language.first' must be one of 'language.offered'");
    EXPECT_EQ(error_of("[hours]\nopening = 'noon'"),
              "site.toml:2: 'hours.opening' must be two times like \"09:00-17:00\"");
    EXPECT_TRUE(error_of("[feel").starts_with("site.toml:1: "));
    EXPECT_EQ(error_of(std::string(2'000'000, '#')),
              "site.toml: is larger than 1 MB; no file of settings is");
}

TEST(SettingsText, ALayerSetsNoMoreThanItMay) {
    EXPECT_EQ(error_of("[stick]\nwatched_folder = '/srv'", SettingLayer::session),
              "site.toml:2: 'stick.watched_folder' can be set by the site's file only");
    EXPECT_EQ(error_of("[levels]\nfinest = 1", SettingLayer::profile), "no error");
    EXPECT_EQ(error_of("[levels]\nfinest = 1", SettingLayer::session),
              "site.toml:2: 'levels.finest' can be set by a profile only");
}

Settings any_settings() {
    Settings settings;
    for (const SettingRow& row : setting_rows()) {
        const int steps = *rc::gen::inRange(0, 30);
        const bool is_up = *rc::gen::arbitrary<bool>();
        for (int i = 0; i < steps; ++i) settings = stepped(settings, row, is_up);
    }
    settings.watched_folder = '/' + *rc::gen::string<std::string>();
    for (char& letter : settings.watched_folder) letter = static_cast<char>(letter & 0x7f);
    std::erase_if(settings.watched_folder,
                  [](char letter) { return letter < ' ' || letter == 0x7f; });
    if (!conflicts(settings).empty()) settings.finest_level = settings.coarsest_level;
    return settings;
}

RC_GTEST_PROP(SettingRows, OfTheHouseAreTakenAndOfTheKioskAreKept, ()) {
    const Settings kiosk = any_settings();
    const Settings house = any_settings();
    const Settings both = with_settings_of_house(kiosk, house);
    for (const SettingRow& row : setting_rows())
        RC_ASSERT(value_of(both, row) ==
                  value_of(row.owner == SettingOwner::house ? house : kiosk, row));
}

RC_GTEST_PROP(SettingRows, ChangedHereAreTakenAndAllOthersAreTheLatest, ()) {
    const Settings latest = any_settings();
    const Settings base = any_settings();
    const Settings edited = any_settings();
    const Settings both = with_changes(latest, base, edited);
    for (const SettingRow& row : setting_rows()) {
        const bool is_changed = value_of(edited, row) != value_of(base, row);
        RC_ASSERT(value_of(both, row) == value_of(is_changed ? edited : latest, row));
    }
    RC_ASSERT(with_changes(base, base, edited) == edited);
}

RC_GTEST_PROP(SettingsText, IsReadBackToTheSameBits, ()) {
    const Settings settings = any_settings();
    const auto all = apply_settings({}, settings_text(settings), "f", SettingLayer::site);
    RC_ASSERT(all.has_value());
    RC_ASSERT(*all == settings);
    const Settings base = any_settings();
    const auto changed =
        apply_settings(base, settings_text(settings, base), "f", SettingLayer::site);
    RC_ASSERT(changed.has_value());
    RC_ASSERT(*changed == settings);
}

/// Changes, doubles and removes bytes of a good file: the result is settings in range, or one line.
RC_GTEST_PROP(SettingsText, OfAnyBytesIsSoundOrOneLine, ()) {
    std::string text = settings_text(any_settings());
    const int changes = *rc::gen::inRange(1, 6);
    for (int i = 0; i < changes && !text.empty(); ++i) {
        const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
        const int what = *rc::gen::inRange(0, 3);
        if (what == 0) text[at] = *rc::gen::arbitrary<char>();
        if (what == 1) text.erase(at, *rc::gen::inRange<std::size_t>(1, 40));
        if (what == 2) text.insert(at, text.substr(at, 20));
    }
    const auto settings = apply_settings({}, text, "f", SettingLayer::site);
    if (!settings) {
        RC_ASSERT(settings.error().line.starts_with("f:"));
        RC_ASSERT(settings.error().line.find('\n') == std::string::npos);
        return;
    }
    for (const SettingRow& row : setting_rows())
        RC_ASSERT(with_value({}, row, value_of(*settings, row)).has_value());
}

}  // namespace
}  // namespace touchline
