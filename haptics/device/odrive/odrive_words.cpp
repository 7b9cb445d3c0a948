#include "haptics/device/odrive/odrive_pair.h"

#include <array>
#include <string>
#include <utility>

namespace touchline {
namespace {

using ErrorWords = std::pair<std::uint32_t, std::string_view>;

// Bits of an axis's error, by the maker's list (README.md).
constexpr std::array<ErrorWords, 10> axis_errors{{
    {1U << 0U, "it may not work yet: run the maker's calibration of motor and encoder once"},
    {1U << 6U, "its motor gave up: check the power supply and the motor's three wires"},
    {1U << 7U, "its estimate of the motor failed: run the maker's calibration once"},
    {1U << 8U, "its encoder gave up: check the encoder's magnet and cable"},
    {1U << 9U, "its speed went beyond its limit: raise controller.config.vel_limit"},
    {1U << 12U, "it met its lower end switch: switch the end switches off"},
    {1U << 13U, "it met its upper end switch: switch the end switches off"},
    {1U << 14U, "a stop was asked for on its CAN bus: start it again"},
    {1U << 18U, "it is too hot: let it cool down, and check what holds the handle"},
    {1U << 19U, "it does not know where its shaft is: check the encoder"},
}};

std::string words_of_error(std::uint32_t error) {
    for (const auto& [bit, words] : axis_errors)
        if ((error & bit) != 0) return std::string(words);
    return "the maker's list of errors says what to do";
}

}  // namespace

std::string OdrivePair::words_of(const MotorTrouble& trouble) const {
    using Kind = MotorTrouble::Kind;
    const std::string who = trouble.motor == 0
                                ? "the ODrive"
                                : "the ODrive's axis " + std::to_string(trouble.motor - 1) +
                                      " (motor " + std::to_string(trouble.motor) + ")";
    switch (trouble.kind) {
        case Kind::none:
            return "nothing is wrong with " + who;
        case Kind::fault:
            return who + " stopped with error " + std::to_string(trouble.code) + ": " +
                   words_of_error(trouble.code);
        case Kind::watchdog_not_set:
            return who + " does not confirm its watchdog, so no force is given: renew its firmware";
        case Kind::no_encoder:
            return who + " does not know its encoder yet: run the maker's calibration once";
        case Kind::not_calibrated:
            return who + " does not know its motor yet: run the maker's calibration once";
        case Kind::other_control:
            return who +
                   " keeps a control mode or a ramp that changes the torque it is told, so no "
                   "force "
                   "is given: set its controller.config.control_mode and input_mode to 1 and save";
        case Kind::too_old:
        case Kind::not_let_go:
            return who +
                   " lacks what force needs: renew its firmware; newer boards with one axis each "
                   "(Pro, S1) are not driven";
        default:
            return who +
                   " does not answer: check its power supply and the port, and that no "
                   "other protocol runs on it";
    }
}

}  // namespace touchline
