#include "app/device/device_words.h"

#include <fmt/format.h>

namespace touchline {
namespace {

std::string words_of(StopPlace place) {
    switch (place) {
        case StopPlace::away:
            return "push the handle away from you until it stops, then hold it still.";
        case StopPlace::towards:
            return "pull the handle towards you until it stops, then hold it still.";
        case StopPlace::sideways:
            return "move the handle until both arms point straight out to the sides, then hold it "
                   "still.";
    }
    return {};
}

std::string words_of(HomingStep step, const DeviceProfile& profile) {
    switch (step) {
        case HomingStep::to_home:
            return "The force is off. First, move the handle a little, and " +
                   words_of(profile.home_place);
        case HomingStep::to_check:
            return "Second, " + words_of(profile.check.place);
        case HomingStep::to_home_again:
            return "Third, " + words_of(profile.home_place);
        case HomingStep::to_check_again:
            return "Last, " + words_of(profile.check.place);
        case HomingStep::done:
            return "Done. The handle is ready.";
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
        case HomingRemark::starting_over:
            return "That did not fit three times. We start again. ";
        case HomingRemark::lost_count:
            return "The board lost count. We start again. ";
        case HomingRemark::reversed:
            return "The stops came the wrong way round. We start again. ";
        case HomingRemark::swapped:
            return "The plugs of the two motors are swapped. That is noted, nothing need be done. "
                   "We start again. ";
        case HomingRemark::measured:
            return "The scale of this unit is measured and kept. ";
    }
    return {};
}

}  // namespace

std::string words_of(const HomingView& view, const DeviceProfile& profile) {
    return noticed(view) + words_of(view.step, profile);
}

std::string words_of(NudgeVerdict verdict) {
    switch (verdict) {
        case NudgeVerdict::running:
            return "Let go of the handle. It will twitch four times.";
        case NudgeVerdict::works:
            return "Both motors work.";
        case NudgeVerdict::no_power:
            return "The motors have no power: turn on the switch of the adaptor and of the device.";
        case NudgeVerdict::motor_1_off:
            return "Motor 1 does not move: check its plug, then try again.";
        case NudgeVerdict::motor_2_off:
            return "Motor 2 does not move: check its plug, then try again.";
        case NudgeVerdict::reversed:
            return "A motor pulls the wrong way: check the profile of this unit.";
        case NudgeVerdict::swapped:
            return "The plugs of the two motors are swapped: home the handle, or swap them back.";
        case NudgeVerdict::restless:
            return "The handle was moving: let go of it and try again.";
        case NudgeVerdict::silent:
            return "The board does not answer. Check its USB cable.";
    }
    return {};
}

}  // namespace touchline
