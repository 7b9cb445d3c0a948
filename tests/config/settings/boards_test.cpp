#include "config/settings/boards.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::string boards_error(std::string_view text) {
    const auto settings = parse_boards(text, "boards.toml");
    return settings ? "no error" : settings.error().line;
}

constexpr std::string_view zero_board =
    "[[board]]\nvendor = 0x2341\nproduct = 0x804d\nstate = \"running\"\nname = \"Zero\"\n";

TEST(Boards, InstalledTableNamesEveryKnownId) {
    const auto settings = read_boards(TOUCHLINE_SOURCE_DIR "/config/defaults/boards.toml");
    ASSERT_TRUE(settings.has_value()) << settings.error().line;
    EXPECT_TRUE(settings->units.empty());
    const auto find = [&](std::uint16_t vendor, std::uint16_t product) {
        return std::find_if(
            settings->boards.begin(), settings->boards.end(),
            [&](const BoardId& id) { return id.vendor == vendor && id.product == product; });
    };
    ASSERT_NE(find(0x2341, 0x804d), settings->boards.end());
    EXPECT_EQ(find(0x2341, 0x804d)->condition, BoardCondition::running);
    EXPECT_TRUE(find(0x2341, 0x804d)->may_probe);
    ASSERT_NE(find(0x2341, 0x003e), settings->boards.end());
    EXPECT_EQ(find(0x2341, 0x004d)->condition, BoardCondition::needs_firmware);
    EXPECT_EQ(find(0x03eb, 0x6124)->condition, BoardCondition::needs_firmware);
    EXPECT_EQ(find(0x2341, 0x003d)->condition, BoardCondition::wrong_socket);
    EXPECT_EQ(std::count_if(settings->boards.begin(), settings->boards.end(),
                            [](const BoardId& id) { return id.may_probe; }),
              2);
    for (const BoardId& id : settings->boards) EXPECT_FALSE(id.name.empty());
}

TEST(Boards, UdevRulesOpenEveryBoardOfTheTable) {
    const std::string folder = TOUCHLINE_SOURCE_DIR "/config/defaults/";
    std::ifstream in(folder + "70-touchline.rules");
    const std::string rules(std::istreambuf_iterator<char>(in), {});
    const BoardSettings settings = read_boards(folder + "boards.toml").value();
    for (const BoardId& id : settings.boards) {
        char line[100];
        std::snprintf(line, sizeof line, "ATTRS{idVendor}==\"%04x\", ATTRS{idProduct}==\"%04x\", ",
                      static_cast<unsigned>(id.vendor), static_cast<unsigned>(id.product));
        const std::size_t at = rules.find(line);
        ASSERT_NE(at, std::string::npos) << line;
        // The user at the seat gets access, and so does the group of the installed kiosk, which has
        // no seat.
        const std::string rest = rules.substr(at, rules.find('\n', at) - at);
        EXPECT_NE(rest.find("TAG+=\"uaccess\", GROUP=\"touchline\", MODE=\"0660\""),
                  std::string::npos)
            << rest;
        EXPECT_NE(rest.find("ENV{ID_MM_DEVICE_IGNORE}=\"1\""), std::string::npos) << rest;
    }
}

/// A desktop can then offer the program to a user who plugs in a board.
TEST(Boards, TheMetainfoNamesTheBoardsThatAreOpenedUnasked) {
    std::ifstream in(TOUCHLINE_SOURCE_DIR
                     "/app/package/desktop/org.touchline.touchline.metainfo.xml");
    const std::string metainfo(std::istreambuf_iterator<char>(in), {});
    const auto boards = read_boards(TOUCHLINE_SOURCE_DIR "/config/defaults/boards.toml")->boards;
    for (const BoardId& id : boards) {
        char modalias[100];
        std::snprintf(modalias, sizeof modalias, "<modalias>usb:v%04Xp%04Xd*</modalias>",
                      static_cast<unsigned>(id.vendor), static_cast<unsigned>(id.product));
        EXPECT_EQ(metainfo.find(modalias) != std::string::npos, id.may_probe) << modalias;
    }
}

