// Tests the sheet to take home: offered where there is a printer, told when it is there, and never
// in the way.
#include "tests/app/visit/fake_world.h"
#include "tests/app/visit/visit_scenes.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr const char* print = "Print to take home";

VisitRules with_printer() {
    VisitRules rules;
    rules.has_printer = true;
    return rules;
}

bool is_offered(const FakeHouse& house) {
    const SpokenScreen screen = house.screen();
    return std::ranges::find(screen.items, print, &ScreenItem::name) != screen.items.end();
}

std::string last_sentence(const FakeHouse& house) {
    return house.transcript.back().text;
}

TEST(Visit, ASheetIsOfferedOnlyWhereItCanBePrinted) {
    FakeHouse without;
    to_picture(without);
    EXPECT_FALSE(is_offered(without));
    FakeHouse house(with_printer());
    to_picture(house);
    EXPECT_TRUE(is_offered(house));
    house.visit.visitor.felt->facts.outline_count = 0;
    EXPECT_FALSE(is_offered(house)) << "there is no line to print";
}

TEST(Visit, ASheetIsPrintedWhileTheVisitGoesOn) {
    FakeHouse house(with_printer());
    to_picture(house);
    ASSERT_TRUE(house.choose(print));
    EXPECT_EQ(house.last<PrintSheet>().size(), 1U);
    EXPECT_EQ(last_sentence(house), "Printing. You can carry on meanwhile.");
    EXPECT_EQ(house.open(), VisitScreen::picture);
    ASSERT_TRUE(house.choose("Parts"));
    house.wait(house.print_s + 0.1);
    EXPECT_EQ(house.open(), VisitScreen::parts);
    EXPECT_TRUE(house.has_said("Your sheet is in the printer.", 0));
    house.press(KeyRole::repeat);
    EXPECT_EQ(last_sentence(house), "Your sheet is in the printer.");
}

TEST(Visit, ASheetIsToldOnceNoKeyWouldCutItOff) {
    FakeHouse house(with_printer());
    to_picture(house);
    ASSERT_TRUE(house.choose(print));
    const std::size_t from = house.transcript.size();
    for (int i = 0; i < 10; ++i) {
        house.press(KeyRole::down);
        house.wait(2.5);
    }
    EXPECT_FALSE(house.has_said("in the printer", from)) << "the next key would have cut it off";
    for (int i = 0; i < 2; ++i) {  // a key may have cut it off
        const std::size_t quiet = house.transcript.size();
        house.wait(4.0);
        EXPECT_TRUE(house.has_said("Your sheet is in the printer.", quiet)) << i;
        house.press(KeyRole::down);
        house.wait(1.0);
    }
    const std::size_t after = house.transcript.size();
    house.wait(5.0);
    EXPECT_FALSE(house.has_said("in the printer", after)) << "twice is enough";
    ASSERT_TRUE(house.find(print));
    EXPECT_NE(last_sentence(house).find("1 sheet printed"), std::string::npos);
}

TEST(Visit, OneSheetAtATimeAndThreeAVisit) {
    FakeHouse house(with_printer());
    to_picture(house);
    for (int i = 0; i < most_sheets; ++i) {
        ASSERT_TRUE(house.choose(print));
        house.press(KeyRole::select);
        EXPECT_EQ(last_sentence(house), "Your sheet is being printed.");
        EXPECT_TRUE(house.last<PrintSheet>().empty());
        house.wait(house.print_s + 0.1);
    }
    house.press(KeyRole::select);
    EXPECT_EQ(last_sentence(house), "One visit can print 3 sheets, and no more.");
    EXPECT_TRUE(house.last<PrintSheet>().empty());
    finish(house);
    to_picture(house);
    ASSERT_TRUE(house.choose(print)) << "the next visitor has three again";
    EXPECT_EQ(house.last<PrintSheet>().size(), 1U);
}

TEST(Visit, ER1_ASheetThatFailsSaysWhyAndCanBeTriedAgain) {
    std::set<std::string> told;
    for (int i = 1; i < print_end_count; ++i) {
        const auto end = static_cast<PrintEnd>(i);
        if (end == PrintEnd::not_removed) continue;  // it is printed
        FakeHouse house(with_printer());
        house.print_end = end;
        to_picture(house);
        ASSERT_TRUE(house.choose(print));
        house.wait(house.print_s + 0.1);
        ASSERT_EQ(house.open(), VisitScreen::trouble) << i;
        told.insert(house.screen().text);
        house.press(KeyRole::select);
        EXPECT_EQ(house.open(), VisitScreen::picture);
        EXPECT_TRUE(house.visit.visitor.felt.has_value());
        ASSERT_TRUE(house.choose(print));
        EXPECT_EQ(house.last<PrintSheet>().size(), 1U);
    }
    EXPECT_GE(told.size(), 8U);
    EXPECT_EQ(told.count(""), 0U);
}

/// A visitor whose sheet will fail for lack of paper.
void order_failing_sheet(FakeHouse& house) {
    house.print_end = PrintEnd::no_paper;
    to_picture(house);
    ASSERT_TRUE(house.choose(print));
}

