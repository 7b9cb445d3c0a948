// The tick must not allocate: every allocation in this program is counted while a tick runs.

#include "haptics/device/simulated_pantograph.h"
#include "haptics/servo/servo_loop.h"
#include "tests/haptics/servo/rigs.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include <gtest/gtest.h>

namespace {

thread_local bool is_counting = false;
thread_local std::uint64_t allocations = 0;

void count() {
    if (is_counting) ++allocations;
}

}  // namespace

// Not inlined: the compiler would pair malloc with operator delete and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
    count();
    if (void* const p = std::malloc(size)) return p;
    throw std::bad_alloc();
}

[[gnu::noinline]] void operator delete(void* p) noexcept {
    count();
    std::free(p);
}

[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept {
    operator delete(p);
}

// The sanitizers bring allocators of their own, and are slow: there only operator new is counted,
// over fewer ticks.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int ticks = 20000;
#else
constexpr int ticks = 100000;

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* p, std::size_t size);
void __libc_free(void* p);

void* malloc(std::size_t size) {
    count();
    return __libc_malloc(size);
}

void* calloc(std::size_t number, std::size_t size) {
    count();
    return __libc_calloc(number, size);
}

void* realloc(void* p, std::size_t size) {
    count();
    return __libc_realloc(p, size);
}

void free(void* p) {
    count();
    __libc_free(p);
}
}
#endif

namespace touchline {
namespace {

std::shared_ptr<const Scene> wave_scene(double phase) {
    TactileMap map;
    Outline wave;
    for (int i = 0; i <= 1000; ++i) {
        const double x = -0.05 + 0.1 * i / 1000.0;
        wave.points.push_back({x, 0.01 * std::sin(150.0 * x + phase)});
    }
    map.outlines.push_back(wave);
    return std::make_shared<const Scene>(build_scene(map, {}, 0.001).value());
}

TEST(Tick, AllocatesNothingInAHundredThousandTicks) {
    std::vector<WaypointPath::Waypoint> waypoints;
    for (int i = 0; i <= 200; ++i) {  // to and fro across the wave for 100 s
        waypoints.push_back({0.5 * i, {0.04 * std::sin(0.7 * i), 0.02 * std::cos(1.3 * i)}});
    }
    SimulatedPantograph device(default_profile(), {},
                               std::make_shared<WaypointPath>(std::move(waypoints)));
    ServoExchange exchange;
    Recorder recorder(10000);
    ServoLoop loop(device, default_profile(), 1e-3, exchange, recorder);
    ServoCommands commands;
    std::uint64_t in_contact = 0;
    allocations = 0;
    for (int k = 0; k < ticks; ++k) {
        if (k % 5000 == 0) {  // another scene, mode and level, from the kiosk's side
            exchange.feel(wave_scene(0.0001 * k));
            commands.mode = k % 20000 == 0 ? Mode::groove : Mode::wall;
            commands.is_level_auto = k % 10000 == 0;
            commands.level = 1.5;
            exchange.set(commands);
        }
        is_counting = true;
        loop.tick(k * 1e-3, 0);
        is_counting = false;
        if (exchange.report().hand.state != ContactState::free) ++in_contact;
    }
    EXPECT_EQ(allocations, 0U);
    EXPECT_GT(in_contact, static_cast<std::uint64_t>(ticks / 10));
}

TEST(Tick, CounterDoesCount) {
    allocations = 0;
    is_counting = true;
    auto* const p = new std::vector<int>(10);
    is_counting = false;
    EXPECT_GE(allocations, 2U);
    delete p;
}

}  // namespace
}  // namespace touchline
