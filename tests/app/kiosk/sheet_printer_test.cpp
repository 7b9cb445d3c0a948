// Tests how a kiosk uses its printer: one thing at a time, and looks at the queue now and then.
#include "app/kiosk/sheet_printer.h"

#include "tests/config/no_threads.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <new>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Waits as long as the test wants it to.
struct FakePrinter {
    std::atomic<int> checks = 0;
    std::atomic<int> sheets = 0;
    std::atomic<bool> is_held = false;
    std::atomic<PrintEnd> end = PrintEnd::printed;
    std::atomic<bool> has_no_memory = false;
    std::mutex lock;
    std::vector<std::string> looked_at;  // since it was emptied

    [[nodiscard]] PrintEnd work(std::atomic<int>& count, const std::stop_token& stop) {
        while (is_held && !stop.stop_requested())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ++count;
        if (has_no_memory) throw std::bad_alloc();
        return end;
    }

    [[nodiscard]] std::vector<std::string> take_looked_at() {
        const std::lock_guard guard(lock);
        return std::exchange(looked_at, {});
    }

    [[nodiscard]] Printing printing() {
        return {[this](const TactileMap&, const PrintOrder&, const std::stop_token& stop) {
                    return work(sheets, stop);
                },
                [this](const std::string& queue, const std::stop_token& stop) {
                    const std::lock_guard guard(lock);
                    looked_at.push_back(queue);
                    return work(checks, stop);
                }};
    }
};

PrintOrder sheet_at(const std::string& queue) {
    return {queue, SheetKind::a4, "en"};
}

/// Steps at that time until the work that has begun is over.
std::optional<PrintEnd> settle(SheetPrinter& printer, const std::string& queue, double now_s,
                               bool is_watched = false) {
    std::optional<PrintEnd> end;
    for (int i = 0; i < 100; ++i) {
        if (const auto one = printer.step(queue, now_s, is_watched)) end = one;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return end;
}

TEST(SheetPrinter, TheQueueIsLookedAtAtTheStartAndNowAndThen) {
    FakePrinter fake;
    SheetPrinter printer(fake.printing());
    EXPECT_EQ(settle(printer, "", 0.0), std::nullopt);
    EXPECT_EQ(fake.checks, 0) << "there is no printer";
    fake.end = PrintEnd::no_paper;
    EXPECT_EQ(settle(printer, "sheets", 1.0), std::nullopt);
    EXPECT_EQ(fake.checks, 1);
    EXPECT_EQ(printer.condition(), PrintEnd::no_paper);
    (void)settle(printer, "sheets", 200.0);
    EXPECT_EQ(fake.checks, 1);
    (void)settle(printer, "sheets", 200.0, true);
    EXPECT_EQ(fake.checks, 2) << "somebody looks at it";
    (void)settle(printer, "sheets", 501.0);
    EXPECT_EQ(fake.checks, 3);
    (void)settle(printer, "other", 502.0);
    EXPECT_EQ(fake.checks, 4);
    (void)settle(printer, "", 503.0);
    EXPECT_EQ(printer.condition(), std::nullopt);
}

TEST(SheetPrinter, ASheetWaitsForALookAndIsFollowedByOne) {
    FakePrinter fake;
    fake.is_held = true;
    SheetPrinter printer(fake.printing());
    (void)printer.step("sheets", 0.0, false);  // looks
    printer.print({}, sheet_at("sheets"));
    EXPECT_EQ(settle(printer, "sheets", 1.0), std::nullopt);
    EXPECT_EQ(fake.sheets, 0);
    fake.end = PrintEnd::no_answer;
    fake.is_held = false;
    EXPECT_EQ(settle(printer, "sheets", 2.0), PrintEnd::no_answer);
    EXPECT_EQ(fake.sheets, 1);
    EXPECT_EQ(fake.checks, 2) << "what the sheet left is removed";
    EXPECT_EQ(settle(printer, "sheets", 3.0), std::nullopt) << "told once";
}

/// Another name in the settings leaves nothing of a visitor in the queue before.
TEST(SheetPrinter, TI4_TheQueueBeforeIsLookedAtUntilItIsClear) {
    using Queues = std::vector<std::string>;
    FakePrinter fake;
    SheetPrinter printer(fake.printing());
    fake.end = PrintEnd::no_answer;
    printer.print({}, sheet_at("old"));
    EXPECT_EQ(settle(printer, "old", 0.0), PrintEnd::no_answer);
    EXPECT_EQ(fake.take_looked_at(), Queues{"old"});
    (void)settle(printer, "new", 1.0);
    EXPECT_EQ(fake.take_looked_at(), (Queues{"new", "old"}));
    EXPECT_EQ(printer.condition(), PrintEnd::no_answer);
    (void)settle(printer, "new", 200.0);
    EXPECT_EQ(fake.take_looked_at(), Queues());
    fake.end = PrintEnd::no_paper;  // which tells that nothing is left
    (void)settle(printer, "", 400.0);
    EXPECT_EQ(fake.take_looked_at(), Queues{"old"});
    EXPECT_EQ(printer.condition(), std::nullopt) << "of no queue of the settings";
    (void)settle(printer, "", 800.0);
    EXPECT_EQ(fake.take_looked_at(), Queues());
}

TEST(SheetPrinter, AThreadThatFailsIsAnEndToo) {
    FakePrinter fake;
    fake.has_no_memory = true;
    SheetPrinter printer(fake.printing());
    printer.print({}, sheet_at("sheets"));
    EXPECT_EQ(settle(printer, "sheets", 0.0), PrintEnd::not_started);
    EXPECT_EQ(printer.condition(), PrintEnd::not_started);
}

TEST(SheetPrinter, AThreadThatCannotStartIsAnEndToo) {
    FakePrinter fake;
    SheetPrinter printer(fake.printing());
    {
        const NoThreads none;
        printer.print({}, sheet_at("sheets"));
        EXPECT_EQ(settle(printer, "sheets", 0.0), PrintEnd::not_started);
        EXPECT_EQ(printer.condition(), PrintEnd::not_started);
    }
    EXPECT_EQ(fake.sheets, 0);
    EXPECT_EQ(fake.checks, 0);
    (void)settle(printer, "sheets", SheetPrinter::check_every_s);
    EXPECT_EQ(printer.condition(), PrintEnd::printed) << "once there is a thread again";
}

TEST(SheetPrinter, EndsWhileASheetIsPrinted) {
    FakePrinter fake;
    fake.is_held = true;
    const auto start = std::chrono::steady_clock::now();
    {
        SheetPrinter printer(fake.printing());
        printer.print({}, sheet_at("sheets"));
        (void)printer.step("sheets", 0.0, false);
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

}  // namespace
}  // namespace touchline
