#include "app/force/servo/black_box.h"

#include "app/documents/decode/files.h"
#include "config/types/pinned.h"
#include "haptics/servo/servo_loop.h"
#include "tests/haptics/servo/rigs.h"
#include "tests/machines/sim/fault_lines.h"

#include <csignal>
#include <filesystem>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

class BlackBoxFiles : public testing::Test {
  protected:
    void TearDown() override { fs::remove_all(folder_); }

    void tick() {
        loop_.tick(1e-3 * now_++, 0);
        box_.update(recorder_, exchange_.report().force.fault);
    }

    /// Ticks until another line was told. The writer needs its own time, so the limit is far off.
    void tick_until_told() {
        const std::size_t before = told_.size();
        for (int i = 0; i < 20'000'000 && told_.size() == before; ++i) {
            tick();
            std::this_thread::yield();
        }
        ASSERT_EQ(told_.size(), before + 1);
    }

    [[nodiscard]] int files() const {
        int count = 0;
        if (!fs::exists(folder_)) return count;
        for (const auto& entry : fs::directory_iterator(folder_)) count += entry.exists() ? 1 : 0;
        return count;
    }

    /// Loses the device for a while and brings it back.
    void fault() {
        device_.angles.reset();
        for (int i = 0; i < 100; ++i) tick();
        ASSERT_EQ(exchange_.report().force.fault, Fault::device_lost);
        device_.angles = angles_at(default_profile(), {0.0, 0.01});
        for (int i = 0; i < 500; ++i) tick();
    }

    [[nodiscard]] Recording kept() const {
        return recording_of(read_file(folder_ / "recording-1.touchline").value()).value();
    }

    fs::path folder_ = fs::path(testing::TempDir()) /
                       testing::UnitTest::GetInstance()->current_test_info()->name() / "kept";
    std::vector<std::string> told_;
    BlackBox box_{folder_, "2diy-gen3.1",
                  [this](const std::string& line) { told_.push_back(line); }};
    PlacedDevice device_{{0.0, 0.01}};
    ServoExchange exchange_;
    Recorder recorder_{2000};
    ServoLoop loop_{device_, default_profile(), 1e-3, exchange_, recorder_};
    int now_ = 0;
};

TEST_F(BlackBoxFiles, AFaultHoldsTheRecordingInMemoryAndWritesNothing) {
    for (int i = 0; i < 500; ++i) tick();
    EXPECT_FALSE(recorder_.is_held());
    fault();
    EXPECT_TRUE(recorder_.is_held());
    fault();  // another fault changes nothing
    EXPECT_EQ(files(), 0);
    EXPECT_TRUE(told_.empty());
    ASSERT_FALSE(recorder_.ticks().empty());
    EXPECT_EQ(recorder_.ticks().back().fault, Fault::device_lost);
    EXPECT_EQ(recorder_.ticks().front().time_s, 0.0) << "as it was at the first of the faults";
}

TEST_F(BlackBoxFiles, WhatAFaultHeldTheOperatorMayKeep) {
    for (int i = 0; i < 500; ++i) tick();
    fault();
    box_.keep();
    tick_until_told();
    EXPECT_EQ(told_[0].find(recording_kept), 0U) << told_[0];
    const Recording recording = kept();
    EXPECT_EQ(recording.ticks.back().fault, Fault::device_lost);
    EXPECT_GT(recording.ticks.size(), 500U);
    EXPECT_FALSE(recording.start.empty());
    constexpr auto others = fs::perms::group_all | fs::perms::others_all;
    EXPECT_EQ(fs::status(folder_ / "recording-1.touchline").permissions() & others,
              fs::perms::none);
    for (int i = 0; i < 100; ++i) tick();
    EXPECT_FALSE(recorder_.is_held()) << "it records again";
}

