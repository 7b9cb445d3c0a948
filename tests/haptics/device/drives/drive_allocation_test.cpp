// The driver's tick neither allocates nor locks, also while it finds its way back. A run against an
// emulator, which does allocate, is written down; the same bytes then come to a second driver, of
// which every such call is counted.
#include "haptics/device/drives/motor_pantograph.h"
#include "tests/haptics/call_counts.h"
#include "tests/machines/sim/drives/drive_rig.h"

#include <algorithm>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// What a link gave, call by call.
struct LinkLog {
    std::vector<std::uint8_t> bytes;
    std::vector<std::size_t> reads;
    std::vector<bool> writes;
};

class LoggedLink final : public ByteLink {
  public:
    LoggedLink(std::unique_ptr<ByteLink> behind, LinkLog& log)
        : behind_(std::move(behind)), log_(log) {}

    bool write(std::span<const std::uint8_t> bytes) override {
        log_.writes.push_back(behind_->write(bytes));
        return log_.writes.back();
    }

    std::size_t read(std::span<std::uint8_t> room) override {
        const std::size_t size = behind_->read(room);
        log_.reads.push_back(size);
        log_.bytes.insert(log_.bytes.end(), room.begin(),
                          room.begin() + static_cast<std::ptrdiff_t>(size));
        return size;
    }

    [[nodiscard]] bool is_gone() const override { return behind_->is_gone(); }

    void rest(double span_s) override { behind_->rest(span_s); }

  private:
    std::unique_ptr<ByteLink> behind_;
    LinkLog& log_;
};

class ReplayedLink final : public ByteLink {
  public:
    explicit ReplayedLink(const LinkLog& log) : log_(log) {}

    bool write(std::span<const std::uint8_t>) override { return log_.writes.at(writes_++); }

    std::size_t read(std::span<std::uint8_t> room) override {
        const std::size_t size = log_.reads.at(reads_++);
        std::copy_n(log_.bytes.begin() + static_cast<std::ptrdiff_t>(bytes_), size, room.begin());
        bytes_ += size;
        return size;
    }

    [[nodiscard]] bool is_gone() const override { return false; }

    void rest(double) override {}

  private:
    const LinkLog& log_;
    std::size_t bytes_ = 0, reads_ = 0, writes_ = 0;
};

constexpr int counted_ticks = 5000;
constexpr int ticks_between_faults = 500;

JointTorques wanted_at(const std::optional<JointAngles>& angles, int tick) {
    return angles && tick % 100 < 80 ? JointTorques{0.03, -0.02} : JointTorques{};
}

template <class Machine>
LinkLog written_down() {
    LinkLog log;
    VirtualTime time;
    const DriveTruth truth;
    Machine machine(truth, Machine::units(), hand_in_the_middle());
    auto line = std::make_unique<EmulatedSerial>(machine.peer(), time);
    EmulatedSerial& spoilt = *line;
    MotorPantograph driver(Machine::pair_over(std::make_unique<LoggedLink>(std::move(line), log)),
                           truth.profile, {});
    EXPECT_TRUE(driver.open().has_value());
    for (int k = 0; k < counted_ticks; ++k) {
        time.now_s += drive_tick_s;
        if (k % ticks_between_faults == 100) spoilt.spoil(LineFault::garbled_reply, 0.0, 7);
        if (k % ticks_between_faults == 300) spoilt.spoil(LineFault::lost_reply, 0.01);
        const auto angles = driver.read_angles(k * drive_tick_s);
        (void)driver.write_torques(wanted_at(angles, k));
    }
    EXPECT_GT(driver.report().set_ups, 8U);
    (void)driver.stop();
    return log;
}

template <class Machine>
class DriveTick : public testing::Test {};

using TickMachines = testing::Types<MoteusMachine, OdriveMachine>;
TYPED_TEST_SUITE(DriveTick, TickMachines);

TYPED_TEST(DriveTick, NeitherAllocatesNorLocks) {
    const LinkLog log = written_down<TypeParam>();
    MotorPantograph driver(TypeParam::pair_over(std::make_unique<ReplayedLink>(log)),
                           DriveTruth{}.profile, {});
    ASSERT_TRUE(driver.open().has_value());
    (void)take_call_counts();
    int answered = 0;
    for (int k = 0; k < counted_ticks; ++k) {
        const CallCounter counting;
        const auto angles = driver.read_angles(k * drive_tick_s);
        (void)driver.write_torques(wanted_at(angles, k));
        answered += angles ? 1 : 0;
    }
    const CallCounts counts = take_call_counts();
    EXPECT_EQ(counts.allocations, 0U);
    EXPECT_EQ(counts.locks, 0U);
    EXPECT_GT(answered, counted_ticks / 2);
    EXPECT_GT(driver.report().set_ups, 8U);
    (void)driver.stop();
}

}  // namespace
}  // namespace touchline
