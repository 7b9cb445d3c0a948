// Why a device cannot be used, as visitors and staff hear it: the rows of told_lines.h.
#include "app/visit/told_lines.h"

#include <array>

namespace touchline {
namespace {

constexpr std::string_view unplugged = "The handle is unplugged. Please call the staff.";
constexpr std::string_view staffs_unplugged = "The handle is unplugged. Plug its cable in again.";
constexpr std::string_view not_answering = "The handle does not answer. Please call the staff.";

// A visitor cannot help a controller or a service: device_trouble tells all there is to do.
constexpr std::string_view encoder_fails =
    "A motor’s encoder fails. Check its magnet and its cable.";
constexpr std::string_view not_calibrated =
    "A motor is not calibrated. Run its maker’s calibration once.";
constexpr std::string_view wires = "A motor has stopped. Check its power supply and its wires.";
constexpr std::string_view voltage =
    "The voltage of the motors is wrong. Check their power supply.";
constexpr std::string_view too_hot =
    "A motor is too hot. Let it cool down. Check what holds the handle.";
constexpr std::string_view begin_anew = "A motor has stopped. Switch its power off and on again.";
constexpr std::string_view wrong_setting =
    "A motor’s controller has a wrong setting. The log says which one.";
constexpr std::string_view old_firmware = "A motor’s controller is too old. Renew its firmware.";
constexpr std::string_view motor_stopped = "A motor has stopped. The log says why.";
constexpr std::string_view port_trouble =
    "The port of the device cannot be used. The log says why.";
constexpr std::string_view service_trouble =
    "The service of the device does not answer. Start it again.";

constexpr auto rows_of_devices = std::to_array<LineRow>({
    {"unplugged or gave up", unplugged, staffs_unplugged},
    {"the board was unplugged", unplugged, staffs_unplugged},
    {"the device was unplugged", unplugged, staffs_unplugged},
    {"is no longer plugged in", unplugged, staffs_unplugged},
    {"no board is plugged in", unplugged, staffs_unplugged},
    {"no pantograph's board is plugged in", unplugged, staffs_unplugged},
    {"no Inverse3 is plugged in", unplugged, staffs_unplugged},
    {"is not plugged in, by what its service says", unplugged, staffs_unplugged},
    {"nothing is plugged in there", unplugged, staffs_unplugged},
    {"kind of this handle is not chosen", "This handle is new. Please call the staff.",
     "This handle is new. Choose its kind, under Handle and tests."},
    {"it took too long", "That took too long. Please call the staff.",
     "That took too long. Find the handle’s starting point again."},
    {"has lost its place",
     "The handle has lost its place. The voice will tell you where to move it."},
    {"does not answer: check", not_answering,
     "The motors do not answer. Check their power supply and their cables."},
    {"does not answer", not_answering,
     "The handle does not answer. Unplug its cable, then plug it in again."},
    {"did not confirm zero torque",
     "Let go of the handle. Its motors may still push. Please call the staff.",
     "Let go of the handle. Its motors may still push. Turn off their power."},
    // Controllers of motors.
    {"no magnet", device_trouble, encoder_fails},
    {"encoder gave up", device_trouble, encoder_fails},
    {"has no encoder for", device_trouble, encoder_fails},
    {"does not know where its shaft is", device_trouble, encoder_fails},
    {"run the maker's calibration", device_trouble, not_calibrated},
    {"the motor's three wires", device_trouble, wires},
    {"its supply voltage", device_trouble, voltage},
    {"it is too hot", device_trouble, too_hot},
    {"switch its power off and on", device_trouble, begin_anew},
    {"settings were changed at work", device_trouble, begin_anew},
    {"a stop was asked for on its CAN bus", device_trouble, begin_anew},
    {"its position bounds", device_trouble, wrong_setting},
    {"vel_limit", device_trouble, wrong_setting},
    {"end switch", device_trouble, wrong_setting},
    {"timeout_mode", device_trouble, wrong_setting},
    {"input_mode", device_trouble, wrong_setting},
    {"renew its firmware", device_trouble, old_firmware},
    {"fault codes says what to do", device_trouble, motor_stopped},
    {"list of errors says what to do", device_trouble, motor_stopped},
    {"the encoders do not tell where the handle is", device_trouble,
     "The encoders do not tell the handle’s place. Use absolute ones."},
    {"the motors moved other arms", device_trouble,
     "The motors push the wrong way. Set their order and direction up again."},
    // Ports.
    {"another program has it", device_trouble,
     "Another program uses the device. End that program."},
    {"could not be opened: ", device_trouble, port_trouble},
    {"is no serial port", device_trouble, port_trouble},
    {"this service may not reach port", device_trouble, port_trouble},
    // The service of a device.
    {"motors have no power", device_trouble, "The device has no power. Plug in its power supply."},
    {"the Inverse3 is not calibrated", device_trouble,
     "The device must find its place. Put its handle into its holder."},
    {"axes were moved or turned", device_trouble,
     "The axes of the device were changed. Set them back in its service."},
    {"says that it is not ready", device_trouble,
     "The device is not ready yet. Wait a minute, then start it again."},
    {"start the Inverse3's service", device_trouble, service_trouble},
    {"service closed the connection", device_trouble, service_trouble},
    {"service cannot be talked to", device_trouble, service_trouble},
    {"is not the Inverse3's service", device_trouble, service_trouble},
    {"has not named its devices yet", device_trouble, service_trouble},
    {"more than one Inverse3", device_trouble,
     "Several devices are plugged in. Name the right one in the settings."},
    {"is no Inverse3", device_trouble,
     "The device is of another make. Choose its make in the settings."},
});

}  // namespace

std::span<const LineRow> device_lines() {
    return rows_of_devices;
}

}  // namespace touchline
