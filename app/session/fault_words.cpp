#include "app/session/fault_words.h"

#include "haptics/safety/safety_state.h"

#include <array>
#include <initializer_list>

namespace touchline {
namespace {

constexpr std::string_view call_the_staff = "Please call the staff.";
constexpr std::string_view hold_still = "Hold it still. The force comes back by itself.";
constexpr std::string_view hold_firmly = "Hold it firmly and choose softer lines.";

// In the order of Fault.
constexpr std::array<FaultWords, fault_count> faults{{
    {},
    {"The handle does not answer.", call_the_staff,
     "Check its cable. The voice then tells you where to move the handle."},
    {"The handle moved too fast.", hold_still, hold_still},
    {"The handle pushed harder than it should.", "Hold the handle and call the staff.",
     "Hold the handle."},
    {"The handle kept shaking.", "Hold it firmly and choose softer lines. Then call the staff.",
     "Hold it firmly and choose softer lines."},
    {"Nobody seems to hold the handle. Its ball may have come off.", call_the_staff,
     "Put the ball on and hold it."},
    {"The handle’s position jumped.", call_the_staff,
     "Check the arms of the device and its cable."},
    {"The device or the program reported an impossible number.", call_the_staff,
     "Copy the log for whoever maintains the kiosk."},
    {"The emergency stop was pressed.", call_the_staff, "Make sure that all is safe."},
}};

std::string told(std::initializer_list<std::string_view> sentences, const Language& language) {
    std::string text;
    for (const std::string_view sentence : sentences) {
        if (!text.empty()) text += ' ';
        text += language.text("fault", std::string(sentence));
    }
    return text;
}

}  // namespace

FaultWords words_of(Fault fault) {
    return faults[static_cast<std::size_t>(fault)];
}

std::string spoken_fault(Fault fault, const Language& language) {
    if (fault == Fault::none) return {};
    const FaultWords words = words_of(fault);
    return told({"The force is off.", words.why, words.visitor_does}, language);
}

std::string staffs_fault(Fault fault, const Language& language) {
    if (fault == Fault::none) return {};
    const FaultWords words = words_of(fault);
    const std::string text = told({"The force is off.", words.why, words.staff_does}, language);
    const FaultRule& rule = fault_rules()[static_cast<std::size_t>(fault) - 1];
    if (rule.clears == FaultClears::when_gone) return text;
    return text + ' ' +
           language.text("fault", "Then choose: {0}.",
                         {language.text("operator", "Reset the force fault")});
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

}  // namespace touchline
