#include "app/device/device_words.h"

#include <fmt/format.h>

namespace touchline {
namespace {

std::string words_of(StopPlace place) {
    switch (place) {
        case StopPlace::away:
            return "Push the handle away from you until it stops. Hold it still there.";
        case StopPlace::towards:
            return "Pull the handle towards you until it stops. Hold it still there.";
        case StopPlace::sideways:
            return "Move the handle until both arms point straight out to the sides. Hold it still "
                   "there.";
    }
    return {};
}

std::string words_of(HomingStep step, const DeviceProfile& profile) {
    switch (step) {
        case HomingStep::to_home:
            return "The force is off. First, move the handle a little. " +
                   words_of(profile.home_place);
        case HomingStep::to_check:
            return "That was the first place. " + words_of(profile.check.place);
        case HomingStep::to_left:
            return "Now move the handle to the left, by the width of a hand. Hold it still there.";
        case HomingStep::to_home_again:
            return "Once more the first place. " + words_of(profile.home_place);
        case HomingStep::to_check_again:
            return "Once more the second place. " + words_of(profile.check.place);
        case HomingStep::done:
            return "The place of the handle is found.";
    }
    return {};
}

std::string noticed(const HomingView& view) {
    switch (view.remark) {
        case HomingRemark::none:
            return {};
        case HomingRemark::silent:
            return "The board does not answer. Check its USB cable. ";
        case HomingRemark::not_moved:
            return "The handle has not moved. ";
        case HomingRemark::misfit:
            return fmt::format("Not there yet: {:.0f} millimetres off. ", 1000.0 * view.misfit_m);
        case HomingRemark::not_left:
            return "That was not to the side. ";
        case HomingRemark::starting_over:
            return fmt::format(
                "That did not fit three times. The way between the places is {:.0f} percent of "
                "what it should be. Perhaps this handle is of another kind. We start again. ",
                100.0 * view.turn_share);
        case HomingRemark::lost_count:
            return "The board lost count. We start again. ";
        case HomingRemark::reversed:
            return "The places came in the wrong order, or plugs are exchanged. We start again. ";
        case HomingRemark::replugged:
            return "The plugs are not as they were. The handle is measured anew. ";
        case HomingRemark::measured:
            return "The handle was measured. That is kept. ";
    }
    return {};
}

std::string wrong_motor(int port) {
    return fmt::format(
        "There is no force. The motor on plug {} pushes the wrong way. Turn its plug round.", port);
}

std::string idle_motor(int port) {
    return fmt::format(
        "The motor on plug {} did not move the handle. Let go of it, and check that plug.", port);
}

std::string what_motors_did(NudgeVerdict verdict, const BoardFrame& frame) {
    switch (verdict) {
        case NudgeVerdict::running:
            return "Move the handle to the middle and let go of it. It will twitch four times.";
        case NudgeVerdict::works:
            return "Both motors work.";
        case NudgeVerdict::no_power:
            return "The handle did not twitch. Let go of it, and turn on the power of the motors.";
        case NudgeVerdict::motor_1_off:
            return idle_motor(frame.motor_port(1));
        case NudgeVerdict::motor_2_off:
            return idle_motor(frame.motor_port(2));
        case NudgeVerdict::reversed_1:
            return wrong_motor(frame.motor_port(1));
        case NudgeVerdict::reversed_2:
            return wrong_motor(frame.motor_port(2));
        case NudgeVerdict::reversed_both:
            return "There is no force. Both motors push the wrong way. Turn both plugs round.";
        case NudgeVerdict::swapped:
            return "There is no force. The plugs of the two motors are exchanged. Change them "
                   "back.";
        case NudgeVerdict::restless:
            return "The handle was held or moved. Let go of it in the middle.";
        case NudgeVerdict::silent:
            return "The board does not answer. Check its USB cable.";
    }
    return {};
}

}  // namespace

std::string words_of(const HomingView& view, const DeviceProfile& profile) {
    return noticed(view) + words_of(view.step, profile);
}

std::string words_of(NudgeVerdict verdict, const BoardFrame& frame) {
    const std::string told = what_motors_did(verdict, frame);
    return is_wrong(verdict) ? told + " Then find the handle's home again." : told;
}

}  // namespace touchline
