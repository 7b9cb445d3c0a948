// touchline-import: the kiosk starts it for one list or one file of a stick. It closes its sandbox,
// and only then reads the first name.
#include "app/sticks/import_program.h"

#include <cstdio>
#include <exception>

#include <unistd.h>

namespace {

/// The C++ library would end by a forbidden signal.
[[noreturn]] void end_at_once() {
    _exit(touchline::first_refusal_status + static_cast<int>(touchline::StickRefusal::unreadable));
}

}  // namespace

int main(int argc, char** argv) {
    std::set_terminate(end_at_once);
    const int status = touchline::run_import({argv + 1, argv + argc});
    if (status == 2)
        (void)std::fprintf(stderr,
                           "touchline-import: the kiosk starts it by itself; use 'touchline'\n");
    _exit(status);  // skips the exit code of libraries, which may want forbidden calls
}
