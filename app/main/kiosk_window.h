// The kiosk in its window: session, loading and servo together, and what leads its hand.
// Threads: call everything from the main thread. It starts the servo's thread and those for
// loading.
#pragma once

#include "app/cli/options.h"
#include "app/force/servo/servo_client.h"
#include "config/settings/settings.h"
#include "config/types/result.h"
#include "config/types/vec2.h"
#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/pantograph/profile.h"

#include <functional>
#include <memory>
#include <string>

namespace touchline {

struct KioskServo {
    std::unique_ptr<ServoClient> client;
    DeviceProfile profile = default_profile();
    std::string hand_words;   // as LiveFacts::hand_words
    std::string hand_name;    // as LiveFacts::hand_name
    bool has_motors = false;  // the force follows the real-time tier
    std::string note;         // why it is not the expected servo; may be empty
};

/// Chooses the kiosk's servo: a process for the device that the settings name and that is there,
/// else a thread for a simulated one that `hand` leads. Waits for the device.
[[nodiscard]] Result<KioskServo> start_servo(const std::shared_ptr<MouseHand>& hand,
                                             const Settings& settings);

/// Gives the kiosk its servo. The pointer leads `hand`.
using ServoStarter = std::function<Result<KioskServo>(const std::shared_ptr<MouseHand>& hand,
                                                      const Settings& settings)>;

/// Runs until somebody quits or the program is asked to end (SIGINT, SIGTERM). Without a device the
/// mouse is the hand of a simulated pantograph. Returns the exit status: 0 if it ended as asked; 1,
/// with one line on stderr, if there is no window or it did not end within three seconds of being
/// asked. With `measure_s` it runs that long with the window and that long without it, prints a
/// line for each, and ends by itself.
[[nodiscard]] int run_kiosk(const KioskArguments& arguments,
                            const ServoStarter& start = start_servo);

inline constexpr double led_m_per_s = 0.6;

/// Moves for dt_s from where the hand means to be towards the pointer, at a hand's pace: a pointer
/// jumps across a screen and a hand does not, and the servo would take it for a thrown handle. A
/// pure function.
[[nodiscard]] inline Position paced(Position from, Position pointer, double dt_s) {
    const Position way = pointer - from;
    const double most_m = led_m_per_s * dt_s;
    return norm(way) > most_m ? from + along<Position>(direction_of(way), most_m) : pointer;
}

/// Forbids core dumps of this process and of those it starts: a visitor's data must not stay on a
/// disk, so a program that crashes leaves no memory image. Call it at the start of main.
void forbid_core_dumps();

}  // namespace touchline
