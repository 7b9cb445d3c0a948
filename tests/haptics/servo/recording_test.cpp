// The black box: kept, written, read, run again; and what else may be in its file.

#include "haptics/servo/recording.h"

#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/servo/recorder.h"
#include "haptics/servo/servo_loop.h"
#include "tests/haptics/servo/rigs.h"
#include "tests/haptics/tick.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TickRecord at(double time_s) {
    TickRecord tick;
    tick.time_s = time_s;
    return tick;
}

TEST(Recorder, KeepsWhatATickWas) {
    PlacedDevice device({0.0, 0.01});
    ServoExchange exchange;
    exchange.feel(line_scene(0.0, 7));
    ServoCommands commands;
    commands.contact.stiffness_N_per_m = 321.0;
    exchange.set(commands);
    Recorder recorder(4);
    ServoLoop loop(device, default_profile(), 1e-3, exchange, recorder);
    loop.tick(0.5, 3);
    const auto ticks = recorder.ticks();
    ASSERT_EQ(ticks.size(), 1U);
    const TickRecord& tick = ticks[0];
    EXPECT_EQ(tick.input.now_s, 0.5);
    EXPECT_EQ(tick.input.missed_ticks, 3U);
    ASSERT_TRUE(tick.input.reading.has_value());
    EXPECT_EQ(tick.input.reading->joints, device.angles);
    EXPECT_EQ(tick.input.commands, commands);
    EXPECT_EQ(tick.input.scene, nullptr);
    EXPECT_EQ(tick.wanted_version, 7U);
    EXPECT_FALSE(tick.is_refused);
    const HandState& hand = exchange.report().hand;
    EXPECT_EQ(tick.time_s, hand.time_s);
    EXPECT_EQ(tick.p_WH, hand.p_WH);
    EXPECT_EQ(tick.p_WP, hand.p_WP);
    EXPECT_EQ(tick.level, hand.level);
    EXPECT_EQ(tick.stiffness_N_per_m, hand.stiffness_N_per_m);
    EXPECT_EQ(tick.map_version, 7U);
    EXPECT_EQ(tick.force_state, ForceState::armed);
}

TEST(Recorder, KeepsTheNewestOldestFirst) {
    Recorder recorder(3);
    for (int i = 0; i < 8; ++i) recorder.push(at(i));
    const auto ticks = recorder.ticks();
    ASSERT_EQ(ticks.size(), 3U);
    EXPECT_EQ(ticks[0].time_s, 5.0);
    EXPECT_EQ(ticks[2].time_s, 7.0);
}

TEST(Recorder, WhatIsWipedIsOverwrittenWhereItLay) {
    PlacedDevice device({0.0123, 0.0456});
    ServoExchange exchange;
    Recorder recorder(8000);
    ServoLoop loop(device, default_profile(), 1e-3, exchange, recorder);
    for (int i = 0; i < 6000; ++i) loop.tick(1e-3 * i, 0);
    const TickRecord* const place = recorder.newest();  // in the recorder's own memory
    ASSERT_NE(place->p_WH.x, 0.0);
    recorder.hold();
    loop.tick(6.0, 0);
    ASSERT_TRUE(recorder.is_held());
    recorder.wipe();
    EXPECT_EQ(place->p_WH, Position{});
    EXPECT_FALSE(place->input.reading.has_value());
    EXPECT_EQ(recorder.newest(), nullptr);
    EXPECT_TRUE(recorder.ticks().empty());
    EXPECT_FALSE(recorder.start().has_value());
    recorder.release();
    loop.tick(6.001, 0);
    loop.tick(6.002, 0);
    EXPECT_FALSE(recorder.ticks().empty()) << "and it records again";
}

TEST(Recorder, WithoutRoomKeepsNothing) {
    Recorder recorder;
    recorder.push(at(1.0));
    EXPECT_TRUE(recorder.ticks().empty());
    EXPECT_FALSE(recorder.start().has_value());
}

