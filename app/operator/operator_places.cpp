#include "app/operator/operator_places.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

using P = OperatorPlace;

constexpr std::string_view how_to_enter =
    "Press Up once for 1, twice for 2, Down once for 0. Press Select to accept each digit. After "
    "the last one, press Select once more.";

constexpr std::array places{
    PlaceRow{P::pin, P::closed, "PIN of the operator", how_to_enter, "", false},
    PlaceRow{P::new_pin, P::closed, "Choose a PIN of 4 to 8 digits", how_to_enter, "", false},
    PlaceRow{P::new_pin_again, P::new_pin, "Enter the same PIN once more", how_to_enter, "", false},
    PlaceRow{P::home, P::closed, "Operator", "", "", false},
    PlaceRow{P::touch, P::home, "How it feels", "", ""},
    PlaceRow{P::feel, P::touch, "Lines and force", "", "feel"},
    PlaceRow{P::levels, P::touch, "Levels", "A level is how finely lines are followed.", "levels"},
    PlaceRow{P::picture, P::touch, "Detail of pictures", "", "picture"},
    PlaceRow{P::profiles, P::touch, "Profiles",
             "What a profile sets takes priority over the kiosk’s own settings.", ""},
    PlaceRow{P::ears, P::home, "Sound, speech and languages", "", ""},
    PlaceRow{P::sounds, P::ears, "Sounds and speech", "", "sound"},
    PlaceRow{P::volume, P::ears, "Volume", "Loudness at the ear, in decibels.", ""},
    PlaceRow{P::languages, P::ears, "Languages", "", "language"},
    PlaceRow{P::visits, P::home, "Visits", "", ""},
    PlaceRow{P::times, P::visits, "Waiting times", "", "time"},
    PlaceRow{P::hours, P::visits, "Hours", "", "hours"},
    PlaceRow{P::care, P::visits, "Notices and staff", "", "care"},
    PlaceRow{P::senses, P::home, "Camera, keys and screen", "", ""},
    PlaceRow{P::camera, P::senses, "Camera", "", "camera"},
    PlaceRow{P::keys, P::senses, "Keys", "", "keys"},
    PlaceRow{P::key_wizard, P::keys, "Assign the keys", "", "", false},
    PlaceRow{P::screen, P::senses, "Screen", "", "screen"},
    PlaceRow{P::sticks, P::senses, "USB sticks", "USB sticks with FAT and exFAT are always read.",
             "stick"},
    PlaceRow{P::device, P::home, "Handle and tests", "", ""},
    PlaceRow{P::homing, P::device, "Find the handle’s starting point",
             "The kiosk says where to move the handle. Force is off meanwhile.", ""},
    PlaceRow{P::kind, P::device, "Kind of handle",
             "Press Repeat to hear how to know each one. Press Select to choose it; the handle is "
             "then measured.",
             ""},
    PlaceRow{P::self_test, P::device, "Self-test", "", ""},
    PlaceRow{P::test_step, P::self_test, "Step of the self-test", "", "", false},
    PlaceRow{P::live, P::device, "What the handle is doing now", "", ""},
    PlaceRow{P::cleaning, P::device, "Clean the handle",
             "Force and keys are off for a while. You can wipe the handle and the keys.", ""},
    PlaceRow{P::cleaning_lock, P::cleaning, "The handle can be cleaned",
             "Force and keys are off. They come back by themselves.", "", false},
    PlaceRow{P::upkeep, P::home, "Upkeep", "", ""},
    PlaceRow{P::library, P::upkeep, "Copy from a USB stick", "Choose what to copy into this kiosk.",
             ""},
    PlaceRow{P::counters, P::upkeep, "What was counted", "Nothing is recorded about who visited.",
             ""},
    PlaceRow{P::log, P::upkeep, "Log and recording",
             "The log is copied beside the settings. Nothing about visitors is in it.", ""},
    PlaceRow{P::backup, P::upkeep, "Backup of the settings",
             "Copies all settings except the PIN, or brings the copy back.", ""},
    PlaceRow{P::paths, P::upkeep, "Set in the file only",
             "These are written in the kiosk’s file of settings.", "operator"},
    PlaceRow{P::close, P::upkeep, "Shut the kiosk down", "The program ends.", ""},
    PlaceRow{P::question, P::home, "Are you sure?", "", "", false},
};

static_assert(places.size() + 1 == operator_place_count);

using A = OperatorAction;

constexpr std::array actions{
    ActionRow{P::keys, A::learn_keys, "Assign the keys", "You press the key for each role twice."},
    ActionRow{P::device, A::clear_fault, "Reset the force fault", "Only when all is safe."},
    ActionRow{P::homing, A::find_home, "Begin", ""},
    ActionRow{P::self_test, A::run_all_tests, "All steps", "One after the other."},
    ActionRow{P::cleaning, A::begin_cleaning, "Begin", ""},
    ActionRow{P::counters, A::zero_counters, "Begin again from zero", ""},
    ActionRow{P::log, A::export_log, "Copy the log", ""},
    ActionRow{P::log, A::save_recording, "Save what was felt in the last minute",
              "The file tells where the hand was. Ask the visitor first."},
    ActionRow{P::backup, A::back_up, "Copy the settings", ""},
    ActionRow{P::backup, A::restore, "Bring the settings back from the copy",
              "They are checked first; wrong ones change nothing."},
    ActionRow{P::backup, A::first_settings, "Factory settings",
              "All settings become what they were when the kiosk was new."},
    ActionRow{P::upkeep, A::new_pin, "Change the PIN", ""},
    ActionRow{P::close, A::close, "Shut down", ""},
    ActionRow{P::home, A::leave, "Leave", "The kiosk is open to visitors again."},
};

}  // namespace

const PlaceRow& row_of(OperatorPlace place) {
    const auto* const found = std::find_if(
        places.begin(), places.end(), [place](const PlaceRow& row) { return row.place == place; });
    return *found;
}

std::span<const PlaceRow> place_rows() {
    return places;
}

std::span<const ActionRow> action_rows() {
    return actions;
}

std::string_view words_of(Question question) {
    switch (question) {
        case Question::ceiling:
            return "Lines may then push harder than before.";
        case Question::restore:
            return "The settings of the copy replace those of the kiosk.";
        case Question::close:
            return "The program ends, and the screen is empty.";
        case Question::zero_counters:
            return "All counts begin again from zero.";
        case Question::first_settings:
            return "All that was set is lost.";
        case Question::file_systems:
            return "A hostile USB stick may then take the machine over. Allow it for a while only.";
        case Question::kind:
            return "The handle is measured anew. What was measured before is lost.";
    }
    return {};
}

}  // namespace touchline
