// With its memory locked the tick causes no page fault. Runs in a process of its own, so that the
// lock and the priority end with it.

#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/servo/real_time.h"
#include "haptics/servo/servo_loop.h"
#include "tests/haptics/servo/crossing_hand.h"
#include "tests/haptics/servo/rigs.h"

#include <cstdint>
#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr int unarmed_ticks = 200;  // the arm rule allows no force yet: first calls may fault
constexpr int ticks = unarmed_ticks + 100'000;

/// Counts over 10^5 ticks. This thread makes the scenes that come meanwhile, which do not count.
std::int64_t faults_in_ticks() {
    SimulatedPantograph device(default_profile(), {}, to_and_fro(200, 0.01));
    ServoExchange exchange;
    Recorder recorder(10'000);
    ServoLoop loop(device, default_profile(), 1e-3, exchange, recorder);
    std::int64_t faults = 0;
    for (int k = 0; k < ticks; ++k) {
        if (k % 5000 == 0) exchange.feel(wave_scene(1e-7 * k));
        const std::int64_t before = faults_of_this_thread();
        loop.tick(k * 1e-3, 0);
        if (k >= unarmed_ticks) faults += faults_of_this_thread() - before;
    }
    return faults;
}

TEST(Tick, MeetsNoPageFaultInAHundredThousandTicks) {
    const pid_t child = fork();
    if (child == 0) {
        (void)become_real_time(MemoryLock::whole);
        _exit(faults_in_ticks() == 0 ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
}

TEST(Tick, PageFaultsAreCounted) {
    const std::int64_t before = faults_of_this_thread();
    const std::vector<char> fresh(64 << 20, 1);
    EXPECT_GT(faults_of_this_thread(), before + 10);
}

}  // namespace
}  // namespace touchline
