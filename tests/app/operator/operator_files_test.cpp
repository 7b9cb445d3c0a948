// Tests the operator's files: what is kept comes back; what is wrong is refused in one sentence.
#include "app/operator/backup.h"
#include "app/operator/counters.h"
#include "app/operator/pin.h"
#include "app/operator/settings_files.h"
#include "config/settings/setting_rows.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

class OperatorFilesTest : public testing::Test {
  protected:
    OperatorFilesTest() { fs::create_directories(folder); }

    ~OperatorFilesTest() override { fs::remove_all(folder); }

    void put(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name) << text;
    }

    [[nodiscard]] std::string text_of(const std::string& name) const {
        std::ifstream in(folder / name);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    fs::path folder =
        fs::path(testing::TempDir()) / ("touchline-operator-files-" + std::to_string(getpid()));
    fs::path pin = folder / "operator.pin";
};

std::string error_of(const Result<bool>& result) {
    return result ? "no error" : result.error().line;
}

TEST_F(OperatorFilesTest, APinIsAYescryptHashThatOnlyTheKioskReads) {
    EXPECT_FALSE(has_pin(pin));
    ASSERT_TRUE(keep_pin(pin, "1234"));
    EXPECT_TRUE(has_pin(pin));
    EXPECT_TRUE(text_of("operator.pin").starts_with("$y$"));
    EXPECT_EQ(text_of("operator.pin").find("1234"), std::string::npos);

    struct stat state {};

    ASSERT_EQ(::stat(pin.c_str(), &state), 0);
    EXPECT_EQ(state.st_mode & 0777U, 0600U);
    EXPECT_EQ(is_right_pin(pin, "1234"), true);
    for (const char* wrong : {"1235", "123", "12345", "", "01234"})
        EXPECT_EQ(is_right_pin(pin, wrong), false) << wrong;
    const std::string before = text_of("operator.pin");
    ASSERT_TRUE(keep_pin(pin, "1234"));
    EXPECT_NE(text_of("operator.pin"), before) << "each has its own salt";
    EXPECT_EQ(is_right_pin(pin, "1234"), true);
}

TEST_F(OperatorFilesTest, WhatIsNoPinIsNotKept) {
    for (const char* text : {"", "123", "123456789", "12a4", "12 4"}) {
        EXPECT_FALSE(keep_pin(pin, text)) << text;
        EXPECT_FALSE(has_pin(pin));
    }
}

TEST_F(OperatorFilesTest, ABrokenPinLetsNobodyIn) {
    EXPECT_NE(error_of(is_right_pin(pin, "1234")).find("cannot be read"), std::string::npos);
    ASSERT_TRUE(keep_pin(pin, "1234"));
    fs::permissions(pin, fs::perms::others_read, fs::perm_options::add);
    EXPECT_NE(error_of(is_right_pin(pin, "1234")).find("set its mode to 600"), std::string::npos);
    fs::permissions(pin, fs::perms::owner_read | fs::perms::owner_write);
    const std::string whole = text_of("operator.pin");
    for (std::size_t length = 0; length + 1 < whole.size(); length += 7) {
        put("operator.pin", whole.substr(0, length));
        EXPECT_NE(is_right_pin(pin, "1234"), true) << length;
        EXPECT_TRUE(has_pin(pin)) << "breaking the file is no way in";
    }
    for (const std::string& text : {std::string("1234"), std::string("$1$abc$xyz"), std::string(),
                                    std::string("$y$\0\0", 5), std::string(5000, '$')}) {
        put("operator.pin", text);
        const std::string line = error_of(is_right_pin(pin, "1234"));
        EXPECT_NE(line.find("remove it and choose a new one"), std::string::npos) << line;
        EXPECT_EQ(line.find('\n'), std::string::npos);
    }
    fs::remove(pin);
    fs::create_symlink(folder / "elsewhere", pin);
    EXPECT_TRUE(has_pin(pin)) << "a link to nothing is no fresh install";
    EXPECT_FALSE(is_right_pin(pin, "1234"));
}

TEST_F(OperatorFilesTest, WrongPinsAreCountedOnTheDisk) {
    const fs::path tries = pin_tries_file(pin);
    EXPECT_EQ(tries, folder / "operator.tries");
    EXPECT_EQ(read_pin_tries(tries), 0) << "nothing was tried";
    for (const int wrong : {1, 4, most_wrong_pins}) {
        ASSERT_TRUE(keep_pin_tries(tries, wrong));
        EXPECT_EQ(read_pin_tries(tries), wrong);

        struct stat state {};

        ASSERT_EQ(::stat(tries.c_str(), &state), 0);
        EXPECT_EQ(state.st_mode & 0777U, 0600U);
    }
    ASSERT_TRUE(keep_pin_tries(tries, most_wrong_pins + 1));
    EXPECT_EQ(read_pin_tries(tries), most_wrong_pins);
    ASSERT_TRUE(keep_pin_tries(tries, 0));
    EXPECT_FALSE(fs::exists(tries));
    EXPECT_TRUE(keep_pin_tries(tries, 0)) << "twice is as good";
}

