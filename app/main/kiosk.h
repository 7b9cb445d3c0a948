// The kiosk: window, session, loading and servo together.
// Threads: call it from the main thread. It starts the servo's thread and one for loading.
#pragma once

#include "app/cli/command_line.h"

namespace touchline {

/// Runs until somebody quits or the program is asked to end (SIGINT, SIGTERM). With no device
/// attached the mouse is the hand of a simulated pantograph. Returns the exit status: 0 when it
/// ended as asked, 1 when there is no window (one line on stderr). With `measure_s` it ends by
/// itself after as long with the window and as long without, and prints a line for each.
[[nodiscard]] int run_kiosk(const KioskArguments& arguments);

}  // namespace touchline
