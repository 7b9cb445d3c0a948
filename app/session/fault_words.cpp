#include "app/session/fault_words.h"

#include <array>

#include <fmt/format.h>

namespace touchline {
namespace {

// In the order of the faults.
constexpr std::array<FaultWords, fault_count> faults{{
    {},
    {"The force is off.", "The device does not answer.",
     "Please ask the staff to check its cable. Once it answers, the voice tells you where to move "
     "the handle."},
    {"The force is off.", "The handle moved too fast.",
     "Hold it still. The force comes back by itself."},
    {"The force is off.", "The device pushed harder than it should.",
     "Hold the handle and call the staff."},
    {"The force is off.", "The handle kept shaking.",
     "Hold it firmly and choose softer lines. If it does not stop, call the staff."},
    {"The force is off.", "Nobody seems to hold the handle. Its ball may have come off.",
     "Please call the staff."},
    {"The force is off.", "The handle’s position jumped.",
     "Please call the staff. They check the arms of the device and its cable."},
    {"The force is off.", "The device or the program reported an impossible number.",
     "Please tell the staff."},
    {"The force is off.", "The emergency stop was pressed.", "When all is safe, call the staff."},
}};

}  // namespace

FaultWords words_of(Fault fault) {
    return faults[static_cast<std::size_t>(fault)];
}

std::string announcement_of(Fault fault) {
    if (fault == Fault::none) return {};
    const FaultWords words = words_of(fault);
    return fmt::format("{} {} {} You can go on exploring without force.", words.what, words.why,
                       words.what_to_do);
}

std::string_view words_of(ForceState state) {
    switch (state) {
        case ForceState::off:
            return "off";
        case ForceState::armed:
            return "waiting until the hand is clear of lines";
        case ForceState::ramp:
            return "coming on";
        case ForceState::live:
            return "on";
        case ForceState::fault:
            return "stopped";
    }
    return "";
}

std::string_view words_of(Limit limit) {
    switch (limit) {
        case Limit::heat:
            return "less: the motors are warm";
        case Limit::damped:
            return "damped: it pushed too much";
        case Limit::pose:
            return "less: the arms of the device are nearly straight";
        case Limit::speed:
            return "only braking: the hand is fast";
        case Limit::hand:
            return "fading: nobody seems to hold the handle";
        case Limit::unreachable:
            return "none: out of reach";
        case Limit::none:
        case Limit::gain:
        case Limit::slew:
        case Limit::torque:
        case Limit::force:
        case Limit::fault:
            return "";
    }
    return "";
}

std::string spoken_fault(Fault fault, const Language& language) {
    if (fault == Fault::none) return {};
    const FaultWords words = words_of(fault);
    std::string text;
    for (const std::string_view part : {words.what, words.why, words.what_to_do})
        text += language.text("fault", std::string(part)) + ' ';
    return text + language.text("fault", "You can go on exploring without force.");
}

}  // namespace touchline
