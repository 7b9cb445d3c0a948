// Tests that the servo's memory is really locked, as read from outside of the real process.
#include "tests/app/force/servo/process_rig.h"

#include <algorithm>
#include <cstdlib>

#include <sys/mman.h>
#include <sys/resource.h>

namespace touchline {
namespace {

constexpr long recording_kB = 27'000;  // for the last minute
constexpr rlim_t MiB = rlim_t{1} << 20U;
constexpr unsigned long cap_sys_resource = 24;  // from capabilities(7)

/// Lifts the limit, as LimitMEMLOCK=infinity does in the servo's unit. Returns false if the user of
/// this test may not lock so much, neither without a limit nor by root's right.
bool lift_limit() {
    const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
    if (setrlimit(RLIMIT_MEMLOCK, &none) == 0) return true;
    constexpr std::size_t much = 64 * MiB;
    void* const memory =
        mmap(nullptr, much, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    const bool is_locked = memory != MAP_FAILED && mlock(memory, much) == 0;
    if (memory != MAP_FAILED) munmap(memory, much);
    if (is_locked) setenv("LD_PRELOAD", TOUCHLINE_GRANTED_LOCK_LIBRARY, 1);
    return is_locked;
}

class LockedMemory : public ProcessRig {
  protected:
    ~LockedMemory() override { unsetenv("LD_PRELOAD"); }

    /// Returns the locked memory of a servo that a kiosk has started, in kB.
    long locked_kB() {
        start_kiosk();
        EXPECT_TRUE(wait_until([&] { return board_.reads > 100; }));
        std::ifstream status("/proc/" + std::to_string(board_.owner) + "/status");
        long locked = -1;
        for (std::string word; status >> word;)
            if (word == "VmLck:") status >> locked;
        EXPECT_EQ(end_kiosk(SIGTERM), 0);
        return locked;
    }
};

TEST_F(LockedMemory, IsAllOfItWithoutALimit) {
    const bool is_lifted = lift_limit();
    const long locked = locked_kB();
    RecordProperty("VmLck_kB", static_cast<int>(locked));
    if (is_lifted) {
        EXPECT_GT(locked, recording_kB);
    } else {
        EXPECT_EQ(locked, 0);
    }
}

/// A large limit is not enough: under any limit, locking later memory would make allocations fail.
TEST_F(LockedMemory, IsNothingWithALimitThatTheServoCannotLift) {
    rlimit limit{};
    ASSERT_EQ(getrlimit(RLIMIT_MEMLOCK, &limit), 0);
    limit.rlim_cur = limit.rlim_max = std::min(limit.rlim_max, 1024 * MiB);
    ASSERT_EQ(setrlimit(RLIMIT_MEMLOCK, &limit), 0);
    (void)prctl(PR_CAPBSET_DROP, cap_sys_resource, 0UL, 0UL, 0UL);
    EXPECT_EQ(locked_kB(), 0);
}

}  // namespace
}  // namespace touchline
