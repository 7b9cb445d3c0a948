// The kiosk's program as it is installed, on the display that DISPLAY names:
//
//   kiosk_program_bench start PROGRAM RUNS         start to the first frame, each file of the
//   program
//                                                  taken out of the page cache first, then not
//   kiosk_program_bench use PROGRAM WIDTH HEIGHT   processor time and memory: nobody here, then a
//                                                  visit with a hand that moves
//
// Prints rows of a table of values, separated by commas.
#include "config/types/steady_clock.h"
#include "tests/lab/bench/kiosk/process_tree.h"
#include "tests/lab/bench/kiosk/running_kiosk.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr int stretches = 21;
constexpr double stretch_s = 2.0;
constexpr double frame_s = 1.0 / 60.0;
constexpr double longest_rest_s = 40.0;  // then all parts that rest do (servo, sound: after 30 s)

double at_share(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void sleep_s(double time_s) {
    std::this_thread::sleep_for(std::chrono::duration<double>(time_s));
}

double load() {
    double load = 0.0;
    (void)getloadavg(&load, 1);
    return load;
}

int measure_start(const std::string& program, int runs) {
    std::vector<std::string> files;
    {
        const RunningKiosk first(program);
        for (const pid_t process : tree_of(first.pid()))
            std::ranges::copy(mapped_files(process), std::back_inserter(files));
    }
    for (const bool is_cold : {true, false}) {
        std::vector<double> times_s;
        for (int i = 0; i < runs; ++i) {
            if (is_cold) std::ranges::for_each(files, forget_cached);
            times_s.push_back(RunningKiosk(program).start_s());
        }
        fmt::print("{},{:.3f},{:.3f},{:.3f},{:.1f}\n", is_cold ? "cold" : "warm",
                   at_share(times_s, 0.5), at_share(times_s, 0.9), at_share(times_s, 1.0), load());
    }
    return 0;
}

/// Moves the pointer round the place of a picture, and presses a key now and then.
class Hand {
  public:
    Hand(int width_px, int height_px)
        : width_px_(width_px), height_px_(height_px), pipe_(popen("xdotool - 2>&1", "w")) {}

    ~Hand() { pclose(pipe_); }

    Hand(const Hand&) = delete;
    Hand& operator=(const Hand&) = delete;

    /// Moves on for so long, sixty times a second. A round takes four seconds.
    void move_for(double time_s) {
        const double end_s = now_s() + time_s;
        while (now_s() < end_s) {
            const double turn_rad = 2.0 * std::numbers::pi * now_s() / 4.0;
            fmt::print(pipe_, "mousemove {:.0f} {:.0f}\n",
                       width_px_ * (0.27 + 0.14 * std::cos(turn_rad)),
                       height_px_ * (0.42 + 0.2 * std::sin(turn_rad)));
            std::fflush(pipe_);
            sleep_s(frame_s);
        }
    }

    static void press(const std::string& keys) {
        const std::string command =
            "xdotool search --name '^Touchline$' key --delay 400 " + keys + " >/dev/null 2>&1";
        if (std::system(command.c_str()) != 0) fmt::print(stderr, "no key: {}\n", keys);
    }

  private:
    static double now_s() { return 1e-9 * static_cast<double>(steady_now_ns()); }

    int width_px_;
    int height_px_;
    std::FILE* pipe_;
};

/// `act` fills a stretch of time.
void measure_use(const char* name, pid_t kiosk, int width_px, int height_px,
                 const std::function<void()>& act) {
    std::vector<double> shares, memory_MB;
    double figure_MB = 0.0;
    for (int i = 0; i < stretches; ++i) {
        const double before_s = processor_time_s(tree_of(kiosk));
        const std::int64_t start_ns = steady_now_ns();
        act();
        const double wall_s = 1e-9 * static_cast<double>(steady_now_ns() - start_ns);
        const std::vector<pid_t> tree = tree_of(kiosk);
        shares.push_back(100.0 * (processor_time_s(tree) - before_s) / wall_s);
        const TreeMemory memory = memory_of(tree);
        memory_MB.push_back(memory.all_MB);
        figure_MB = std::max(figure_MB, memory.figure_MB);
    }
    fmt::print("{},{},{},{:.2f},{:.2f},{:.0f},{:.0f},{:.0f},{:.1f}\n", name, width_px, height_px,
               at_share(shares, 0.5), at_share(shares, 1.0), at_share(memory_MB, 0.5),
               at_share(memory_MB, 1.0), figure_MB, load());
    std::fflush(stdout);
}

int measure_use(const std::string& program, int width_px, int height_px) {
    const RunningKiosk kiosk(program);
    sleep_s(longest_rest_s);
    measure_use("idle", kiosk.pid(), width_px, height_px, [] { sleep_s(stretch_s); });
    Hand::press("Return Return Return");  // begins, in English, with the practice shape
    Hand hand(width_px, height_px);
    hand.move_for(stretch_s);
    measure_use("in use", kiosk.pid(), width_px, height_px, [&hand] {
        Hand::press("Down");  // something is said
        hand.move_for(stretch_s);
    });
    return 0;
}

}  // namespace
}  // namespace touchline

int main(int count, char** words) {
    const std::vector<std::string> arguments(words + 1, words + count);
    if (arguments.size() == 3 && arguments[0] == "start")
        return touchline::measure_start(arguments[1], std::stoi(arguments[2]));
    if (arguments.size() == 4 && arguments[0] == "use")
        return touchline::measure_use(arguments[1], std::stoi(arguments[2]),
                                      std::stoi(arguments[3]));
    std::fprintf(stderr,
                 "usage: kiosk_program_bench start PROGRAM RUNS | use PROGRAM WIDTH HEIGHT\n");
    return 2;
}