TEST(Boards, UnitsAreReadBackAsTheyWereWritten) {
    UnitSettings left{"A1B2", "2diy-gen3.1", {}};
    left.calibration = {
        {}, {0.01, -1.0 / 30.0}, 1.0194, {true, false, true}, {false, true, false}, true, true,
        0.1};
    const UnitSettings plain{"with \"quotes\" and \\", "haplet", {}};
    const auto read = parse_boards(units_text({left, plain}), "units.toml");
    ASSERT_TRUE(read.has_value()) << read.error().line;
    ASSERT_EQ(read->units.size(), 2U);
    const UnitSettings* found = find_unit(*read, "A1B2");
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->profile, "2diy-gen3.1");
    EXPECT_EQ(found->calibration.stop_off, left.calibration.stop_off);
    EXPECT_EQ(found->calibration.scale, left.calibration.scale);
    EXPECT_EQ(found->calibration.encoders, left.calibration.encoders);
    EXPECT_EQ(found->calibration.motors, left.calibration.motors);
    EXPECT_TRUE(found->calibration.is_measured);
    EXPECT_TRUE(found->calibration.has_all_counts);
    EXPECT_EQ(found->calibration.torque_limit_Nm, 0.1);
    ASSERT_NE(find_unit(*read, plain.serial), nullptr);
    EXPECT_EQ(find_unit(*read, plain.serial)->calibration.torque_limit_Nm, std::nullopt);
    EXPECT_EQ(find_unit(*read, "none"), nullptr);
}

TEST(Boards, WhatIsWrongIsOneLineWithItsPlace) {
    const std::string board(zero_board);
    EXPECT_EQ(boards_error(board), "no error");
    EXPECT_EQ(boards_error(board + "colour = 3\n"),
              "boards.toml:6: 'colour' is not a setting here");
    EXPECT_EQ(boards_error("[[bord]]\n"), "boards.toml:1: 'bord' is not a setting here");
    EXPECT_EQ(boards_error("board = 3\n"), "boards.toml:1: 'board' must be written as [[board]]");
    EXPECT_EQ(boards_error("[[board]]\nvendor = 1\n"), "boards.toml:1: 'product' is missing");
    EXPECT_EQ(boards_error("[[board]]\nvendor = 0x10000\n"),
              "boards.toml:2: 'vendor' must be a number from 1 to 0xffff");
    EXPECT_EQ(boards_error("[[board]]\nvendor = \"a\"\n"),
              "boards.toml:2: 'vendor' must be a number from 1 to 0xffff");
    EXPECT_EQ(
        boards_error("[[board]]\nvendor = 1\nproduct = 2\nname = \"x\"\nstate = \"asleep\"\n"),
        "boards.toml:5: 'state' must be running, needs-firmware or wrong-socket");
    const std::string broken = boards_error("[[board\nvendor = 1");
    EXPECT_EQ(broken.rfind("boards.toml:1: ", 0), 0U) << broken;
    EXPECT_EQ(broken.find('\n'), std::string::npos);
}

