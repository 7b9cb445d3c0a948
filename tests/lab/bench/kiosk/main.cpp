// How soon the kiosk answers, in real time:
//
//   kiosk_bench answers           from a key to sound, to speech and to a picture of the gallery
//   kiosk_bench pictures FOLDER   from a picture of a stick that is chosen to the first tick that
//                                 feels it and may give force; a row a picture, values separated by
//                                 commas
#include "app/visit/visit.h"
#include "tests/lab/bench/kiosk/real_kiosk.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <sys/resource.h>

namespace touchline {
namespace {

constexpr int runs = 21;
constexpr std::int64_t second_ns = 1'000'000'000;

double at_share(std::vector<double> times_ms, double share) {
    std::ranges::sort(times_ms);
    return times_ms[static_cast<std::size_t>(share * static_cast<double>(times_ms.size() - 1))];
}

double load() {
    double load = 0.0;
    (void)getloadavg(&load, 1);
    return load;
}

void print(const char* what, const std::vector<double>& times_ms, double goal_ms) {
    fmt::print("| {} | {:.1f} | {:.1f} | {:.1f} | {:.0f} |\n", what, at_share(times_ms, 0.5),
               at_share(times_ms, 0.9), at_share(times_ms, 1.0), goal_ms);
}

void measure_answers() {
    RealKiosk kiosk;
    kiosk.run_for(second_ns);
    kiosk.press(KeyRole::select);  // begins
    kiosk.press(KeyRole::select);  // English
    std::vector<double> sound_ms;
    for (int i = 0; i < runs; ++i) sound_ms.push_back(kiosk.heard_after_ms(KeyRole::down));
    kiosk.choose_sounds(CueAmount::none);
    std::vector<double> speech_ms;
    for (int i = 0; i < runs; ++i) speech_ms.push_back(kiosk.heard_after_ms(KeyRole::down));
    kiosk.focus_on(1);
    kiosk.press(KeyRole::select);  // the gallery
    std::vector<double> felt_ms;
    for (int i = 0; i < runs; ++i) {
        kiosk.press(KeyRole::down);
        felt_ms.push_back(kiosk.felt_after_ms(KeyRole::select));
        kiosk.run_for(second_ns / 5);
        kiosk.press(KeyRole::back);  // back to the choices
        kiosk.focus_on(2);
        kiosk.press(KeyRole::select);
        for (int down = 0; down <= i % 8; ++down) kiosk.press(KeyRole::down);
    }
    fmt::print(
        "load {:.2f}, {} runs\n\n| from a key to | median, ms | 90 of 100, ms | most, ms | "
        "goal, ms |\n|---|---|---|---|---|\n",
        load(), runs);
    print("its sound", sound_ms, 30.0);
    print("speech", speech_ms, 150.0);
    print("the first tick with the picture chosen", felt_ms, 1000.0);
    kiosk.stop();
}

/// Goes from wherever the visitor is to the list of the stick.
void go_to_stick(RealKiosk& kiosk) {
    while (open_screen(kiosk.kiosk().visit()) != VisitScreen::choose) kiosk.press(KeyRole::back);
    const auto stick = place_of(kiosk.kiosk().screen().items, static_cast<int>(VisitItem::stick));
    kiosk.focus_on(stick.value_or(0));
    kiosk.press(KeyRole::select);
}

bool is_picture(const ScreenItem& item) {
    return item.id >= static_cast<int>(VisitItem::entry);
}

/// Processor time of all workers that have ended.
double workers_ms() {
    rusage used{};
    (void)getrusage(RUSAGE_CHILDREN, &used);
    const auto ms = [](const timeval& time) {
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
    };
    return ms(used.ru_utime) + ms(used.ru_stime);
}

/// Each round chooses every picture once, so that none is the one read last.
void measure_pictures(const std::string& folder) {
    RealKiosk kiosk(folder);
    kiosk.run_for(2 * second_ns);
    kiosk.press(KeyRole::select);  // begins
    kiosk.press(KeyRole::select);  // English
    std::map<std::string, std::vector<double>> times_ms, worked_ms;
    std::size_t pictures = 1;
    for (int run = 0; run < runs; ++run) {
        for (std::size_t i = 0; i < pictures; ++i) {
            go_to_stick(kiosk);
            const std::vector<ScreenItem> items = kiosk.kiosk().screen().items;
            pictures = static_cast<std::size_t>(std::ranges::count_if(items, is_picture));
            kiosk.focus_on(i);
            const double before_ms = workers_ms();
            const double felt_ms = kiosk.felt_after_ms(KeyRole::select);
            times_ms[items.at(i).name].push_back(felt_ms);
            fmt::print(stderr, "{} {:.0f} ms\n", items.at(i).name, felt_ms);
            kiosk.run_for(second_ns / 4);
            worked_ms[items.at(i).name].push_back(workers_ms() - before_ms);
        }
    }
    for (const auto& [name, times] : times_ms)
        fmt::print("{},{:.0f},{:.0f},{:.0f},{:.0f},{:.1f}\n", name, at_share(times, 0.5),
                   at_share(times, 0.9), at_share(times, 1.0), at_share(worked_ms[name], 0.5),
                   load());
    kiosk.stop();
}

}  // namespace
}  // namespace touchline

int main(int count, char** words) {
    const std::vector<std::string> arguments(words + 1, words + count);
    if (arguments == std::vector<std::string>{"answers"}) {
        touchline::measure_answers();
    } else if (arguments.size() == 2 && arguments[0] == "pictures") {
        touchline::measure_pictures(arguments[1]);
    } else {
        std::fprintf(stderr, "usage: kiosk_bench answers | pictures FOLDER\n");
        return 2;
    }
    return 0;
}
