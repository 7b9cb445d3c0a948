// Tests a real CUPS with a real spool: what is printed arrives, and nothing of it stays.
#include "app/printing/printing.h"

#include "app/isolation/process/child.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/process/places.h"
#include "app/printing/cups_job.h"
#include "tests/app/printing/own_cups.h"
#include "tests/app/sheets/sheet_maps.h"
#include "tests/app/signal_one.h"

#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace touchline {
namespace {

using namespace std::chrono_literals;

const std::string sheet = "%PDF-1.4\nthe sheet of a visitor\n%%EOF\n";

/// Short, so that the test is.
constexpr PrintPatience impatient{
    .answer_s = 1.0, .trouble_s = 0.5, .job_s = 5.0, .service_s = 2.0, .poll_s = 0.05};

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

class Printing : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_FALSE(OwnCups::program().empty()) << "the package cups-daemon is not installed";
    }

    [[nodiscard]] static PrintEnd print(const OwnCups& cups, const std::string& queue,
                                        const PrintPatience& patience = impatient) {
        return print_by_cups({cups.socket(), queue}, std::as_bytes(std::span(sheet)), SheetKind::a4,
                             patience);
    }

    [[nodiscard]] static PrintEnd check(const OwnCups& cups, const std::string& queue) {
        return check_at_cups({cups.socket(), queue}, impatient);
    }
};

/// Not in any file that CUPS keeps.
void expect_no_sheet_left(const OwnCups& cups) {
    EXPECT_EQ(cups.files_with("sheet of a visitor"), std::vector<std::string>());
}

void expect_nothing_left(const OwnCups& cups) {
    EXPECT_EQ(cups.spooled(), std::vector<std::string>());
    expect_no_sheet_left(cups);
}

TEST_F(Printing, TI4_WhatIsPrintedArrivesAndNothingOfItStays) {
    const OwnCups cups;  // it keeps all it can
    EXPECT_EQ(print(cups, "good"), PrintEnd::printed);
    EXPECT_EQ(cups.printed(), sheet);
    expect_nothing_left(cups);
}

TEST_F(Printing, TI4_ACupsThatKeepsNothingPrintsAsWell) {
    const OwnCups cups(CupsKeeps::nothing);
    EXPECT_EQ(print(cups, "good"), PrintEnd::printed);
    EXPECT_EQ(cups.printed(), sheet);
    expect_nothing_left(cups);
}

TEST_F(Printing, TI4_TroubleOfThePrinterIsToldSoonAndLeavesNothing) {
    struct Case {
        const char* queue;
        PrintEnd end;
    };

    for (const Case& each :
         {Case{"empty", PrintEnd::no_paper}, Case{"jammed", PrintEnd::needs_hand},
          Case{"unplugged", PrintEnd::offline}, Case{"broken", PrintEnd::failed},
          Case{"paused", PrintEnd::paused}, Case{"closed", PrintEnd::refused},
          Case{"nowhere", PrintEnd::unknown}}) {
        const OwnCups cups;
        const auto start = std::chrono::steady_clock::now();
        EXPECT_EQ(print(cups, each.queue), each.end) << each.queue;
        EXPECT_LT(seconds_since(start), 4.0) << each.queue;
        EXPECT_EQ(cups.printed(), "") << each.queue;
        expect_nothing_left(cups);
    }
}

TEST_F(Printing, TI4_AJobThatTakesTooLongIsTakenBack) {
    const OwnCups cups;
    PrintPatience short_job = impatient;
    short_job.job_s = 0.5;
    EXPECT_EQ(print(cups, "slow", short_job), PrintEnd::out_of_time);
    expect_nothing_left(cups);
}

/// One that is killed while it writes leaves half a list of its jobs, which knows no sheet.
TEST_F(Printing, TI4_ACupsThatDiesHalfwayIsCleanedAtTheNextCheck) {
    OwnCups cups;
    PrintEnd end = PrintEnd::printed;
    const auto start = std::chrono::steady_clock::now();
    std::jthread printing([&] { end = print(cups, "slow"); });
    ASSERT_TRUE(cups.is_printing());
    cups.kill();
    printing.join();
    EXPECT_EQ(end, PrintEnd::no_answer);
    EXPECT_LT(seconds_since(start), 8.0);
    EXPECT_NE(cups.files_with("sheet of a visitor"), std::vector<std::string>());
    cups.start();
    EXPECT_EQ(check(cups, "slow"), PrintEnd::printed);
    expect_no_sheet_left(cups);
}

TEST_F(Printing, TI4_ACupsThatComesBackIsCleanedAtOnce) {
    OwnCups cups;
    PrintPatience patient = impatient;
    patient.service_s = 20.0;
    PrintEnd end = PrintEnd::printed;
    std::jthread printing([&] { end = print(cups, "slow", patient); });
    ASSERT_TRUE(cups.is_printing());
    cups.kill();
    cups.start();
    printing.join();
    EXPECT_EQ(end, PrintEnd::no_answer);
    expect_no_sheet_left(cups);
}

