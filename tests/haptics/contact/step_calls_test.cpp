// A step of the contact machine allocates nothing, locks nothing and makes no system call, in a
// million steps on 65536 segments, at level 0 and at the level that the hand's speed asks for. Not
// built with the sanitizers, which do all three themselves.
#include "haptics/contact/contact_machine.h"
#include "haptics/resolution/level_rule.h"
#include "tests/haptics/call_counts.h"
#include "tests/haptics/tick.h"
#include "tests/lab/bench/workload.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include <gtest/gtest.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr std::size_t steps = 1000000;
enum class Level { finest, by_speed };

struct Felt {
    std::size_t contacts = 0;
    std::size_t changes_of_level = 0;
};

/// The peer workload's hand: goes from beginning to end and back.
class LongHand {
  public:
    LongHand() : places_(workload::hand(workload::Kind::radial)) {}

    [[nodiscard]] Position at(std::size_t step) const {
        const std::size_t turn = 2 * (places_.size() - 1);
        const std::size_t k = step % turn;
        return places_[k < places_.size() ? k : turn - k];
    }

  private:
    std::vector<Position> places_;
};

class StepCalls : public testing::TestWithParam<Level> {
  protected:
    Felt run() {
        ContactMachine& machine = *machine_;
        LevelLimits limits;
        limits.spacing_m = scene_.curves.finest_spacing_m();
        limits.encoder_step_m = 0.0;
        LevelRule rule(limits);
        Felt felt;
        machine.reset(scene_, hand_.at(0), 0.0);
        for (std::size_t i = 0; i < steps; ++i) {
            const Position handle = hand_.at(i);
            const double wanted = rule.step(handle, tick_s);
            const double level = GetParam() == Level::finest ? 0.0 : wanted;
            const double before = machine.rendered_level();
            const ContactReport report = machine.step(handle, level, {}, {});
            felt.contacts += report.state != ContactState::free ? 1U : 0U;
            felt.changes_of_level += machine.rendered_level() != before ? 1U : 0U;
        }
        return felt;
    }

    void expect_felt(const Felt& felt) const {
        EXPECT_GT(felt.contacts, steps / 10);
        if (GetParam() == Level::by_speed) {
            EXPECT_GT(felt.changes_of_level, 10U);
        }
    }

  private:
    Scene scene_ =
        build_scene(workload::map_of(workload::curve(workload::Kind::radial, 65536)), {}, 0.0)
            .value();
    LongHand hand_;
    std::unique_ptr<ContactMachine> machine_ = std::make_unique<ContactMachine>();
};

TEST_P(StepCalls, AMillionStepsAllocateAndLockNothing) {
    Felt felt;
    {
        const CallCounter counting;
        felt = run();
    }
    const CallCounts counts = take_call_counts();
    EXPECT_EQ(counts.allocations, 0U);
    EXPECT_EQ(counts.locks, 0U);
    expect_felt(felt);
}

/// Runs `work` in a child that the kernel kills at any system call but read, write and exit.
/// Returns whether the child lived to report.
bool does_without_system_calls(const std::function<bool()>& work) {
    int ends[2];
    if (pipe(ends) != 0) return false;
    const pid_t child = fork();
    if (child == 0) {
        if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT) != 0) _exit(1);
        const char said = work() ? 'y' : 'n';
        const bool is_written = write(ends[1], &said, 1) == 1;
        syscall(SYS_exit, is_written ? 0 : 1);
    }
    close(ends[1]);
    char said = 'n';
    const bool is_said = read(ends[0], &said, 1) == 1 && said == 'y';
    close(ends[0]);
    int status = 0;
    const bool is_over = child > 0 && waitpid(child, &status, 0) == child;
    return is_said && is_over && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST_P(StepCalls, AMillionStepsMakeNoSystemCall) {
    EXPECT_TRUE(does_without_system_calls([this] { return run().contacts > steps / 10; }));
}

INSTANTIATE_TEST_SUITE_P(Levels, StepCalls, testing::Values(Level::finest, Level::by_speed),
                         [](const auto& test) {
                             return test.param == Level::finest ? "finest" : "by_speed";
                         });

TEST(CallCounts, CountAllocationsAndLocks) {
    std::mutex mutex;
    {
        const CallCounter counting;
        const std::vector<int> made(10);
        const std::lock_guard held(mutex);
    }
    const CallCounts counts = take_call_counts();
    EXPECT_GE(counts.allocations, 2U);
    EXPECT_EQ(counts.locks, 1U);
}

TEST(SystemCalls, AreFatalInTheChild) {
    EXPECT_TRUE(does_without_system_calls([] { return true; }));
    EXPECT_FALSE(does_without_system_calls([] { return syscall(SYS_getppid) > 0; }));
}

}  // namespace
}  // namespace touchline
