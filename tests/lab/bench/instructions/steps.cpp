// The work that valgrind --tool=callgrind counts: the servo step over the workload's hand. Each
// dump is named after its contents. Without valgrind the requests do nothing, and nothing is
// written.
#include "tests/lab/bench/instructions/servo_steps.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <valgrind/callgrind.h>

namespace touchline::bench {
namespace {

/// Runs the steps from `first` on; the caller has switched counting on.
void run(Servo& servo, const std::vector<Position>& hand, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
        touchline_servo_step(servo, hand[i]);
        expect_held(servo, hand[i]);
    }
}

/// Writes what was counted since the last dump. The request keeps only the name's address.
void dump(LevelChoice choice, std::size_t edges, std::size_t number) {
    const std::string name = fmt::format("{} {} {}", name_of(choice), edges, number);
    CALLGRIND_DUMP_STATS_AT(name.c_str());
}

/// Writes one dump for all counted steps of a row, with their number: "auto 512 20000".
void count_row(const Scene& scene, LevelChoice choice, std::size_t edges,
               const std::vector<Position>& hand) {
    Servo servo = start(scene, choice, hand[0]);
    run(servo, hand, 0, warm_up_steps);
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    run(servo, hand, warm_up_steps, hand.size());
    dump(choice, edges, counted_steps);
    CALLGRIND_STOP_INSTRUMENTATION;
}

/// Writes a dump for each counted step: "auto 512 2000".
void count_each(const Scene& scene, LevelChoice choice, std::size_t edges,
                const std::vector<Position>& hand) {
    Servo servo = start(scene, choice, hand[0]);
    run(servo, hand, 0, warm_up_steps);
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    for (std::size_t i = warm_up_steps; i < hand.size(); ++i) {
        run(servo, hand, i, i + 1);
        dump(choice, edges, i);
    }
    CALLGRIND_STOP_INSTRUMENTATION;
}

/// Writes a dump for each of some steps, with empty simulated caches: switching callgrind on
/// empties them.
void count_cold(const Scene& scene, LevelChoice choice, std::size_t edges,
                const std::vector<Position>& hand, const std::vector<std::size_t>& chosen) {
    Servo servo = start(scene, choice, hand[0]);
    std::size_t next = 0;
    for (const std::size_t i : chosen) {
        run(servo, hand, next, i);
        CALLGRIND_START_INSTRUMENTATION;
        CALLGRIND_ZERO_STATS;
        run(servo, hand, i, i + 1);
        dump(choice, edges, i);
        CALLGRIND_STOP_INSTRUMENTATION;
        next = i + 1;
    }
}

/// Reads step numbers from stdin, rising, each within the hand.
std::vector<std::size_t> chosen_steps() {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; std::cin >> i;) chosen.push_back(i);
    const bool is_rising =
        std::adjacent_find(chosen.begin(), chosen.end(), std::greater_equal()) == chosen.end();
    if (!is_rising || chosen.empty() || chosen.back() >= warm_up_steps + counted_steps) {
        fmt::print(stderr, "the steps on stdin must rise and lie within the hand\n");
        std::exit(EXIT_FAILURE);
    }
    return chosen;
}

constexpr std::string_view usage =
    "usage: valgrind --tool=callgrind ... instruction_steps PART [auto|0 EDGES]\n"
    "  total            all steps of every row together\n"
    "  each auto 512    each step of a row\n"
    "  cold auto 512    the steps named on stdin, caches empty\n";

int count(const std::vector<std::string>& words) {
    const auto hand = workload::hand(workload::Kind::radial, warm_up_steps + counted_steps);
    if (words.size() == 1 && words[0] == "total") {
        for (const std::size_t edges : {512U, 4096U, 65536U}) {
            const Scene scene = radial_scene(edges);
            count_row(scene, LevelChoice::automatic, edges, hand);
            count_row(scene, LevelChoice::finest, edges, hand);
        }
        return EXIT_SUCCESS;
    }
    const bool is_row = words.size() == 3 && (words[0] == "each" || words[0] == "cold") &&
                        (words[1] == "auto" || words[1] == "0");
    if (!is_row) {
        fmt::print(stderr, "{}", usage);
        return 2;
    }
    const auto choice = words[1] == "auto" ? LevelChoice::automatic : LevelChoice::finest;
    const std::size_t edges = std::stoul(words[2]);
    const Scene scene = radial_scene(edges);
    if (words[0] == "each") count_each(scene, choice, edges, hand);
    if (words[0] == "cold") count_cold(scene, choice, edges, hand, chosen_steps());
    return EXIT_SUCCESS;
}

}  // namespace
}  // namespace touchline::bench

int main(int argc, char** argv) {
    return touchline::bench::count({argv + 1, argv + argc});
}