/// A site's rules may let nobody remove jobs. Then one sheet stays, and no second one follows it.
TEST_F(Printing, TI4_WhereSheetsCannotBeRemovedNoMoreArePrinted) {
    const OwnCups cups(CupsKeeps::for_good);
    EXPECT_EQ(check(cups, "good"), PrintEnd::printed) << "nothing is there yet";
    EXPECT_EQ(print(cups, "good"), PrintEnd::not_removed);
    const std::string told = cups.told();
    EXPECT_EQ(check(cups, "good"), PrintEnd::not_cleared);
    EXPECT_EQ(print(cups, "good"), PrintEnd::not_cleared);
    EXPECT_EQ(cups.told(), told) << "nothing was printed";
}

TEST_F(Printing, WithoutCupsOneKnowsAtOnce) {
    const CupsQueue nowhere{"/nowhere/cups.sock", "good"};
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(check_at_cups(nowhere, impatient), PrintEnd::no_service);
    EXPECT_EQ(print_by_cups(nowhere, std::as_bytes(std::span(sheet)), SheetKind::a4, impatient),
              PrintEnd::no_service);
    EXPECT_LT(seconds_since(start), 2.0);
}

/// It listens, and says nothing.
TEST_F(Printing, ACupsThatNeverAnswersIsGivenUp) {
    const std::string path =
        (std::filesystem::temp_directory_path() / ("deaf-" + std::to_string(getpid()))).string();
    unlink(path.c_str());
    const Descriptor deaf(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    ASSERT_EQ(bind(deaf.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    ASSERT_EQ(listen(deaf.number(), 8), 0);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(check_at_cups({path, "good"}, impatient), PrintEnd::no_answer);
    EXPECT_EQ(
        print_by_cups({path, "good"}, std::as_bytes(std::span(sheet)), SheetKind::a4, impatient),
        PrintEnd::no_answer);
    EXPECT_LT(seconds_since(start), 10.0);
    unlink(path.c_str());
}

TEST_F(Printing, ACheckTellsWhatThePrinterLacks) {
    const OwnCups cups;
    EXPECT_EQ(check(cups, "good"), PrintEnd::printed);
    EXPECT_EQ(check(cups, "paused"), PrintEnd::paused);
    EXPECT_EQ(check(cups, "closed"), PrintEnd::refused);
    EXPECT_EQ(check(cups, "nowhere"), PrintEnd::unknown);
}

/// Through both programs, as the kiosk does.
class PrintedMap : public Printing {
  protected:
    PrintedMap() { setenv("CUPS_SERVER", cups_.socket().c_str(), 1); }

    ~PrintedMap() override { unsetenv("CUPS_SERVER"); }

    [[nodiscard]] PrintEnd print_as(SheetKind kind, const std::string& language,
                                    const std::string& queue = "good") const {
        const TactileMap map = map_of_lines({line_through({{-30, -20}, {30, 20}}, 1, "the tail"),
                                             ring_through({{0, 25}, {20, 30}})},
                                            "My holiday");
        return print_map(map, {queue, kind, language}, programs_, {});
    }

    OwnCups cups_;
    PrintPrograms programs_{companion("touchline-sheet"), companion("touchline-print"),
                            TOUCHLINE_CATALOGUES};
};

TEST_F(PrintedMap, TI4_ASheetOfEachKindIsPrintedAndNothingOfItStays) {
    EXPECT_EQ(print_as(SheetKind::a4, "en"), PrintEnd::printed);
    EXPECT_TRUE(cups_.printed().starts_with("%PDF-"));
    EXPECT_EQ(print_as(SheetKind::letter, "de"), PrintEnd::printed);
    EXPECT_TRUE(cups_.printed().starts_with("%PDF-"));
    EXPECT_EQ(print_as(SheetKind::embosser, "en"), PrintEnd::printed);
    EXPECT_NE(cups_.printed().find("MY HOLIDAY"), std::string::npos) << cups_.printed();
    EXPECT_EQ(cups_.spooled(), std::vector<std::string>());
    EXPECT_EQ(cups_.files_with("MY HOLIDAY"), std::vector<std::string>());
}

/// A job's title stands in CUPS's lists and logs.
TEST_F(PrintedMap, TI4_TheJobSaysNothingOfThePicture) {
    EXPECT_EQ(print_as(SheetKind::a4, "en"), PrintEnd::printed);
    EXPECT_TRUE(cups_.told().starts_with("touchline|Touchline|")) << cups_.told();
    EXPECT_EQ(cups_.told().find("holiday"), std::string::npos) << cups_.told();
    EXPECT_EQ(cups_.files_with("holiday"), std::vector<std::string>());
    EXPECT_EQ(cups_.printed().find("holiday"), std::string::npos) << "in the PDF's own title";
}

/// Tracing names lines in English, and only by kind where there is paper.
TEST_F(PrintedMap, WhatTracingNamesIsPrintedInTheLanguage) {
    const TactileMap map =
        map_of_lines({line_through({{-30, -20}, {30, 20}}, 1, "dashed line, middle"),
                      ring_through({{0, 25}, {20, 30}}, 1, "left eye")},
                     "Ein Bild");
    EXPECT_EQ(print_map(map, {"good", SheetKind::embosser, "de"}, programs_, {}),
              PrintEnd::printed);
    EXPECT_EQ(cups_.printed().find("DASHED"), std::string::npos) << cups_.printed();
    EXPECT_NE(cups_.printed().find("GESTRICHELTE LINIE"), std::string::npos) << cups_.printed();
}

/// A queue may print on both sides, and fit what it gets to its own paper.
TEST_F(PrintedMap, ASheetIsPrintedOnOneSideInItsOwnSize) {
    EXPECT_EQ(print_as(SheetKind::letter, "en"), PrintEnd::printed);
    for (const char* each : {"sides=one-sided", "print-scaling=none", "media=na_letter_8.5x11in"})
        EXPECT_NE(cups_.told().find(each), std::string::npos) << cups_.told();
    EXPECT_EQ(print_as(SheetKind::a4, "en"), PrintEnd::printed);
    EXPECT_NE(cups_.told().find("media=iso_a4_210x297mm"), std::string::npos) << cups_.told();
}

TEST_F(PrintedMap, AnEmbosserIsToldNothingButItsBytes) {
    EXPECT_EQ(print_as(SheetKind::embosser, "en"), PrintEnd::printed);
    EXPECT_EQ(cups_.told().find("sides"), std::string::npos) << cups_.told();
    EXPECT_EQ(cups_.told().find("media"), std::string::npos) << cups_.told();
}

TEST_F(PrintedMap, WhatCannotBePrintedIsToldByTheProgramsToo) {
    EXPECT_EQ(print_as(SheetKind::a4, "en", "nowhere"), PrintEnd::unknown);
    EXPECT_EQ(check_printer("good", programs_, {}), PrintEnd::printed);
    EXPECT_EQ(print_map({}, {"good", SheetKind::a4, "en"}, programs_, {}), PrintEnd::no_sheet);
    EXPECT_EQ(check_printer("good", {"/nowhere/sheet", "/nowhere/print", ""}, {}),
              PrintEnd::not_started);
}

/// The kiosk ends while the printer works.
TEST_F(PrintedMap, OnceStoppedItWaitsNoLonger) {
    std::stop_source stop;
    std::jthread stopping([&] {
        EXPECT_TRUE(cups_.is_printing());
        stop.request_stop();
    });
    const auto start = std::chrono::steady_clock::now();
    const TactileMap map = map_of_lines({line_through({{-30, -20}, {30, 20}})});
    EXPECT_EQ(print_map(map, {"slow", SheetKind::a4, "en"}, programs_, stop.get_token()),
              PrintEnd::out_of_time);
    EXPECT_LT(seconds_since(start), 15.0);
    EXPECT_EQ(check_printer("slow", programs_, {}), PrintEnd::printed);  // ends that job
    EXPECT_EQ(cups_.spooled(), std::vector<std::string>());
}

TEST_F(PrintedMap, OnceStoppedNothingMoreIsSentToThePrinter) {
    std::stop_source stop;
    stop.request_stop();
    const TactileMap map = map_of_lines({line_through({{-30, -20}, {30, 20}})});
    EXPECT_EQ(print_map(map, {"good", SheetKind::a4, "en"}, programs_, stop.get_token()),
              PrintEnd::out_of_time);
    EXPECT_EQ(check_printer("good", programs_, {}), PrintEnd::printed);
    EXPECT_EQ(cups_.told(), "");
}

/// A service that is stopped signals all of its programs.
TEST_F(PrintedMap, TI4_AskedToEndItTakesItsJobBack) {
    const auto memory = sealed_copy(std::as_bytes(std::span(sheet)));
    ASSERT_TRUE(memory.has_value());
    const std::array<const Descriptor*, 1> handed{&*memory};
    auto child = Child::start(programs_.print, {"print", "slow", "0"}, handed);
    ASSERT_TRUE(child.has_value());
    ASSERT_TRUE(cups_.is_printing());
    const auto start = std::chrono::steady_clock::now();
    signal_one(child->pid(), SIGTERM);
    EXPECT_TRUE(child->ends_within(8.0));
    EXPECT_EQ(print_end_of(child->reap().status), PrintEnd::out_of_time);
    EXPECT_LT(seconds_since(start), 8.0);
    expect_nothing_left(cups_);
}

TEST(PrintEnds, EachHasAStatusAndALineOfItsOwn) {
    std::vector<std::string_view> lines;
    for (int i = 0; i < print_end_count; ++i) {
        const auto end = static_cast<PrintEnd>(i);
        EXPECT_EQ(print_end_of(print_status_of(end)), end);
        EXPECT_FALSE(line_of(end).empty());
        EXPECT_EQ(std::ranges::count(lines, line_of(end)), 0) << line_of(end);
        lines.push_back(line_of(end));
    }
    EXPECT_EQ(print_end_of(0), std::nullopt);
    EXPECT_EQ(print_end_of(first_print_status + print_end_count), std::nullopt);
}

}  // namespace
}  // namespace touchline
