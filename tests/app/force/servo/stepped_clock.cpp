// A library to load before a program (LD_PRELOAD): it counts the program's reads of the wall clock
// and steps it; every other clock stays as it is.
#include "tests/app/force/servo/stepped_clock.h"

#include <cstdlib>
#include <ctime>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

namespace {

using touchline::SteppedClock;

SteppedClock* clock_of_test() {
    static SteppedClock* const clock = [] {
        const char* const path = std::getenv(touchline::stepped_clock_variable);
        const int file = path == nullptr ? -1 : open(path, O_RDWR | O_CLOEXEC);
        void* const start = file < 0 ? MAP_FAILED
                                     : mmap(nullptr, sizeof(SteppedClock), PROT_READ | PROT_WRITE,
                                            MAP_SHARED, file, 0);
        if (file >= 0) close(file);
        return start == MAP_FAILED ? nullptr : static_cast<SteppedClock*>(start);
    }();
    return clock;
}

bool is_wall(clockid_t id) {
    return id == CLOCK_REALTIME || id == CLOCK_REALTIME_COARSE || id == CLOCK_TAI;
}

void step(timespec& time) {
    SteppedClock* const clock = clock_of_test();
    if (clock == nullptr) return;
    ++clock->reads;
    constexpr std::int64_t ns_per_s = 1'000'000'000;
    const std::int64_t ns = time.tv_sec * ns_per_s + time.tv_nsec + clock->step_ns;
    time = {ns / ns_per_s, ns % ns_per_s};
}

}  // namespace

extern "C" {
int clock_gettime(clockid_t id, timespec* time) noexcept {
    const long result = syscall(SYS_clock_gettime, id, time);
    if (result == 0 && is_wall(id)) step(*time);
    return static_cast<int>(result);
}

int gettimeofday(timeval* time, void* /*zone*/) noexcept {
    timespec now{};
    const int result = clock_gettime(CLOCK_REALTIME, &now);
    *time = {now.tv_sec, now.tv_nsec / 1000};
    return result;
}

time_t time(time_t* time) noexcept {
    timespec now{};
    (void)clock_gettime(CLOCK_REALTIME, &now);
    if (time != nullptr) *time = now.tv_sec;
    return now.tv_sec;
}
}