TEST_F(BlackBoxFiles, WhatSomebodyHeldIsOverwrittenWhenTheVisitIsOver) {
    for (int i = 0; i < 500; ++i) tick();
    box_.hold();
    for (int i = 0; i < 10; ++i) tick();
    ASSERT_TRUE(recorder_.is_held());
    const TickRecord* const place = recorder_.newest();
    ASSERT_NE(place->p_WH, Position{});
    // Still held until overwritten: nothing else can change the record.
    box_.forget();
    box_.update(recorder_, Fault::none);
    EXPECT_EQ(place->p_WH, Position{});
    for (int i = 0; i < 100; ++i) tick();
    EXPECT_FALSE(recorder_.is_held());
    EXPECT_GT(recorder_.ticks().front().time_s, 0.5);
    EXPECT_EQ(files(), 0);
}

TEST_F(BlackBoxFiles, WhatNobodyHeldIsOverwrittenToo) {
    for (int i = 0; i < 500; ++i) tick();
    box_.forget();
    for (int i = 0; i < 100; ++i) tick();
    ASSERT_FALSE(recorder_.ticks().empty());
    EXPECT_GT(recorder_.ticks().front().time_s, 0.499);
}

TEST_F(BlackBoxFiles, WhoseVisitIsOverIsNotKeptAnyMore) {
    for (int i = 0; i < 500; ++i) tick();
    box_.keep();
    box_.forget();
    ASSERT_EQ(told_.size(), 1U);
    EXPECT_EQ(told_[0].find(recording_not_kept), 0U) << told_[0];
    for (int i = 0; i < 100; ++i) tick();
    EXPECT_EQ(files(), 0);
}

TEST_F(BlackBoxFiles, OnDemandEightAreKept) {
    for (int i = 0; i < 10; ++i) {
        tick();
        box_.keep();
        tick_until_told();
    }
    EXPECT_EQ(files(), 8);
}

TEST_F(BlackBoxFiles, WhatCannotBeWrittenIsOneLineAndTheServoGoesOn) {
    box_ = BlackBox("/dev/null/none", "2diy-gen3.1",
                    [this](const std::string& line) { told_.push_back(line); });
    box_.keep();
    tick_until_told();
    EXPECT_EQ(told_[0].find('\n'), std::string::npos);
    EXPECT_EQ(exchange_.report().force.fault, Fault::none);
    fs::create_directories(folder_);
}

/// While it lives, files of this process may grow to so many bytes and no more.
class FullDisk : private Pinned {
  public:
    explicit FullDisk(rlim_t bytes_left) : before_(std::signal(SIGXFSZ, SIG_IGN)) {
        const rlimit limit{bytes_left, RLIM_INFINITY};
        EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
    }

    ~FullDisk() {
        const rlimit limit{RLIM_INFINITY, RLIM_INFINITY};
        (void)setrlimit(RLIMIT_FSIZE, &limit);
        std::signal(SIGXFSZ, before_);
    }

  private:
    void (*before_)(int);
};

TEST_F(BlackBoxFiles, AFullDiskIsOneLineLeavesNoHalfFileAndTheServoGoesOn) {
    std::mt19937 random(6);
    for (std::uint64_t seed = 0; seed < fault_runs(20); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        for (int i = 0; i < 100; ++i) tick();
        const int descriptors = open_descriptors(getpid());
        const int ticks = now_;
        {
            const FullDisk disk(random() % 20'000);
            box_.keep();
            ASSERT_NO_FATAL_FAILURE(tick_until_told());
        }
        EXPECT_NE(told_.back().find("is the disk full?"), std::string::npos) << told_.back();
        EXPECT_EQ(told_.back().find('\n'), std::string::npos);
        EXPECT_EQ(files(), 0);
        EXPECT_EQ(open_descriptors(getpid()), descriptors);
        EXPECT_EQ(exchange_.report().force.fault, Fault::none);
        EXPECT_GT(now_, ticks);
        tell({"servo",
              "disk full",
              seed,
              {},
              "force goes on, no recording is kept: is the disk full?",
              {},
              true,
              {}});
    }
    box_.keep();
    tick_until_told();
    EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace touchline
