#include "haptics/servo/real_time.h"

#include <string>

#include <grp.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchline {
namespace {

TEST(RealTimeTier, OfTheLastMinuteIsTheOneGrantedOrTooLate) {
    for (const RealTimeTier granted :
         {RealTimeTier::real_time, RealTimeTier::fifo, RealTimeTier::best_effort}) {
        EXPECT_EQ(judge(granted, {0, 0}, 1e-3), granted);
        EXPECT_EQ(judge(granted, {60, 0}, 1e-3), granted);  // 0.1 % of 60 000
        EXPECT_EQ(judge(granted, {61, 0}, 1e-3), RealTimeTier::too_late);
        EXPECT_EQ(judge(granted, {0, 1}, 1e-3), RealTimeTier::too_late);
        EXPECT_EQ(judge(granted, {120, 0}, 5e-4), granted);
        EXPECT_EQ(judge(granted, {121, 0}, 5e-4), RealTimeTier::too_late);
    }
}

TEST(RealTimeTier, NoTierAllowsMoreThanABetterOne) {
    EXPECT_EQ(limits_of(RealTimeTier::real_time).force_share, 1.0);
    EXPECT_EQ(limits_of(RealTimeTier::fifo).stiffness_share, 1.0);
    EXPECT_EQ(limits_of(RealTimeTier::best_effort).force_share, 0.5);
    EXPECT_EQ(limits_of(RealTimeTier::best_effort).stiffness_share, 0.5);
    EXPECT_GT(limits_of(RealTimeTier::best_effort).extra_damping_Ns_per_m, 0.0);
    EXPECT_EQ(limits_of(RealTimeTier::too_late).force_share, 0.0);
}

TEST(RealTimeTier, EachHasWordsThatBeginWithItsLetter) {
    char letter = 'A';
    for (const RealTimeTier tier : {RealTimeTier::real_time, RealTimeTier::fifo,
                                    RealTimeTier::best_effort, RealTimeTier::too_late}) {
        EXPECT_EQ(describe(tier).substr(0, 2), std::string(1, letter++) + ",");
    }
}

/// In a process of its own: as nobody, where this may change who it is, and without the right to
/// real-time priority in any case.
int tier_of_an_ordinary_user() {
    const pid_t child = fork();
    if (child == 0) {
        const rlimit none{0, 0};
        constexpr unsigned nobody = 65534;
        bool is_ordinary = setrlimit(RLIMIT_RTPRIO, &none) == 0;
        if (geteuid() == 0) {
            is_ordinary = is_ordinary && setgroups(0, nullptr) == 0 &&
                          setresgid(nobody, nobody, nobody) == 0 &&
                          setresuid(nobody, nobody, nobody) == 0;
        }
        _exit(is_ordinary ? static_cast<int>(become_real_time(MemoryLock::as_touched)) : 99);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(RealTimeTier, OfAnOrdinaryUserIsC) {
    EXPECT_EQ(tier_of_an_ordinary_user(), static_cast<int>(RealTimeTier::best_effort));
}

}  // namespace
}  // namespace touchline
