// The tick must not allocate. The test counts every allocation of this program during a tick.

#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/servo/servo_loop.h"
#include "tests/haptics/call_counts.h"
#include "tests/haptics/servo/crossing_hand.h"
#include "tests/haptics/servo/rigs.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

// The sanitizers are slow.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int ticks = 20000;
#else
constexpr int ticks = 100000;
#endif

namespace touchline {
namespace {

TEST(Tick, AllocatesNothingInAHundredThousandTicks) {
    SimulatedPantograph device(default_profile(), {}, to_and_fro(200, 0.02));
    ServoExchange exchange;
    Recorder recorder(10000);
    ServoLoop loop(device, default_profile(), 1e-3, exchange, recorder);
    ServoCommands commands;
    std::uint64_t in_contact = 0;
    for (int k = 0; k < ticks; ++k) {
        if (k % 5000 == 0) {  // another scene, mode and level, as the kiosk sets them
            exchange.feel(turned_wave_scene(0.0001 * k));
            constexpr std::array modes{Mode::groove, Mode::wall, Mode::ridge, Mode::wall,
                                       Mode::stay};
            commands.contact.mode = modes[static_cast<std::size_t>(k / 5000) % modes.size()];
            commands.contact.pop_through_N = 0.5;
            commands.is_level_auto = k % 10000 == 0;
            commands.level = 1.5;
            commands.pattern = {HandlePattern::edge, commands.pattern.serial + 1};
            constexpr std::array kinds{GuidanceKind::tour, GuidanceKind::to_line,
                                       GuidanceKind::none, GuidanceKind::to_place};
            commands.guidance.kind = kinds[static_cast<std::size_t>(k / 5000) % kinds.size()];
            commands.shape = static_cast<HeldShape>(k / 5000 % 5);
            commands.turn_rad = 0.3 * (k / 5000);
            ++commands.guidance.serial;
            exchange.set(commands);
        }
        {
            const CallCounter counting;
            loop.tick(k * 1e-3, 0);
        }
        if (exchange.report().hand.state != ContactState::free) ++in_contact;
    }
    EXPECT_EQ(take_call_counts().allocations, 0U);
    EXPECT_GT(in_contact, static_cast<std::uint64_t>(ticks / 10));
}

TEST(Tick, CounterDoesCount) {
    {
        const CallCounter counting;
        const std::vector<int> made(10);
    }
    EXPECT_GE(take_call_counts().allocations, 2U);
}

}  // namespace
}  // namespace touchline
