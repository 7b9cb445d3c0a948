// Tests the site's settings file: missing, good, wrong, cut off, written by two at once.
#include "app/operator/settings_files.h"

#include "config/settings/settings_text.h"
#include "tests/config/scratch_folder.h"

#include <fstream>
#include <thread>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

Settings soft() {
    Settings settings;
    settings.stiffness_N_per_m = 200.0;
    return settings;
}

class SettingsFilesTest : public testing::Test {
  protected:
    void put(const std::string& text) const { std::ofstream(files.site) << text; }

    ScratchFolder scratch{fast_folder()};
    fs::path folder = scratch.path();
    SettingsFiles files{folder / "kiosk.toml", folder / "kiosk.toml.good"};
};

TEST_F(SettingsFilesTest, WithoutAFileTheProgramsOwnHold) {
    const KeptSettings kept = read_settings(files);
    EXPECT_EQ(kept.settings, Settings{});
    EXPECT_EQ(kept.note, "");
    EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(SettingsFilesTest, WhatIsKeptIsReadAgainAndIsOnlyWhatDiffers) {
    ASSERT_TRUE(keep_settings(files, soft()));
    EXPECT_EQ(read_settings(files).settings, soft());
    std::ifstream in(files.site);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    EXPECT_NE(text.find("stiffness_N_per_m = 200"), std::string::npos);
    EXPECT_EQ(text.find("friction"), std::string::npos);
}

TEST_F(SettingsFilesTest, AFolderThatIsNotThereIsMade) {
    files.site = folder / "new" / "folder" / "kiosk.toml";
    EXPECT_TRUE(keep_settings(files, soft()));
    EXPECT_EQ(read_settings(files).settings, soft());
}

TEST_F(SettingsFilesTest, AWrongFileLeavesTheLastGoodOneInForce) {
    put("# ours\n[feel]\nstiffness_N_per_m = 200\n");
    ASSERT_EQ(read_settings(files).note, "");
    for (const char* text : {"[feel]\nstiffness_N_per_m = 9000\n", "[feel", "\xff\xfe\0\1",
                             "[feel]\nstiffness_N_per_m = '300'"}) {
        put(text);
        const KeptSettings kept = read_settings(files);
        EXPECT_EQ(kept.settings, soft()) << text;
        EXPECT_TRUE(kept.note.starts_with(files.site.string())) << kept.note;
        EXPECT_TRUE(kept.note.ends_with("; the settings before hold")) << kept.note;
        EXPECT_EQ(kept.note.find('\n'), std::string::npos);
    }
    put("# nothing\n");
    EXPECT_EQ(read_settings(files).settings, Settings{})
        << "a file that sets nothing is a good one";
}

TEST_F(SettingsFilesTest, AnEmptyFileIsOneThatWasCutOff) {
    ASSERT_TRUE(keep_settings(files, soft()));
    ASSERT_EQ(read_settings(files).note, "");
    put("");
    const KeptSettings kept = read_settings(files);
    EXPECT_EQ(kept.settings, soft());
    EXPECT_EQ(kept.note,
              files.site.string() + ": is empty, as if cut off; the settings before hold");
}

TEST_F(SettingsFilesTest, TheProgramsOwnAreKeptAsAFileThatIsNotEmpty) {
    ASSERT_TRUE(keep_settings(files, soft()));
    ASSERT_EQ(read_settings(files).settings, soft());
    ASSERT_TRUE(keep_settings(files, Settings{}));
    EXPECT_EQ(read_settings(files).settings, Settings{});
    EXPECT_EQ(read_settings(files).note, "");
}

TEST_F(SettingsFilesTest, WithNoGoodOneTheProgramsOwnHold) {
    put("[feel]\nmode = 3");
    const KeptSettings kept = read_settings(files);
    EXPECT_EQ(kept.settings, Settings{});
    EXPECT_TRUE(kept.note.ends_with("; the program's own settings hold")) << kept.note;
    EXPECT_FALSE(fs::exists(files.last_good));
    std::ofstream(files.last_good) << "[feel]\nmode = 4";
    EXPECT_EQ(read_settings(files).settings, Settings{});
}

/// A writer died and left half a file: wherever it is cut, the last good settings stay in force.
TEST_F(SettingsFilesTest, CutOffAnywhereNothingIsHalf) {
    Settings before;
    before.friction = 0.5;
    ASSERT_TRUE(keep_settings(files, before));
    ASSERT_EQ(read_settings(files).settings, before);
    const std::string whole = settings_text(soft());
    for (std::size_t length = 0; length < whole.size(); ++length) {
        std::ofstream(files.last_good) << settings_text(before);
        put(whole.substr(0, length));
        const KeptSettings kept = read_settings(files);
        const auto alone = apply_settings({}, whole.substr(0, length), "f", SettingLayer::site);
        EXPECT_EQ(kept.settings, length > 0 && alone ? *alone : before) << length;
    }
}

TEST_F(SettingsFilesTest, TwoWritersAndAReaderSeeWholeFiles) {
    Settings firm;
    firm.stiffness_N_per_m = 700.0;
    ASSERT_TRUE(keep_settings(files, firm));
    const auto write = [this](const Settings& settings) {
        for (int i = 0; i < 50; ++i) ASSERT_TRUE(keep_settings(files, settings));
    };
    std::thread first([&] { write(soft()); });
    std::thread second([&] { write(firm); });
    for (int i = 0; i < 100; ++i) {
        const KeptSettings kept = read_settings(files);
        EXPECT_EQ(kept.note, "");
        EXPECT_TRUE(kept.settings == soft() || kept.settings == firm);
    }
    first.join();
    second.join();
}

TEST_F(SettingsFilesTest, AChangeIsNoticedOnce) {
    FileWatch watch(files.site);
    EXPECT_FALSE(watch.has_changed());
    put("a");
    EXPECT_TRUE(watch.has_changed());
    EXPECT_FALSE(watch.has_changed());
    ASSERT_TRUE(keep_settings(files, soft()));
    EXPECT_TRUE(watch.has_changed());
    fs::remove(files.site);
    EXPECT_TRUE(watch.has_changed());
    EXPECT_FALSE(watch.has_changed());
}

}  // namespace
}  // namespace touchline
