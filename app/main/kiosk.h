// The kiosk: window, session, loading and servo together.
// Threads: call it from the main thread. It starts the servo's thread and one for loading.
#pragma once

#include "app/cli/command_line.h"
#include "app/main/kiosk_servo.h"

#include <functional>
#include <memory>

namespace touchline {

/// Gives the kiosk its servo. The pointer leads `hand`.
using ServoStarter = std::function<Result<KioskServo>(const std::shared_ptr<MouseHand>& hand)>;

/// Runs until somebody quits or the program is asked to end (SIGINT, SIGTERM). Without a device the
/// mouse is the hand of a simulated pantograph. Returns the exit status: 0 if it ended as asked; 1,
/// with one line on stderr, if there is no window or it did not end within three seconds of being
/// asked. With `measure_s` it runs that long with the window and that long without it, prints a
/// line for each, and ends by itself.
[[nodiscard]] int run_kiosk(const KioskArguments& arguments,
                            const ServoStarter& start = start_servo);

}  // namespace touchline
