// Tests a whole visit with the real programs and a real CUPS: the sheet arrives, and nothing of it
// stays.
#include "app/isolation/process/places.h"
#include "tests/app/kiosk/blind_visitor.h"
#include "tests/app/kiosk/kiosk_world.h"
#include "tests/app/printing/own_cups.h"

#include <chrono>
#include <cstdlib>
#include <thread>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(RealPrint, TI4_AVisitorsSheetIsPrintedAndNothingOfItStays) {
    ASSERT_FALSE(OwnCups::program().empty()) << "the package cups-daemon is not installed";
    const OwnCups cups;
    setenv("CUPS_SERVER", cups.socket().c_str(), 1);
    KioskWorld world;
    world.printing = printing_by(
        {companion("touchline-sheet"), companion("touchline-print"), TOUCHLINE_CATALOGUES});
    Settings settings;
    settings.printer = "good";
    settings.sheet = SheetKind::embosser;
    world.kiosk().set(settings);
    BlindVisitor visitor(world);
    ASSERT_NO_FATAL_FAILURE(open_gallery_picture(visitor, "A heart"));
    ASSERT_TRUE(visitor.choose("Print to take home")) << visitor.heard();
    const std::string done = "Your sheet is in the printer.";
    for (int i = 0; i < 1000 && visitor.heard().find(done) == std::string::npos; ++i) {
        world.run(0.05);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    EXPECT_NE(visitor.heard().find(done), std::string::npos) << visitor.heard();
    EXPECT_NE(cups.printed().find("A HEART"), std::string::npos) << cups.printed();
    EXPECT_EQ(cups.spooled(), std::vector<std::string>());
    EXPECT_EQ(cups.files_with("A HEART"), std::vector<std::string>());
    EXPECT_EQ(cups.files_with("heart"), std::vector<std::string>());
    unsetenv("CUPS_SERVER");
}

}  // namespace
}  // namespace touchline