TEST(Boards, ValuesOutOfRangeAreRefused) {
    const std::string unit = "[[unit]]\nserial = \"A\"\nprofile = \"mk2\"\n";
    EXPECT_EQ(boards_error(unit), "no error");
    for (const char* bad :
         {"torque_limit_Nm = 0.0", "torque_limit_Nm = -0.1", "torque_limit_Nm = nan",
          "torque_limit_Nm = 1.5", "torque_limit_Nm = inf"})
        EXPECT_EQ(boards_error(unit + bad),
                  "boards.toml:4: 'torque_limit_Nm' must be above 0 and at most 1");
    for (const char* bad : {"scale = 0.3", "scale = 1.4", "scale = nan"})
        EXPECT_EQ(boards_error(unit + bad),
                  "boards.toml:4: 'scale' must be a number from 0.4 to 1.3");
    EXPECT_EQ(boards_error(unit + "scale = true"), "boards.toml:4: 'scale' must be a number");
    for (const char* bad :
         {"stop_off_rad = [0.0, 0.5]", "stop_off_rad = [nan, 0.0]", "stop_off_rad = [0.0]",
          "stop_off_rad = 0.0", "stop_off_rad = [0.0, 0.0, 0.0]", "stop_off_rad = [\"a\", 0.0]"})
        EXPECT_EQ(boards_error(unit + bad),
                  "boards.toml:4: 'stop_off_rad' must be two numbers, one a joint, from "
                  "-0.1 to 0.1");
    for (const char* bad : {"reversed_motors = true", "reversed_motors = [true]",
                            "reversed_motors = [1, 0]", "reversed_motors = [true, true, true]"})
        EXPECT_EQ(boards_error(unit + bad),
                  "boards.toml:4: 'reversed_motors' must be true or false twice, one a joint");
}

/// This is what units_text() wrote before motors and encoders were told apart.
TEST(Boards, AUnitOfVersion0HasNoKindAndIsNotMeasured) {
    const std::string old =
        "[[unit]]\nserial = 'A1B2'\nprofile = '2diy-gen3.1'\n"
        "swapped_motors = true\nscale = [ 1.02, 0.99 ]\n"
        "offset_rad = [ 3.0, -6.2 ]\ntorque_limit_Nm = 0.05\n";
    const std::string now = units_text({{"C3D4", "mk2", {}}});
    EXPECT_EQ(parse_boards(now, "units.toml")->notice, "");
    const auto read = parse_boards(old + now, "units.toml");
    ASSERT_TRUE(read.has_value()) << read.error().line;
    EXPECT_EQ(read->notice.rfind("units.toml: ", 0), 0U) << read->notice;
    const UnitSettings* const unit = find_unit(*read, "A1B2");
    ASSERT_NE(unit, nullptr);
    EXPECT_EQ(unit->profile, "");
    EXPECT_FALSE(unit->calibration.is_measured);
    EXPECT_EQ(unit->calibration.scale, 1.0);
    EXPECT_EQ(unit->calibration.motors, Plugs{});
    EXPECT_EQ(unit->calibration.torque_limit_Nm, 0.05) << "less force than the profile's";
    EXPECT_EQ(find_unit(*read, "C3D4")->profile, "mk2");
    const auto rewritten = parse_boards(units_text(read->units), "units.toml");
    ASSERT_TRUE(rewritten.has_value()) << rewritten.error().line;
    EXPECT_EQ(rewritten->notice, "");
    EXPECT_EQ(find_unit(*rewritten, "A1B2")->profile, "");
    EXPECT_EQ(boards_error(old + "colour = 3\n"), "boards.toml:8: 'colour' is not a setting here");
    EXPECT_EQ(boards_error(old + "measured = true\n"),
              "boards.toml:8: 'measured' is not a setting here");
}

TEST(Boards, ThoseWithoutASerialNumberAreNeverKnown) {
    const auto read = parse_boards(units_text({{"", "mk2", {}}}), "units.toml");
    ASSERT_TRUE(read.has_value()) << read.error().line;
    EXPECT_EQ(find_unit(*read, ""), nullptr);
}

TEST(Boards, FileThatIsMissingOrHugeIsRefused) {
    const auto folder = std::filesystem::path(testing::TempDir());
    EXPECT_EQ(read_boards(folder / "none.toml").error().line,
              "cannot read " + (folder / "none.toml").string());
    const auto huge = folder / "huge.toml";
    std::ofstream(huge) << std::string((1 << 20) + 1, '#');
    EXPECT_EQ(read_boards(huge).error().line, huge.string() + " is larger than 1 MB");
    std::filesystem::remove(huge);
}

}  // namespace
}  // namespace touchline
