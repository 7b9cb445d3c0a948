// Chooses the kiosk's servo: a process for the pantograph that is plugged in, else a thread for a
// simulated one.
// Threads: call it from the main thread; it waits for the USB.
#pragma once

#include "app/servo/servo_client.h"
#include "config/types/result.h"
#include "haptics/device/hand.h"
#include "haptics/pantograph/profile.h"

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

/// `hand` leads the simulated pantograph if there is no real one.
[[nodiscard]] Result<KioskServo> start_servo(const std::shared_ptr<MouseHand>& hand);

}  // namespace touchline
