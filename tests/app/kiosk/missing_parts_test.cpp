#include "app/kiosk/watched.h"
#include "tests/app/kiosk/kiosk_world.h"

#include <fstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(MissingParts, ArePatientlyWaitedForAndToldOnce) {
    MissingParts missing;
    EXPECT_EQ(missing.step(Part::sound, false, 100.0), "");
    EXPECT_EQ(missing.step(Part::sound, false, 104.9), "");
    EXPECT_NE(missing.step(Part::sound, false, 105.0).find("no sound"), std::string::npos);
    EXPECT_EQ(missing.step(Part::sound, false, 200.0), "");
}

TEST(MissingParts, AreToldAgainOnlyOnceTheyWereThere) {
    MissingParts missing;
    EXPECT_EQ(missing.step(Part::camera, false, 0.0), "");
    EXPECT_EQ(missing.step(Part::camera, true, 4.0), "");
    EXPECT_EQ(missing.step(Part::camera, false, 6.0), "");
    EXPECT_NE(missing.step(Part::camera, false, 11.0), "");
    EXPECT_EQ(missing.step(Part::camera, true, 12.0), "");
    EXPECT_EQ(missing.step(Part::camera, false, 13.0), "");
    EXPECT_NE(missing.step(Part::camera, false, 18.0), "");
}

TEST(MissingParts, EachHasALineOfItsOwn) {
    MissingParts missing;
    for (const Part part : {Part::sticks, Part::sound, Part::camera})
        EXPECT_EQ(missing.step(part, false, 0.0), "");
    EXPECT_NE(missing.step(Part::sticks, false, 9.0).find("USB sticks"), std::string::npos);
    EXPECT_NE(missing.step(Part::sound, false, 9.0).find("sound"), std::string::npos);
    EXPECT_NE(missing.step(Part::camera, false, 9.0).find("camera"), std::string::npos);
}

TEST(MissingParts, ASoundThatGoesIsOneLineOfTheLog) {
    KioskWorld world;
    world.run(6.0);
    const std::string before = world.kiosk().take_report();
    EXPECT_EQ(before.find("no sound"), std::string::npos) << before;
    world.heard().problem = "There is no sound. Please call the staff.";
    world.run(6.0);
    const std::string after = world.kiosk().take_report();
    EXPECT_NE(after.find("there is no sound: "), std::string::npos) << after;
    world.run(6.0);
    EXPECT_EQ(world.kiosk().take_report(), "");
}

/// A folder stands in place of the counters' file, so writing fails for any user.
TEST(MissingParts, ADiskThatTakesNothingIsOneLine) {
    KioskWorld world;
    OperatorFiles files = world.site_files();
    std::filesystem::create_directories(files.counters.parent_path() / "write-test");
    std::vector<std::string> problems;
    const OperatorSession desk(files, {Language()}, problems);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_NE(problems.front().find("nothing can be kept in"), std::string::npos) << problems[0];
}

TEST(MissingParts, AFolderForTheSiteIsMadeAndNothingIsSaid) {
    KioskWorld world;
    OperatorFiles files = world.site_files();
    files.counters = world.folder() / "new" / "counters.toml";
    std::vector<std::string> problems;
    const OperatorSession desk(files, {Language()}, problems);
    EXPECT_TRUE(problems.empty()) << problems.front();
}

}  // namespace
}  // namespace touchline