TEST_F(OperatorFilesTest, ADamagedCountOfWrongPinsIsOneLineAndNoNumber) {
    const fs::path tries = pin_tries_file(pin);
    for (const char* text : {"", "1\n", "wrong PINs: ", "wrong PINs: 3", "wrong PINs: 0\n",
                             "wrong PINs: -1\n", "wrong PINs: 12\n", "wrong PINs: 3\n\n",
                             "wrong PINs: 99999999999999\n", "wrong PINs: x\n"}) {
        put("operator.tries", text);
        fs::permissions(tries, fs::perms::owner_read | fs::perms::owner_write);
        const auto wrong = read_pin_tries(tries);
        ASSERT_FALSE(wrong.has_value()) << text;
        EXPECT_NE(wrong.error().line.find("does not say how many"), std::string::npos);
    }
    ASSERT_TRUE(keep_pin_tries(tries, 3));
    fs::permissions(tries, fs::perms::others_write, fs::perm_options::add);
    EXPECT_FALSE(read_pin_tries(tries));
    fs::remove(tries);
    fs::create_symlink(folder / "elsewhere", tries);
    EXPECT_FALSE(read_pin_tries(tries)) << "a link to nothing is no fresh start";
}

constexpr std::chrono::sys_days a_day{std::chrono::year(2026) / 2 / 28};
constexpr std::chrono::days one_day(1);

TEST_F(OperatorFilesTest, CountersComeBackAndHoldNothingElse) {
    const CountedDays counted{{a_day, {12, 30, 5, 2, 90, 1}},
                              {a_day + one_day, {1, 0, 0, 0, 3, 0}}};
    const fs::path file = folder / "new" / "counters.csv";
    EXPECT_EQ(read_counters(file), CountedDays{}) << "not there: nothing was counted";
    ASSERT_TRUE(keep_counters(file, counted));
    EXPECT_EQ(read_counters(file), counted);
    EXPECT_EQ(counters_csv(counted),
              "day,visits,gallery_pictures,stick_pictures,camera_pictures,minutes,faults\n"
              "2026-02-28,12,30,5,2,90,1\n2026-03-01,1,0,0,0,3,0\n");
    EXPECT_EQ(total_of(counted), (Counts{13, 30, 5, 2, 93, 1}));
}

TEST_F(OperatorFilesTest, DaysAreInTheirOrderAndTheOldestMakesRoom) {
    CountedDays days;
    ++counts_on(a_day + one_day, days).visits;
    ++counts_on(a_day, days).visits;  // the clock went back
    ++counts_on(a_day + one_day, days).visits;
    ASSERT_EQ(days.size(), 2U);
    EXPECT_EQ(days[0], (CountedDay{a_day, {1}}));
    EXPECT_EQ(days[1], (CountedDay{a_day + one_day, {2}}));
    for (int i = 2; i < 1000; ++i) ++counts_on(a_day + i * one_day, days).visits;
    ASSERT_EQ(days.size(), most_counted_days);
    EXPECT_EQ(days.back().day, a_day + 999 * one_day);
    EXPECT_EQ(days.front().day, a_day + 600 * one_day);
    EXPECT_EQ(parse_counters(counters_csv(days), "c"), days);
    ++counts_on(a_day, days).visits;  // the clock forgot everything
    ASSERT_EQ(days.size(), most_counted_days);
    EXPECT_EQ(days.front(), (CountedDay{a_day, {1}}));
}

TEST_F(OperatorFilesTest, WrongCountersAreOneLine) {
    const std::string names = counters_csv({});
    const auto error = [](const std::string& csv) {
        const auto days = parse_counters(csv, "c");
        return days ? "no error" : days.error().line;
    };
    EXPECT_EQ(error(""), "no error");
    EXPECT_EQ(error(names + "2026-03-01,1,0,0,0,3,18446744073709551615\n"), "no error");
    EXPECT_EQ(error("sessions = 1\n"), "c:1: must be '" + names.substr(0, names.size() - 1) + '\'');
    for (const char* line :
         {"", "2026-03-01", "2026-03-01,1,0,0,0,3", "2026-03-01,1,0,0,0,3,0,0",
          "2026-03-01,1,0,0,0,3,-1", "2026-03-01,1,0,0,0,3,1.5", "2026-03-01,1,0,0,0,3,x",
          "2026-03-01,1,0,0,0,3,99999999999999999999", "2026-02-29,1,0,0,0,3,0",
          "2026-13-01,1,0,0,0,3,0", "26-03-01,1,0,0,0,3,0", "today,1,0,0,0,3,0"})
        EXPECT_EQ(error(names + line + '\n'), "c:2: must be a day and its 6 whole numbers") << line;
    EXPECT_EQ(error(names + "2026-03-01,1,0,0,0,3,0\n2026-03-01,1,0,0,0,3,0\n"),
              "c:3: must be a later day than the line before");
}

Backup some_backup() {
    Backup backup;
    backup.settings.stiffness_N_per_m = 250.0;
    backup.settings.notice = "Back at two.";
    backup.sound.headset.default_dB = 60.0;
    backup.keys = default_keys();
    backup.keys.bindings.push_back({{KeySource::scancode, 77}, KeyRole::softer});
    return backup;
}

