// The kiosk: window, session, loading and servo together.
// Threads: call it from the main thread. It starts the servo's thread and one for loading.
#pragma once

#include "app/cli/command_line.h"
#include "app/main/kiosk_servo.h"

#include <functional>
#include <memory>

namespace touchline {

/// Gives the kiosk its servo. `hand` is led by the pointer.
using ServoStarter = std::function<Result<KioskServo>(const std::shared_ptr<MouseHand>& hand)>;

/// Runs until somebody quits or the program is asked to end (SIGINT, SIGTERM). With no device
/// attached the mouse is the hand of a simulated pantograph. Returns the exit status: 0 when it
/// ended as asked, 1 when there is no window or it did not end within three seconds of being asked
/// (one line on stderr). With `measure_s` it ends by
/// itself after as long with the window and as long without, and prints a line for each.
[[nodiscard]] int run_kiosk(const KioskArguments& arguments,
                            const ServoStarter& start = start_servo);

}  // namespace touchline
