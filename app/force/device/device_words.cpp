#include "app/force/device/device_words.h"

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
            return "Move the handle until the device’s arms point straight to the sides. Hold it "
                   "still there.";
    }
    return {};
}

std::string words_of(HomingStep step, const DeviceProfile& profile) {
    switch (step) {
        case HomingStep::to_home:
            return "To get the force back, the handle must find its place. Move it a little "
                   "first. " +
                   words_of(profile.home_place);
        case HomingStep::to_check:
            return words_of(profile.check.place);
        case HomingStep::to_left:
            return "Now move the handle to the left, by a hand’s width. Hold it still there.";
        case HomingStep::to_home_again:
            return "Now the first place once more. " + words_of(profile.home_place);
        case HomingStep::to_check_again:
            return "Now the second place once more. " + words_of(profile.check.place);
        case HomingStep::to_answer:
            return "One question. Push the handle away from you until it stops. With your other "
                   "hand, feel the two arms next to the motors. If they form one straight line, "
                   "move the handle to the left. If they do not, move it to the right. The width "
                   "of a hand is enough. Hold it still there.";
        case HomingStep::done:
            return "The handle’s position is now known.";
    }
    return {};
}

std::string noticed(const HomingView& view) {
    switch (view.remark) {
        case HomingRemark::none:
            return view.step == HomingStep::to_check ? "That was the first place. " : "";
        case HomingRemark::silent:
            return "The board does not answer. Check its USB cable. ";
        case HomingRemark::not_moved:
            return "The handle has not moved. ";
        case HomingRemark::misfit:
            return fmt::format("Not there yet. It is {:.0f} millimetres off. ",
                               1000.0 * view.misfit_m);
        case HomingRemark::not_left:
            return "That was not to the side. ";
        case HomingRemark::starting_over:
            return "That did not fit three times. We start again. ";
        case HomingRemark::no_such_scale:
            return fmt::format(
                "The places do not fit. The way between them is {:.0f} percent of what it should "
                "be. Perhaps this handle is of another kind. We start again. ",
                100.0 * view.turn_share);
        case HomingRemark::other_kind:
            return "Then this handle is not of the kind that was chosen. We start again. ";
        case HomingRemark::either_kind:
            return "Perhaps this handle is of another kind. We start again. ";
        case HomingRemark::lost_count:
            return "The board lost count. We start again. ";
        case HomingRemark::reversed:
            return "The places came in the wrong order, or the plugs are swapped. We start again. ";
        case HomingRemark::replugged:
            return "The plugs have been changed. The handle will be measured again. ";
        case HomingRemark::measured:
            return "The handle has been measured. ";
    }
    return {};
}

std::string wrong_motor(int port) {
    return fmt::format(
        "There is no force. The motor on plug {} pushes the wrong way. Reverse its plug.", port);
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
            return "There is no force. Both motors push the wrong way. Reverse both plugs.";
        case NudgeVerdict::swapped:
            return "There is no force. The two motor plugs are swapped. Swap them back.";
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

std::string words_again(const std::string& words) {
    return "Once more. " + words;
}

std::string words_outside_the_middle(const BoardFrame& frame) {
    return "The handle is not in the middle yet. " + words_of(NudgeVerdict::running, frame);
}

std::string words_of(NudgeVerdict verdict, const BoardFrame& frame) {
    const std::string told = what_motors_did(verdict, frame);
    return is_wrong(verdict) ? told + " Then find the handle’s starting point again." : told;
}

}  // namespace touchline
