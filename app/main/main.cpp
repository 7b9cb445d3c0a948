// The executable: the command line with the two commands that need more than files.
#include "app/cli/options.h"
#include "app/cli/tour.h"
#include "app/isolation/process/memory.h"
#include "app/main/kiosk_window.h"

#include <iostream>
#include <string>
#include <vector>

int main(int argc, char** argv) {
    touchline::forbid_core_dumps();
    touchline::keep_memory_compact();
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const auto run_kiosk = [](const touchline::KioskArguments& kiosk) {
        return touchline::run_kiosk(kiosk);
    };
    return touchline::run_command_line(arguments, {run_kiosk, touchline::run_tour}, std::cout,
                                       std::cerr);
}
