// The driver's tick neither allocates nor locks. The test counts every such call of this program
// while the driver reads and writes, also while it recovers.
#include "haptics/device/board/pantograph_board.h"
#include "tests/haptics/call_counts.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Answers every write at once with the home of the default profile, but cuts every `spoilt_`th
/// answer.
class ObedientLink final : public BoardLink {
  public:
    LinkStatus send(std::span<const std::uint8_t> command) override {
        sent_.bytes = command.size();
        if (command.size() == write_bytes) ++owed_;
        return LinkStatus::done;
    }

    Sent sent() override { return sent_; }

    Received receive() override {
        if (owed_ == 0) return {};
        --owed_;
        constexpr std::array<std::uint8_t, 9> home{0x05, 0x8f, 0x36, 0x3f, 0x41,
                                                   0xd2, 0xe6, 0x27, 0x43};
        Received received{LinkStatus::done, {}, home.size()};
        std::copy(home.begin(), home.end(), received.data.begin());
        if (++replies_ % spoilt == 0) received.size = replies_ % 2 == 0 ? 1 : 7;
        return received;
    }

    LinkStatus set_lines(bool) override { return LinkStatus::done; }

    LinkStatus clear_stall() override { return LinkStatus::done; }

    void cancel_send() override {}

    void rest(double) override {}

  private:
    static constexpr int spoilt = 101;
    Sent sent_;
    int owed_ = 0;
    int replies_ = 0;
};

TEST(BoardTick, NeitherAllocatesNorLocks) {
    PantographBoard driver(std::make_unique<ObedientLink>(), default_profile(), {});
    ASSERT_TRUE(driver.open().has_value());
    (void)take_call_counts();
    int answered = 0;
    for (int k = 0; k < 100000; ++k) {
        const CallCounter counting;
        const auto angles = driver.read_angles(k * 1e-3);
        (void)driver.write_torques(angles ? JointTorques{0.01, 0.02} : JointTorques{});
        answered += angles ? 1 : 0;
    }
    const CallCounts counts = take_call_counts();
    EXPECT_EQ(counts.allocations, 0U);
    EXPECT_EQ(counts.locks, 0U);
    EXPECT_GT(answered, 80000);
    EXPECT_GT(driver.report().resyncs, 500U);
    EXPECT_GT(driver.report().unconfigured, 100U);
}

}  // namespace
}  // namespace touchline
