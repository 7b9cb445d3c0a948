// Tests a visitor who prints what they feel, by the six keys and what is said.
#include "tests/app/kiosk/blind_visitor.h"
#include "tests/app/kiosk/kiosk_world.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr const char* print = "Print to take home";

void set_printer(KioskWorld& world) {
    Settings settings;
    settings.printer = "sheets";
    settings.sheet = SheetKind::letter;
    world.kiosk().set(settings);
}

void to_picture(KioskWorld& world, BlindVisitor& visitor, const std::string& name) {
    ASSERT_NO_FATAL_FAILURE(open_gallery_picture(visitor, name));
    world.run(1.0);
}

/// Passes the kiosk's time while another thread works in real time.
bool hears(KioskWorld& world, BlindVisitor& visitor, const std::string& words) {
    for (int i = 0; i < 200; ++i) {
        if (visitor.heard().find(words) != std::string::npos) return true;
        world.run(0.1);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

TEST(PrintedVisit, WithoutAPrinterNothingIsOffered) {
    KioskWorld world;
    BlindVisitor visitor(world);
    to_picture(world, visitor, "A heart");
    EXPECT_FALSE(visitor.find(print));
}

TEST(PrintedVisit, WhatIsFeltIsPrintedInTheVisitorsLanguageAndTold) {
    KioskWorld world;
    std::mutex lock;
    TactileMap printed;
    PrintOrder ordered;
    world.printing.print = [&](const TactileMap& map, const PrintOrder& order,
                               const std::stop_token&) {
        const std::lock_guard guard(lock);
        printed = map;
        ordered = order;
        return PrintEnd::printed;
    };
    set_printer(world);
    BlindVisitor visitor(world);
    to_picture(world, visitor, "A heart");
    ASSERT_TRUE(visitor.choose(print)) << visitor.heard();
    ASSERT_TRUE(hears(world, visitor, "Your sheet is in the printer.")) << visitor.heard();
    const std::lock_guard guard(lock);
    EXPECT_EQ(ordered.queue, "sheets");
    EXPECT_EQ(ordered.kind, SheetKind::letter);
    EXPECT_EQ(ordered.language, "en");
    EXPECT_EQ(printed.title, "A heart");
    EXPECT_EQ(printed.outlines.size(), world.servo().picture().map->outlines.size());
}

TEST(PrintedVisit, AFailureIsToldAndTheLogNamesNoPicture) {
    KioskWorld world;
    world.printing.print = [](const TactileMap&, const PrintOrder&, const std::stop_token&) {
        return PrintEnd::no_paper;
    };
    set_printer(world);
    BlindVisitor visitor(world);
    to_picture(world, visitor, "A heart");
    (void)world.kiosk().take_report();
    ASSERT_TRUE(visitor.choose(print)) << visitor.heard();
    ASSERT_TRUE(hears(world, visitor, "The printer has no paper. Please call the staff."))
        << visitor.heard();
    const std::string report = world.kiosk().take_report();
    EXPECT_NE(report.find("print: the printer has no paper; put some in"), std::string::npos)
        << report;
    EXPECT_EQ(report.find("heart"), std::string::npos) << report;
    visitor.press(KeyRole::select);
    EXPECT_TRUE(visitor.find(print)) << "it can be tried again";
}

TEST(PrintedVisit, WhatComesWhileTheOperatorIsInIsToldAfterwards) {
    KioskWorld world;
    set_printer(world);
    BlindVisitor visitor(world);
    to_picture(world, visitor, "A heart");
    ASSERT_TRUE(visitor.choose(print)) << visitor.heard();
    const std::string news = "Your sheet is in the printer.";
    BlindVisitor staff(world, 0.2);
    open_menu(staff);
    ASSERT_TRUE(world.kiosk().is_operator_in()) << staff.heard();
    EXPECT_FALSE(hears(world, staff, news));
    ASSERT_TRUE(staff.choose("Leave")) << staff.heard();
    ASSERT_FALSE(world.kiosk().is_operator_in());
    EXPECT_TRUE(hears(world, staff, news)) << staff.heard();
}

TEST(PrintedVisit, TheVisitGoesOnMeanwhile) {
    KioskWorld world;
    std::atomic<bool> is_held = true;
    world.printing.print = [&](const TactileMap&, const PrintOrder&, const std::stop_token& stop) {
        while (is_held && !stop.stop_requested())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return PrintEnd::printed;
    };
    set_printer(world);
    BlindVisitor visitor(world);
    to_picture(world, visitor, "A heart");
    ASSERT_TRUE(visitor.choose(print)) << visitor.heard();
    ASSERT_TRUE(visitor.choose("Tell me again")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("Another picture")) << visitor.heard();
    EXPECT_LE(visitor.slowest_answer_s(), 0.3);
    is_held = false;
    EXPECT_TRUE(hears(world, visitor, "Your sheet is in the printer.")) << visitor.heard();
}

}  // namespace
}  // namespace touchline
