#include "haptics/device/moteus/moteus_pair.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace touchline {
namespace {

using FaultWords = std::pair<std::uint32_t, std::string_view>;

// By the maker's list of codes (README.md).
constexpr std::array<FaultWords, 16> faults{{
    {32, "calibration found no magnet: check the magnet on the shaft"},
    {33, "its motor driver gave up: check the power supply and the motor's three wires"},
    {34, "its supply voltage is too high: check the power supply"},
    {35, "its encoder sees no magnet: check the magnet on the shaft"},
    {36, "its motor was never calibrated: run the maker's calibration once"},
    {38, "it is too hot: let it cool down, and check what holds the handle"},
    {39, "its position bounds stop it: set servopos.position_min and position_max to nan"},
    {40, "its supply voltage is too low: switch the power supply on"},
    {41, "its settings were changed at work: start again"},
    {42, "it has no encoder for its motor: check its encoder settings"},
    {43, "it has no encoder for its shaft: check its encoder settings"},
    {44, "its motor driver does not start: switch its power off and on"},
    {46, "it lost its rhythm: switch its power off and on"},
    {48, "its position bounds are beyond its range: set them to nan"},
    {49, "its position went astray: switch its power off and on"},
    {50, "its speed went astray: switch its power off and on"},
}};

}  // namespace

std::string_view words_of_moteus_fault(std::uint32_t code) {
    const auto* const found = std::ranges::find(faults, code, &FaultWords::first);
    return found != faults.end() ? found->second
                                 : "the maker's list of fault codes says what to do";
}

std::string MoteusPair::words_of(const MotorTrouble& trouble) const {
    using Kind = MotorTrouble::Kind;
    const std::string who =
        trouble.motor == 0
            ? "the motors' controllers"
            : "the controller of motor " + std::to_string(trouble.motor) + " (id " +
                  std::to_string(ids_[static_cast<std::size_t>(trouble.motor - 1)]) + ")";
    switch (trouble.kind) {
        case Kind::none:
            return "nothing is wrong with " + who;
        case Kind::fault:
            return who + " stopped with fault " + std::to_string(trouble.code) + ": " +
                   std::string(words_of_moteus_fault(trouble.code));
        case Kind::watchdog_not_set:
            return who + " does not confirm its watchdog, so no force is given: renew its firmware";
        case Kind::not_let_go:
            return who +
                   " would not let its motor go when this computer fails, so no force is given: "
                   "set its servo.timeout_mode to 0";
        case Kind::too_old:
            return who + " lacks what force needs: renew its firmware";
        default:
            return who +
                   " does not answer: check the power supply, the bus and its terminators, and "
                   "the ids";
    }
}

}  // namespace touchline
