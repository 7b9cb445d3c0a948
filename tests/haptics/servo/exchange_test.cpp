#include "haptics/servo/exchange.h"

#include "tests/haptics/servo/rigs.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <thread>

#include <gtest/gtest.h>

namespace touchline {
namespace {

struct Pair {
    std::uint64_t a = 0;
    std::uint64_t b = ~std::uint64_t{0};
};

TEST(ServoChannel, TellsNoTierBeforeAServoDoesAndNoneThatThereIsNot) {
    ServoChannel channel;
    EXPECT_EQ(tier_of(channel), std::nullopt);
    channel.tier = static_cast<std::uint8_t>(RealTimeTier::too_late);
    EXPECT_EQ(tier_of(channel), RealTimeTier::too_late);
    ++channel.tier;
    EXPECT_EQ(tier_of(channel), std::nullopt);
}

TEST(TripleBuffer, ReaderSeesTheInitialValueFirst) {
    TripleBuffer<int> buffer(7);
    EXPECT_FALSE(buffer.update());
    EXPECT_EQ(buffer.value(), 7);
}

TEST(TripleBuffer, ReaderSeesTheLatestValueOnce) {
    TripleBuffer<int> buffer;
    for (int i = 1; i <= 5; ++i) buffer.write(i);
    EXPECT_TRUE(buffer.update());
    EXPECT_EQ(buffer.value(), 5);
    EXPECT_FALSE(buffer.update());
    EXPECT_EQ(buffer.value(), 5);
}

TEST(TripleBuffer, ValueStaysWhileTheWriterGoesOn) {
    TripleBuffer<int> buffer;
    buffer.write(1);
    ASSERT_TRUE(buffer.update());
    const int& held = buffer.value();
    for (int i = 2; i < 10; ++i) {
        buffer.write(i);
        EXPECT_EQ(held, 1);
    }
    ASSERT_TRUE(buffer.update());
    EXPECT_EQ(buffer.value(), 9);
}

TEST(TripleBuffer, NoValueIsTornOrOlderThanTheOneBefore) {
    TripleBuffer<Pair> buffer;
    constexpr std::uint64_t last = 200000;
    std::thread writer([&buffer] {
        for (std::uint64_t i = 1; i <= last; ++i) buffer.write({i, ~i});
    });
    std::uint64_t seen = 0;
    while (seen < last) {
        buffer.update();
        const Pair pair = buffer.value();
        ASSERT_EQ(pair.b, ~pair.a);
        ASSERT_GE(pair.a, seen);
        seen = pair.a;
    }
    writer.join();
}

TEST(EventRing, GivesBackInOrderWhatWasPut) {
    EventRing<int, 8> ring;
    EXPECT_FALSE(ring.pop().has_value());
    for (int round = 0; round < 5; ++round) {
        for (int i = 0; i < 6; ++i) ring.push(10 * round + i);
        for (int i = 0; i < 6; ++i) EXPECT_EQ(ring.pop(), 10 * round + i);
        EXPECT_FALSE(ring.pop().has_value());
    }
    EXPECT_EQ(ring.dropped(), 0U);
}

TEST(EventRing, DropsTheNewestWhenFullAndCounts) {
    EventRing<int, 8> ring;
    for (int i = 0; i < 11; ++i) ring.push(i);
    EXPECT_EQ(ring.dropped(), 3U);
    for (int i = 0; i < 8; ++i) EXPECT_EQ(ring.pop(), i);
    ring.push(42);
    EXPECT_EQ(ring.pop(), 42);
    EXPECT_FALSE(ring.pop().has_value());
}

TEST(EventRing, NoValueIsTornLostOrOutOfOrderBetweenThreads) {
    EventRing<Pair, 64> ring;
    constexpr std::uint64_t last = 200000;
    std::thread writer([&ring] {
        for (std::uint64_t i = 1; i <= last;) {
            const std::uint64_t dropped = ring.dropped();
            ring.push({i, ~i});
            if (ring.dropped() == dropped) ++i;
        }
    });
    for (std::uint64_t i = 1; i <= last;) {
        const auto pair = ring.pop();
        if (!pair) continue;
        ASSERT_EQ(pair->a, i);
        ASSERT_EQ(pair->b, ~i);
        ++i;
    }
    writer.join();
}

/// Fills every byte that two sides share, as a corrupted peer may leave it.
template <class Shared>
void fill_with(Shared& shared, unsigned char byte) {
    std::memset(static_cast<void*>(&shared), byte, sizeof shared);
}

TEST(TripleBuffer, NoIndexThatAPeerLeavesLeadsOutside) {
    struct Guarded {
        std::array<char, 4096> before{};
        TripleBuffer<Pair> buffer;
        std::array<char, 4096> after{};
    };

    for (int byte = 0; byte < 256; ++byte) {
        auto guarded = std::make_unique<Guarded>();
        fill_with(guarded->buffer, static_cast<unsigned char>(byte));
        for (int i = 0; i < 8; ++i) {
            guarded->buffer.write({1, 2});
            (void)guarded->buffer.update();
            (void)guarded->buffer.value();
        }
        const std::array<char, 4096> untouched{};
        ASSERT_EQ(guarded->before, untouched);
        ASSERT_EQ(guarded->after, untouched);
    }
}

TEST(EventRing, APeerGoneMadCanNeitherLeadOutsideNorKeepTheReaderForEver) {
    using Ring = EventRing<int, 8>;
    std::mt19937 random(20261122);
    for (int round = 0; round < 1000; ++round) {
        Ring ring;
        for (std::size_t i = 0; i < sizeof ring; ++i) {
            reinterpret_cast<unsigned char*>(&ring)[i] = static_cast<unsigned char>(random());
        }
        for (int i = 0; i < 20; ++i) ring.push(i);
        int read = 0;
        while (ring.pop()) ++read;
        ASSERT_LE(read, 8);
    }
}

TEST(ServoExchange, UnsoundCommandsChangeNothing) {
    ServoExchange exchange;
    ServoCommands sound;
    sound.contact.stiffness_N_per_m = 300.0;
    exchange.set(sound);
    EXPECT_EQ(exchange.commands().contact.stiffness_N_per_m, 300.0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {nan, std::numeric_limits<double>::infinity(), -1.0, 1e6}) {
        const auto is_ignored = [&exchange, bad](auto&& field) {
            ServoCommands damaged;
            field(damaged) = bad;
            exchange.set(damaged);
            EXPECT_EQ(exchange.commands().contact.stiffness_N_per_m, 300.0);
        };
        for (double ContactSettings::*const field :
             {&ContactSettings::stiffness_N_per_m, &ContactSettings::friction,
              &ContactSettings::radius_m, &ContactSettings::capture_m,
              &ContactSettings::pop_through_N, &ContactSettings::pop_through_s})
            is_ignored([field](ServoCommands& c) -> double& { return c.contact.*field; });
        for (double ServoCommands::*const field :
             {&ServoCommands::level, &ServoCommands::finest_level, &ServoCommands::coarsest_level,
              &ServoCommands::force_ceiling_N})
            is_ignored([field](ServoCommands& c) -> double& { return c.*field; });
    }
    ServoCommands damaged;
    std::memset(&damaged.is_level_auto, 7, 1);
    EXPECT_FALSE(is_sound(damaged));
    damaged = {};
    damaged.contact.mode = static_cast<Mode>(9);
    EXPECT_FALSE(is_sound(damaged));
    damaged = {};
    damaged.force_ceiling_N = 3.001;
    EXPECT_FALSE(is_sound(damaged));
    damaged = {};
    damaged.pattern.pattern = static_cast<HandlePattern>(6);
    EXPECT_FALSE(is_sound(damaged));
    const auto is_sound_guidance = [](const GuidanceCommand& guidance) {
        ServoCommands commands;
        commands.guidance = guidance;
        return is_sound(commands);
    };
    EXPECT_TRUE(is_sound_guidance({GuidanceKind::to_place, false, 3, -1, {0.02, 0.01}, 0.03}));
    EXPECT_FALSE(is_sound_guidance({static_cast<GuidanceKind>(4), false, 3, -1, {}, 0.03}));
    EXPECT_FALSE(is_sound_guidance({GuidanceKind::tour, false, 3, -2, {}, 0.03}));
    EXPECT_FALSE(is_sound_guidance({GuidanceKind::tour, false, 3, 0, {}, 0.2}));
    EXPECT_FALSE(is_sound_guidance({GuidanceKind::tour, false, 3, 0, {}, nan}));
    EXPECT_FALSE(is_sound_guidance({GuidanceKind::to_place, false, 3, -1, {nan, 0.0}, 0.03}));
    EXPECT_TRUE(is_sound(ServoCommands{}));
}

TEST(ServoExchange, UnsoundReportsAreTold) {
    EXPECT_TRUE(is_sound(ServoReport{}));
    ServoReport report;
    report.hand.p_WH.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(is_sound(report));
    report = {};
    report.hand.state = static_cast<ContactState>(200);
    EXPECT_FALSE(is_sound(report));
    for (const StiffnessBound& bound :
         {StiffnessBound{std::numeric_limits<double>::quiet_NaN(), 500.0},
          StiffnessBound{1.1, 500.0}, StiffnessBound{1.0, std::numeric_limits<double>::quiet_NaN()},
          StiffnessBound{1.0, -1.0}}) {
        report = {};
        report.hand.stiffness_bound = bound;
        EXPECT_FALSE(is_sound(report));
    }
    report = {};
    report.hand.outline = -2;
    EXPECT_FALSE(is_sound(report));
    report = {};
    report.hand.guidance.phase = static_cast<GuidancePhase>(6);
    EXPECT_FALSE(is_sound(report));
    report = {};
    report.hand.guidance.leading.y = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(is_sound(report));
    report = {};
    report.hand.shape = static_cast<HeldShape>(held_shape_count);
    EXPECT_FALSE(is_sound(report));
    report = {};
    report.hand.torque_Nm = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(is_sound(report));
}

TEST(ServoExchange, CommandsAndReportsAreTheNewest) {
    ServoExchange exchange;
    EXPECT_EQ(exchange.commands().contact.stiffness_N_per_m, 500.0);
    ServoCommands commands;
    commands.contact.stiffness_N_per_m = 300.0;
    exchange.set(commands);
    commands.contact.stiffness_N_per_m = 400.0;
    exchange.set(commands);
    EXPECT_EQ(exchange.commands().contact.stiffness_N_per_m, 400.0);

    ServoReport report;
    report.hand.ticks = 12;
    report.force.limit = Limit::slew;
    exchange.publish(report);
    EXPECT_EQ(exchange.report().hand.ticks, 12U);
    EXPECT_EQ(exchange.report().force.limit, Limit::slew);
}

TEST(ServoExchange, ScenesLiveUntilTheServoHasMovedOn) {
    ServoExchange exchange;
    EXPECT_EQ(exchange.wanted_scene(), nullptr);
    auto first = line_scene(0.0);
    const std::weak_ptr<const Scene> first_alive = first;
    exchange.feel(std::move(first));
    const Scene* const felt = exchange.wanted_scene();
    EXPECT_EQ(felt, first_alive.lock().get());
    exchange.release_older_scenes();

    auto second = line_scene(0.01);
    const std::weak_ptr<const Scene> second_alive = second;
    exchange.feel(std::move(second));
    EXPECT_NE(exchange.wanted_scene(), felt);
    (void)exchange.report();
    EXPECT_FALSE(first_alive.expired());  // the servo is still fading out of it
    exchange.release_older_scenes();
    (void)exchange.report();
    EXPECT_TRUE(first_alive.expired());
    EXPECT_FALSE(second_alive.expired());
}

TEST(ServoExchange, ScenesThatTheServoNeverTookAreFreedToo) {
    ServoExchange exchange;
    auto skipped = line_scene(0.0);
    const std::weak_ptr<const Scene> skipped_alive = skipped;
    exchange.feel(std::move(skipped));
    exchange.feel(line_scene(0.01));
    (void)exchange.wanted_scene();
    exchange.release_older_scenes();
    (void)exchange.report();
    EXPECT_TRUE(skipped_alive.expired());
}

TEST(ServoExchange, ScenesAreFreedByTheKiosksThreadWhileTheServoReadsThem) {
    ServoExchange exchange;
    std::atomic<bool> is_done{false};
    std::thread servo([&] {
        while (!is_done.load()) {
            const Scene* const scene = exchange.wanted_scene();
            // Reads the scene; an address sanitizer would see one that was freed too early.
            EXPECT_TRUE(scene == nullptr || scene->map_version >= 1U);
            exchange.release_older_scenes();
        }
    });
    const auto kiosk = std::this_thread::get_id();
    std::atomic<int> freed{0};
    for (std::uint64_t i = 1; i <= 2000; ++i) {
        auto* const scene = new Scene{};
        scene->map_version = i;
        exchange.feel({scene, [&freed, kiosk](const Scene* old) {
                           EXPECT_EQ(std::this_thread::get_id(), kiosk);
                           ++freed;
                           delete old;
                       }});
    }
    is_done = true;
    servo.join();
    (void)exchange.wanted_scene();
    exchange.release_older_scenes();
    (void)exchange.report();
    EXPECT_EQ(freed.load(), 1999);
}

}  // namespace
}  // namespace touchline
