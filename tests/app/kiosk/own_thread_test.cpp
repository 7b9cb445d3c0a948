// Tests work on a thread of its own, also on a machine that has none left.
#include "app/kiosk/own_thread.h"

#include "tests/config/no_threads.h"

#include <new>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::string done_beside() {
    return on_own_thread([] { return std::string("done"); }, "failed").get();
}

TEST(OwnThread, EndsAsTheWorkDoes) {
    EXPECT_EQ(done_beside(), "done");
}

TEST(OwnThread, FailsWithoutAThreadAndTheKioskGoesOn) {
    const NoThreads none;
    EXPECT_EQ(done_beside(), "failed");
}

TEST(OwnThread, FailsWhereMemoryRunsOut) {
    const auto work = []() -> std::string { throw std::bad_alloc(); };
    EXPECT_EQ(on_own_thread(work, "failed").get(), "failed");
}

}  // namespace
}  // namespace touchline
