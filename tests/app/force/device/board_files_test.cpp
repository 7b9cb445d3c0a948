// Tests the files of boards and units: what is kept reads back, and what is wrong is reported.
#include "app/force/device/board_files.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
  protected:
    Files() {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }

    ~Files() override { fs::remove_all(folder_); }

    BoardFiles files_with(const std::string& units) {
        std::ofstream(folder_ / "units.toml") << units;
        return files();
    }

    [[nodiscard]] BoardFiles files() const {
        return {fs::path(TOUCHLINE_SOURCE_DIR) / "config/defaults/boards.toml",
                folder_ / "units.toml"};
    }

    fs::path folder_ =
        fs::temp_directory_path() /
        ("touchline-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(Files, WithoutAFileOfUnitsTheTableIsEnough) {
    const auto settings = read_board_files(files());
    ASSERT_TRUE(settings.has_value());
    EXPECT_GT(settings->boards.size(), 5U);
    EXPECT_TRUE(settings->units.empty());
}

TEST_F(Files, AUnitIsKeptAndReplaced) {
    BoardFiles deep = files();
    deep.units = folder_ / "new" / "folder" / "units.toml";
    UnitSettings unit{"AB12", "2diy-gen3", {}};
    ASSERT_TRUE(keep_unit(deep, unit).has_value());
    ASSERT_TRUE(keep_unit(deep, {"CD34", "2diy-gen2", {}}).has_value());
    unit.calibration.scale = 1.02;
    unit.calibration.motors.are_swapped = true;
    ASSERT_TRUE(keep_unit(deep, unit).has_value());
    const auto settings = read_board_files(deep);
    ASSERT_TRUE(settings.has_value());
    ASSERT_EQ(settings->units.size(), 2U);
    const UnitSettings* read = find_unit(*settings, "AB12");
    ASSERT_NE(read, nullptr);
    EXPECT_EQ(read->profile, "2diy-gen3");
    EXPECT_EQ(read->calibration.scale, 1.02);
    EXPECT_TRUE(read->calibration.motors.are_swapped);
}

TEST_F(Files, ABrokenFileOfUnitsIsNotOverwritten) {
    const BoardFiles broken = files_with("[[unit]]\nserial = \"AB12\"\nprofile = 3\n");
    const auto settings = read_board_files(broken);
    ASSERT_FALSE(settings.has_value());
    EXPECT_NE(settings.error().line.find("units.toml:"), std::string::npos);
    EXPECT_FALSE(keep_unit(broken, {"CD34", "2diy-gen2", {}}).has_value());
    EXPECT_FALSE(read_board_files(broken).has_value());
}

TEST_F(Files, AUnitOfAnEarlierVersionNeitherHidesTheOthersNorKeepsThemFromBeingStored) {
    const BoardFiles old = files_with(
        "[[unit]]\nserial = \"AB12\"\nprofile = \"haplet\"\nscale = [1.0, 1.0]\n"
        "offset_rad = [0.0, 0.0]\n");
    const auto settings = read_board_files(old);
    ASSERT_TRUE(settings.has_value()) << settings.error().line;
    EXPECT_NE(settings->notice.find("units.toml"), std::string::npos);
    EXPECT_EQ(find_unit(*settings, "AB12")->profile, "");
    EXPECT_TRUE(keep_unit(old, {"AB12", "haplet", {}}).has_value());
    EXPECT_EQ(find_unit(read_board_files(old).value(), "AB12")->profile, "haplet");
    EXPECT_EQ(read_board_files(old)->notice, "");
}

TEST_F(Files, AUnitWithoutASerialNumberIsNotStored) {
    const auto kept = keep_unit(files(), {"", "haplet", {}});
    ASSERT_FALSE(kept.has_value());
    EXPECT_NE(kept.error().line.find("serial number"), std::string::npos);
    EXPECT_FALSE(fs::exists(files().units));
}

TEST(Units, OfAnotherKindKeepTheSitesTorqueLimitAndNothingElse) {
    UnitSettings unit{"AB12", "2diy-gen3.1", {}};
    unit.calibration = {{}, {0.01, 0.02}, 0.5, {true}, {true}, true, true, 0.05};
    const auto haplet = find_profile("haplet").value();
    const UnitSettings taken = as_kind(unit, haplet);
    EXPECT_EQ(taken.serial, "AB12");
    EXPECT_EQ(taken.profile, "haplet");
    EXPECT_FALSE(taken.calibration.is_measured);
    EXPECT_FALSE(taken.calibration.has_all_counts);
    EXPECT_EQ(taken.calibration.scale, 1.0);
    EXPECT_EQ(taken.calibration.stop_off, JointAngles{});
    EXPECT_EQ(taken.calibration.encoders, Plugs{});
    EXPECT_EQ(taken.calibration.motors, Plugs{});
    EXPECT_EQ(taken.calibration.torque_limit_Nm, 0.05);
    unit.calibration.torque_limit_Nm = 0.9;  // for stronger motors
    EXPECT_EQ(as_kind(unit, haplet).calibration.torque_limit_Nm, std::nullopt);
    const UnitSettings anew = as_kind(unit, find_profile("2diy-gen3.1").value());
    EXPECT_EQ(anew.calibration.torque_limit_Nm, 0.9);
    EXPECT_FALSE(anew.calibration.is_measured);
}

TEST_F(Files, AMissingTableIsSaid) {
    BoardFiles missing = files();
    missing.boards = folder_ / "none.toml";
    const auto settings = read_board_files(missing);
    ASSERT_FALSE(settings.has_value());
    EXPECT_NE(settings.error().line.find("none.toml"), std::string::npos);
}

}  // namespace
}  // namespace touchline