TEST_F(OperatorFilesTest, ABackupComesBackWhole) {
    ASSERT_TRUE(write_backup(folder, some_backup()));
    EXPECT_EQ(read_backup(folder), some_backup());
    EXPECT_FALSE(write_backup(folder / "none", some_backup()));
    EXPECT_FALSE(read_backup(folder / "none"));
}

TEST_F(OperatorFilesTest, ABackupCutOffOrWrongIsRefusedWithItsLine) {
    const std::string whole = backup_text(some_backup());
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const auto backup = parse_backup(whole.substr(0, length), "b");
        ASSERT_FALSE(backup) << length;
        EXPECT_TRUE(backup.error().line.starts_with("b:")) << backup.error().line;
        EXPECT_NE(backup.error().line.find("make a new backup"), std::string::npos);
    }
    std::string wrong = whole;
    wrong.replace(wrong.find("= 250"), 5, "= 900");
    const auto line = std::count(
        whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.find("= 250")), '\n');
    const auto backup = parse_backup(wrong, "b");
    ASSERT_FALSE(backup);
    EXPECT_EQ(backup.error().line,
              "b:" + std::to_string(line + 1) +
                  ": 'feel.stiffness_N_per_m' must be a number from 100 to 700")
        << "the line of the whole file";
    EXPECT_FALSE(parse_backup(whole + "more", "b"));
    EXPECT_FALSE(parse_backup("Touchline backup 2\n", "b"));
}

TEST_F(OperatorFilesTest, TheInstalledProfilesCanBeUsed) {
    std::vector<std::string> problems;
    const auto profiles = read_profiles(TOUCHLINE_SOURCE_DIR "/config/defaults/profiles", problems);
    EXPECT_TRUE(problems.empty()) << problems.front();
    ASSERT_EQ(profiles.size(), 4U);
    for (const Profile& profile : profiles) {
        Settings site;
        site.profile = profile.name;
        site.stiffness_N_per_m = 150.0;
        const auto settings = with_profile(site, profiles);
        ASSERT_TRUE(settings) << settings.error().line;
        EXPECT_NE(*settings, site) << profile.name;
        EXPECT_FALSE(profile.rows.empty());
        for (std::size_t row = 0; row < setting_rows().size(); ++row) {
            const bool is_set =
                std::find(profile.rows.begin(), profile.rows.end(), row) != profile.rows.end();
            const SettingRow& about = setting_rows()[row];
            EXPECT_TRUE(is_set || value_of(*settings, about) == value_of(site, about)) << about.key;
        }
    }
}

TEST_F(OperatorFilesTest, AWrongProfileIsLeftOutAndNamed) {
    put("good.toml", "[feel]\nfriction = 0.5\n");
    put("rude.toml", "[feel]\nforce_ceiling_N = 9\n");
    put("sly.toml", "[operator]\ndevice = ''\n");
    put("Bad Name.toml", "");
    std::vector<std::string> problems;
    const auto profiles = read_profiles(folder, problems);
    ASSERT_EQ(profiles.size(), 1U);
    ASSERT_EQ(problems.size(), 3U);
    EXPECT_NE(
        problems[1].find("rude.toml:2: 'feel.force_ceiling_N' must be a number from 0.5 to 3"),
        std::string::npos);
    EXPECT_NE(problems[2].find("can be set by the site's file only"), std::string::npos);
    Settings site;
    site.profile = "rude";
    EXPECT_FALSE(with_profile(site, profiles));
    site.profile = "good";
    EXPECT_EQ(with_profile(site, profiles)->friction, 0.5);
    problems.clear();
    EXPECT_TRUE(read_profiles(folder / "none", problems).empty());
    EXPECT_EQ(problems.size(), 1U);
}

TEST_F(OperatorFilesTest, KeysThatCannotBeUsedLeaveTheProgramsOwn) {
    const fs::path file = folder / "new" / "keys.toml";
    EXPECT_EQ(read_keys(file).keys, default_keys());
    EXPECT_EQ(read_keys(file).note, "");
    KeyTable keys = default_keys();
    keys.bindings.push_back({{KeySource::handle, 3}, KeyRole::softer});
    ASSERT_TRUE(keep_keys(file, keys));
    EXPECT_EQ(read_keys(file).keys, keys);
    EXPECT_FALSE(keep_keys(file, KeyTable{})) << "nobody could mend it";
    EXPECT_EQ(read_keys(file).keys, keys);
    std::ofstream(file) << "up = ['A']";
    EXPECT_EQ(read_keys(file).keys, default_keys());
    EXPECT_TRUE(read_keys(file).note.ends_with("; the program's own keys hold"));
    SoundSettings sound;
    ASSERT_TRUE(keep_sound(folder / "sound.toml", sound));
    sound.speaker.default_dB = 80.0;
    EXPECT_FALSE(keep_sound(folder / "sound.toml", sound));
}

}  // namespace
}  // namespace touchline