bool shows_no_paper(const FakeHouse& house) {
    return house.open() == VisitScreen::trouble &&
           house.screen().text.find("no paper") != std::string::npos;
}

TEST(Visit, ER1_ASheetThatFailsCoversNoTroubleOfTheHandle) {
    FakeHouse house(with_printer());
    order_failing_sheet(house);
    house.apply(TroubleBegan{TroubleKind::device, "The force is off. Let go of the handle."});
    house.wait(house.print_s + 1.0);
    EXPECT_EQ(house.visit.visitor.trouble, TroubleKind::device);
    EXPECT_NE(house.screen().text.find("The force is off."), std::string::npos);
    house.apply(TroubleEnded{TroubleKind::device});
    house.wait(0.2);
    EXPECT_TRUE(shows_no_paper(house));
}

TEST(Visit, ER1_ASheetThatFailsCoversNoHelpAndNoQuestion) {
    FakeHouse house(with_printer());
    order_failing_sheet(house);
    house.press(KeyRole::help);
    const VisitScreen open = house.open();
    ASSERT_EQ(open, VisitScreen::help);
    house.wait(house.print_s + 1.0);
    EXPECT_EQ(house.open(), open);
    house.press(KeyRole::help);
    house.wait(5.0);
    EXPECT_TRUE(shows_no_paper(house));
}

TEST(Visit, ER1_ASheetThatFailsWaitsUntilTheHandleNoLongerLeads) {
    FakeHouse house(with_printer());
    order_failing_sheet(house);
    house.lead_s = 30.0;
    ASSERT_TRUE(house.choose("Guide me along the largest outline"));
    house.wait(house.print_s + 10.0);
    EXPECT_TRUE(house.is_leading);
    EXPECT_EQ(house.open(), VisitScreen::picture);
    house.wait(30.0);
    EXPECT_TRUE(shows_no_paper(house));
}

TEST(Visit, ER1_WhoeverPrintsAgainHearsFirstWhyASheetFailed) {
    FakeHouse house(with_printer());
    order_failing_sheet(house);
    for (int i = 0; i < 3; ++i) {
        house.wait(2.0);
        house.press(KeyRole::repeat);
    }
    ASSERT_EQ(house.open(), VisitScreen::picture);
    house.press(KeyRole::select);
    EXPECT_TRUE(shows_no_paper(house));
    EXPECT_TRUE(house.last<PrintSheet>().empty());
}

TEST(Visit, ER1_GoodbyeSaysWhyASheetDidNotCome) {
    FakeHouse house(with_printer());
    order_failing_sheet(house);
    for (int i = 0; i < 3; ++i) {
        house.wait(2.0);
        house.press(KeyRole::repeat);
    }
    finish(house);
    ASSERT_EQ(house.open(), VisitScreen::goodbye);
    EXPECT_NE(house.screen().text.find("The printer has no paper."), std::string::npos);
    EXPECT_EQ(house.screen().text.find("Take your sheet"), std::string::npos);
}

/// A visit is silent while the operator is in.
TEST(Visit, ASheetIsToldOnceTheOperatorHasLeft) {
    for (const PrintEnd end : {PrintEnd::printed, PrintEnd::no_paper}) {
        FakeHouse house(with_printer());
        house.print_end = end;
        to_picture(house);
        ASSERT_TRUE(house.choose(print));
        const std::string news = end == PrintEnd::printed ? "in the printer" : "no paper";
        const std::size_t from = house.transcript.size();
        house.rules.is_operator_in = true;
        house.wait(house.print_s + 20.0);
        EXPECT_FALSE(house.has_said(news, from));
        house.rules.is_operator_in = false;
        house.wait(0.2);
        EXPECT_TRUE(house.has_said(news, from)) << news;
    }
}

TEST(Visit, TI2_TheNextVisitorHearsNothingOfASheet) {
    for (const PrintEnd end : {PrintEnd::printed, PrintEnd::no_paper}) {
        FakeHouse house(with_printer());
        house.print_end = end;
        house.print_s = 60.0;
        to_picture(house);
        ASSERT_TRUE(house.choose(print));
        finish(house);
        EXPECT_NE(house.screen().text.find("Your sheet is still being printed."),
                  std::string::npos);
        EXPECT_EQ(house.screen().text.find("Take your sheet"), std::string::npos);
        to_picture(house);
        ASSERT_TRUE(house.choose(print));
        EXPECT_EQ(last_sentence(house), "The printer is busy. Please try again in a minute.");
        EXPECT_TRUE(house.last<PrintSheet>().empty());
        const std::size_t from = house.transcript.size();
        house.wait(house.print_s);
        EXPECT_FALSE(house.has_said("sheet", from));
        EXPECT_EQ(house.open(), VisitScreen::picture);
        ASSERT_TRUE(house.choose(print));
        EXPECT_EQ(house.last<PrintSheet>().size(), 1U);
    }
}

TEST(Visit, TI6_GoodbyeTellsOfNoSheetThatIsNotThere) {
    FakeHouse house(with_printer());
    to_picture(house);
    finish(house);
    EXPECT_EQ(house.screen().text.find("sheet"), std::string::npos);
}

}  // namespace
}  // namespace touchline