TEST(Recorder, KnowsTheStepNoLaterThanFiveThousandTicksAfterTheOldest) {
    Recorder recorder(12'000);
    const ServoStep step(default_profile(), 1e-3);
    for (int i = 0; i < 50'000; ++i) {
        recorder.begin(step);
        recorder.push(at(i));
        if (i % 777 != 0) continue;
        const auto start = recorder.start();
        ASSERT_TRUE(start.has_value());
        ASSERT_LT(start->tick, 5000U);
        const auto first = static_cast<int>(recorder.ticks()[start->tick].time_s);
        ASSERT_EQ(first % 5000, 0);
    }
}

TEST(Recorder, HeldItStaysAsItIsAndReleasedItBeginsAnew) {
    Recorder recorder(100);
    const ServoStep step(default_profile(), 1e-3);
    const auto tick = [&](double time_s) {
        recorder.begin(step);
        recorder.push(at(time_s));
    };
    tick(1.0);
    recorder.hold();
    EXPECT_FALSE(recorder.is_held());  // a tick may be under way
    tick(2.0);
    EXPECT_TRUE(recorder.is_held());
    EXPECT_EQ(recorder.ticks().size(), 1U);
    recorder.release();
    tick(3.0);
    tick(4.0);
    EXPECT_FALSE(recorder.is_held());
    ASSERT_EQ(recorder.ticks().size(), 2U);
    EXPECT_EQ(recorder.ticks()[0].time_s, 3.0);
    EXPECT_EQ(recorder.start()->tick, 0U);
}

/// A hand explores two pictures in turn while everything that can be set changes.
struct Session {
    std::map<std::uint64_t, std::shared_ptr<const Scene>> scenes{{1, line_scene(0.0, 1)},
                                                                 {2, line_scene(0.004, 2)}};
    Recorder recorder;

    Session(std::size_t capacity, int ticks) : recorder(capacity) {
        std::vector<WaypointPath::Waypoint> way{{0.0, {0.0, 0.02}}, {0.9, {0.0, 0.02}}};
        for (int i = 1; i * 0.4 < ticks * tick_s; ++i) {
            way.push_back({0.9 + 0.4 * i, {0.03 * std::sin(1.1 * i), 0.01 * std::cos(2.3 * i)}});
        }
        SimulatedPantograph device(default_profile(), {}, std::make_shared<WaypointPath>(way));
        ServoExchange exchange;
        ServoLoop loop(device, default_profile(), tick_s, exchange, recorder);
        ServoCommands commands;
        for (int k = 0; k < ticks; ++k) {
            if (k % 3000 == 0) exchange.feel(scenes.at(k / 3000 % 2 == 0 ? 1 : 2));
            commands.contact.mode = static_cast<Mode>(k / 1700 % 4);
            commands.contact.stiffness_N_per_m = k / 2500 % 2 == 0 ? 500.0 : 350.0;
            commands.is_level_auto = k / 4000 % 2 == 0;
            commands.is_force_wanted = k % 10'000 < 9'500;
            commands.force_ceiling_N = k / 1000 % 2 == 0 ? 3.0 : 1.5;
            commands.guidance.kind = static_cast<GuidanceKind>(k / 1300 % 4);
            commands.guidance.serial = static_cast<std::uint32_t>(k / 1300);
            commands.pattern.pattern = static_cast<HandlePattern>(k / 900 % 6);
            commands.pattern.serial = static_cast<std::uint32_t>(k / 900);
            // There is no shape where the whole step is kept, because a shape is not a flat value.
            commands.shape = static_cast<HeldShape>(k / 700 % 7 < 5 ? 0 : k / 700 % 5);
            commands.turn_rad = 0.5 * (k / 500 % 7);
            exchange.set(commands);
            loop.tick(k * tick_s, static_cast<std::uint64_t>(k / 1000));
        }
    }

    [[nodiscard]] Recording recording(bool is_second_of_gallery = true) const {
        return make_recording(
            recorder, "2diy-gen3.1",
            {{1, "01.svg", 3, 11}, {2, is_second_of_gallery ? "02.svg" : "", 3, 22}});
    }

    /// Builds the scene again, as another program would.
    [[nodiscard]] static Result<std::shared_ptr<const Scene>> built_again(std::uint64_t version) {
        return line_scene(version == 1 ? 0.0 : 0.004, version);
    }
};

TEST(Recording, RunAgainGivesTheSameBits) {
    const Session session(12'000, 31'000);  // overwrites the beginning
    const auto bytes = bytes_of(session.recording());
    const auto recording = recording_of(bytes);
    ASSERT_TRUE(recording.has_value()) << recording.error().line;
    ASSERT_EQ(recording->ticks.size(), 12'000U);
    const auto replay = run_again(*recording, Session::built_again);
    ASSERT_TRUE(replay.has_value()) << replay.error().line;
    EXPECT_FALSE(replay->differs_at.has_value());
    EXPECT_EQ(replay->ticks.size(), 12'000U - replay->first);
    EXPECT_GT(replay->ticks.size(), 7'000U);
    double most_N = 0.0;
    for (const TickRecord& tick : replay->ticks) most_N = std::max(most_N, norm(tick.force));
    EXPECT_GT(most_N, 0.3);
    EXPECT_TRUE(std::any_of(replay->ticks.begin(), replay->ticks.end(), [](const TickRecord& tick) {
        return tick.input.commands.shape != HeldShape::none && tick.state != ContactState::free;
    }));
}

TEST(Recording, ASingleBitThatWasDifferentIsFound) {
    const Session session(6'000, 6'000);
    Recording recording = session.recording();
    recording.ticks[4321].force.x += 1e-15;
    EXPECT_EQ(run_again(recording, Session::built_again)->differs_at, 4321U);
    recording = session.recording();
    recording.ticks[1234].input.reading->p_D->x += 0.001;
    EXPECT_EQ(run_again(recording, Session::built_again)->differs_at, 1234U);
}

TEST(Recording, OfAVisitorsPictureThereIsNothingToRunAgain) {
    const Session session(6'000, 7'000);
    const Recording recording = session.recording(false);
    EXPECT_TRUE(recording.start.empty());
    EXPECT_EQ(recording.ticks.size(), 6'000U);
    EXPECT_FALSE(run_again(recording, Session::built_again).has_value());
}

TEST(Recording, AStartThatDoesNotFitIsRefused) {
    const Session session(6'000, 6'000);
    Recording recording = session.recording();
    recording.start.pop_back();
    EXPECT_FALSE(run_again(recording, Session::built_again).has_value());
    recording = session.recording();
    const auto unknown = [](std::uint64_t) -> Result<std::shared_ptr<const Scene>> {
        return failure("gone");
    };
    EXPECT_EQ(run_again(recording, unknown).error().line, "gone");
    recording.profile = "none such";
    EXPECT_FALSE(run_again(recording, Session::built_again).has_value());
}

TEST(Recording, TheNumberOfTheLayoutFollowsFromTheBytesOfATick) {
    Recording recording;
    const auto none = bytes_of(recording);
    recording.ticks.resize(1);
    const std::size_t bytes_per_tick = bytes_of(recording).size() - none.size();
    std::uint32_t layout = 0;
    std::memcpy(&layout, none.data() + 8, sizeof layout);
    EXPECT_EQ(layout, 3 + bytes_per_tick - 338);  // number 3 had 338 bytes
}

TEST(Recording, TheHashIsOfWhatCanBeFelt) {
    TactileMap map;
    map.outlines.push_back({{{0.0, 0.0}, {0.01, 0.0}}, false, "a", "b"});
    const std::uint64_t hash = hash_of(map);
    map.title = "other";
    EXPECT_EQ(hash_of(map), hash);
    map.outlines[0].points[1].x = std::nextafter(0.01, 1.0);
    EXPECT_NE(hash_of(map), hash);
}

TEST(Recording, NothingButAWholeFileIsRead) {
    const Session session(50, 50);
    const auto bytes = bytes_of(session.recording());
    ASSERT_TRUE(recording_of(bytes).has_value());
    for (std::size_t size = 0; size < bytes.size(); size += size < 600 ? 1 : 97) {
        const auto cut = recording_of(std::span(bytes).first(size));
        ASSERT_FALSE(cut.has_value()) << size;
        ASSERT_EQ(cut.error().line.find('\n'), std::string::npos);
    }
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {
        auto damaged = bytes;
        damaged[random() % damaged.size()] ^= static_cast<std::byte>(1U << random() % 8U);
        ASSERT_FALSE(recording_of(damaged).has_value());
    }
}

/// Returns the same bytes with a correct checksum.
std::vector<std::byte> signed_anew(std::vector<std::byte> bytes) {
    const std::uint64_t hash = checksum_of(std::span(bytes).first(bytes.size() - 8));
    std::memcpy(bytes.data() + bytes.size() - 8, &hash, 8);
    return bytes;
}

/// Damages everything but the start, which is trusted.
TEST(Recording, DamageThatTheChecksumDoesNotShowIsReadOrRefusedAndRunsWithoutHarm) {
    const Session session(1500, 6400);
    const Recording recording = session.recording();
    ASSERT_FALSE(recording.start.empty());
    std::mt19937 random(7);
    int run = 0;
    for (int i = 0; i < 60; ++i) {
        Recording strange = recording;
        strange.start.clear();
        auto bytes = bytes_of(strange);
        for (int k = 0; k < 10; ++k)
            bytes[100 + random() % (bytes.size() - 100)] = static_cast<std::byte>(random());
        auto read_back = recording_of(signed_anew(std::move(bytes)));
        if (!read_back) continue;
        read_back->start = recording.start;
        read_back->start_tick = recording.start_tick;
        read_back->start_version = recording.start_version;
        if (run_again(*read_back, Session::built_again)) ++run;
    }
    EXPECT_GT(run, 20);
    Recording zeroed = recording;
    std::fill(zeroed.start.begin(), zeroed.start.end(), std::byte{0});
    EXPECT_FALSE(run_again(zeroed, Session::built_again).has_value());
}

}  // namespace
}  // namespace touchline
