#include "app/force/backends/kiosk_backends.h"
#include "app/force/servo/servo_process.h"
#include "app/force/servo/servo_thread.h"
#include "app/isolation/process/places.h"
#include "app/main/kiosk_window.h"
#include "config/settings/setting_rows.h"
#include "haptics/device/simulated/simulated_pantograph.h"

#include <optional>
#include <string>
#include <utility>

namespace touchline {
namespace {

KioskServo with_motors(MotorDevice found) {
    found.servo.program = companion("touchline-servo");
    found.servo.summons = environment("TOUCHLINE_SERVO_SOCKET");
    KioskServo servo;
    servo.client = std::make_unique<ServoProcess>(std::move(found.servo));
    servo.has_motors = true;
    servo.profile = found.profile;
    servo.hand_words = "device {0}";
    servo.hand_name = std::move(found.name);
    servo.note = std::move(found.notice);
    return servo;
}

Result<KioskServo> simulated(const std::shared_ptr<MouseHand>& hand) {
    auto thread = std::make_unique<ServoThread>();
    auto started = thread->start(
        std::make_unique<SimulatedPantograph>(default_profile(), SimulationOptions{}, hand),
        default_profile());
    if (!started) return tl::unexpected(started.error());
    KioskServo servo;
    servo.client = std::move(thread);
    servo.hand_words = "mouse, no device";
    return servo;
}

/// The make is told by its name in the file of settings, which is that of its row.
Result<std::optional<MotorDevice>> find_device(const Settings& settings) {
    const auto row = find_backend(name_of(settings.device_make));
    if (!row) return tl::unexpected(row.error());
    return row->find(settings.device_port);
}

}  // namespace

Result<KioskServo> start_servo(const std::shared_ptr<MouseHand>& hand, const Settings& settings) {
    auto device = find_device(settings);
    if (device && *device) return with_motors(std::move(**device));
    auto servo = simulated(hand);
    if (servo)
        servo->note = device ? "there is no pantograph: the mouse is the hand of a simulated one; "
                               "plug it in, then start the kiosk again"
                             : device.error().line;
    return servo;
}

}  // namespace touchline
