// measure ticks | listing IMPORT: prints figures of this machine, one line of words and numbers
// each, for tests/machines/system/machine/run.
#include "app/documents/sticks/import.h"
#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/servo/real_time.h"
#include "haptics/servo/servo_loop.h"
#include "tests/app/documents/sticks/stick_folder.h"
#include "tests/haptics/call_counts.h"
#include "tests/haptics/servo/crossing_hand.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace touchline {
namespace {

constexpr int unarmed_ticks = 200;  // the arm rule allows no force yet: first calls may fault
constexpr int ticks = 1'000'000;
constexpr int between_scenes = 5000;

/// Sets another scene and mode, as the kiosk does.
void change(ServoExchange& exchange, int k) {
    constexpr std::array modes{Mode::groove, Mode::wall, Mode::ridge, Mode::stay};
    exchange.feel(turned_wave_scene(1e-4 * k));
    ServoCommands commands;
    commands.contact.mode = modes.at(static_cast<std::size_t>(k / between_scenes) % modes.size());
    commands.is_level_auto = k % (2 * between_scenes) == 0;
    exchange.set(commands);
}

int measure_ticks() {
    (void)become_real_time(MemoryLock::whole);
    SimulatedPantograph device(default_profile(), {}, to_and_fro(2000, 0.02));
    ServoExchange exchange;
    Recorder recorder(10'000);
    ServoLoop loop(device, default_profile(), 1e-3, exchange, recorder);
    std::int64_t faults = 0;
    std::int64_t in_contact = 0;
    for (int k = 0; k < unarmed_ticks + ticks; ++k) {
        if (k % between_scenes == 0) change(exchange, k);
        const std::int64_t before = faults_of_this_thread();
        {
            const CallCounter counting;
            loop.tick(k * 1e-3, 0);
        }
        if (k < unarmed_ticks) continue;
        faults += faults_of_this_thread() - before;
        if (exchange.report().hand.state != ContactState::free) ++in_contact;
    }
    const CallCounts calls = take_call_counts();
    std::printf("ticks %d in_contact %lld allocations %llu locks %llu faults %lld\n", ticks,
                static_cast<long long>(in_contact),
                static_cast<unsigned long long>(calls.allocations),
                static_cast<unsigned long long>(calls.locks), static_cast<long long>(faults));
    return 0;
}

/// Works in memory: a disk takes minutes to make so many files.
int measure_listing(const std::string& program) {
    constexpr std::size_t files = 100'000;
    const StickFolder many("/dev/shm");
    many.files("f", files);
    const auto begin = std::chrono::steady_clock::now();
    const auto listing = StickImport(program).list(many.root());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    if (!listing) return 1;
    rusage use{};
    (void)getrusage(RUSAGE_CHILDREN, &use);
    std::printf("files %zu listed %zu whole %d s %.3f MB %.1f\n", files, listing->entries.size(),
                listing->rest.is_cut_short ? 0 : 1, took.count(),
                static_cast<double>(use.ru_maxrss) / 1024.0);
    return 0;
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() == 1 && words[0] == "ticks") return touchline::measure_ticks();
    if (words.size() == 2 && words[0] == "listing") return touchline::measure_listing(words[1]);
    std::fputs("usage: measure ticks | listing IMPORT\n", stderr);
    return 2;
}
