#include "app/operator/operator_menu.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

using P = OperatorPlace;

constexpr std::string_view how_to_enter =
    "Press Up once for 1, twice for 2 and so on; Down for 0. Press Select to accept each digit. "
    "After the last one, press Select once more. Press Back to begin again.";

// The words of the PIN's screens name the lengths.
static_assert(shortest_pin == 4 && longest_pin == 8);

constexpr auto places = std::to_array<PlaceRow>({
    {P::pin, P::closed, "PIN of the operator", how_to_enter, "", false},
    {P::new_pin, P::closed, "Choose a PIN of 4 to 8 digits", how_to_enter, "", false},
    {P::new_pin_again, P::new_pin, "Enter the same PIN once more", how_to_enter, "", false},
    {P::home, P::closed, "Operator", "", "", false},
    {P::status, P::home, "State of the kiosk", "Press Back for the menu.", ""},
    {P::touch, P::home, "How it feels", "", ""},
    {P::feel, P::touch, "Lines and force", "", "feel"},
    {P::levels, P::touch, "Levels", "A level is how finely lines are followed.", "levels"},
    {P::picture, P::touch, "Detail of pictures", "", "picture"},
    {P::profiles, P::touch, "Profiles",
     "What a profile sets takes priority over the kiosk’s own settings.", ""},
    {P::ears, P::home, "Sound, speech and languages", "", ""},
    {P::sounds, P::ears, "Sounds and speech", "", "sound"},
    {P::volume, P::ears, "Volume", "Loudness at the ear, in decibels.", ""},
    {P::languages, P::ears, "Languages", "", "language"},
    {P::visits, P::home, "Visits", "", ""},
    {P::times, P::visits, "Waiting times", "", "time"},
    {P::hours, P::visits, "Hours", "", "hours"},
    {P::care, P::visits, "Notices and staff", "", "care"},
    {P::senses, P::home, "Camera, keys and screen", "", ""},
    {P::camera, P::senses, "Camera", "", "camera"},
    {P::keys, P::senses, "Keys", "", "keys"},
    {P::key_wizard, P::keys, "Assign the keys", "", "", false},
    {P::screen, P::senses, "Screen", "", "screen"},
    {P::sticks, P::senses, "USB sticks", "USB sticks with FAT and exFAT are always read.", "stick"},
    {P::printing, P::senses, "Printer", "", "print"},
    {P::device, P::home, "Handle and tests", "", "device"},
    {P::homing, P::device, "Find the handle’s starting point",
     "The kiosk says where to move the handle. Force is off meanwhile.", ""},
    {P::kind, P::device, "Kind of handle",
     "Press Repeat to hear how to know each one. Press Select to choose it; the handle is "
     "then measured.",
     ""},
    {P::self_test, P::device, "Self-test", "", ""},
    {P::test_step, P::self_test, "Step of the self-test", "", "", false},
    {P::live, P::device, "What the handle is doing now", "", ""},
    {P::cleaning, P::device, "Clean the handle",
     "Force and keys are off for a while. You can wipe the handle and the keys.", ""},
    {P::cleaning_lock, P::cleaning, "The handle can be cleaned",
     "Force and keys are off. They come back by themselves.", "", false},
    {P::upkeep, P::home, "Upkeep", "", ""},
    {P::library, P::upkeep, "Copy from a USB stick", "Choose what to copy into this kiosk.", ""},
    {P::several, P::upkeep, "Several kiosks",
     "A bundle brings settings, profiles and packs to all kiosks. The house key is a file that "
     "shows whose bundle it is.",
     ""},
    {P::bundle, P::several, "What the bundle changes", "", "", false},
    {P::way_back, P::several, "Back to before the bundle", "What was set since then is lost.", "",
     false},
    {P::house_key, P::several, "House key on the USB stick",
     "Compare these digits with those on the other kiosk.", "", false},
    {P::own_key, P::several, "House key of this kiosk", "Compare these digits on each other kiosk.",
     "", false},
    {P::key_pin, P::house_key, "Confirm with the PIN", how_to_enter, "", false},
    {P::counters, P::upkeep, "Visit counts", "Nothing is recorded about who visited.", ""},
    {P::days, P::counters, "Day by day", "", ""},
    {P::log, P::upkeep, "Log and recording",
     "The log is copied beside the settings. Nothing about visitors is in it.", ""},
    {P::backup, P::upkeep, "Backup of the settings",
     "Copies all settings except the PIN, or brings the copy back.", ""},
    {P::paths, P::upkeep, "Set in the file only",
     "These are written in the kiosk’s file of settings.", "operator"},
    {P::close, P::upkeep, "Shut the kiosk down", "The program ends.", ""},
    {P::question, P::home, "Are you sure?", "", "", false},
});

static_assert(places.size() + 1 == operator_place_count);

constexpr auto kinds = std::to_array<KindRow>({
    {"2diy-gen3.1", "2diy 3.1, elbows 15 millimetres in front of the motors",
     "Two motors beside each other, arms of plastic. Measure with the handle pushed away."},
    {"2diy-gen3.1-172", "2diy 3.1, elbows 10 millimetres in front of the motors",
     "Two motors beside each other, arms of plastic. Measure with the handle pushed away."},
    {"2diy-gen3.1-180", "2diy 3.1, elbows in line with the motors",
     "Two motors beside each other, arms of plastic. Measure with the handle pushed away."},
    {"2diy-gen3", "2diy 3, the kind before 3.1", "Its programs start with the handle pulled near."},
    {"2diy-gen2", "2diy 2, motors on one axis",
     "Arms of metal. Its programs start at 241 degrees."},
    {"2diy-gen2-240", "2diy 2, stopped at 240 degrees",
     "Arms of metal. Its programs start at 240 degrees and use 10978 counts."},
    {"haplet", "Haplet", "Short arms of 50 and 70 millimetres on a plate."},
    {"mk2", "Pantograph Mk II", "Built by a laboratory, with its own board."},
    {"gen3.1-turning", "2diy with a handle that turns",
     "It has a third motor at the handle. It is not sold; you build it yourself."},
});

}  // namespace

const PlaceRow& row_of(OperatorPlace place) {
    return *std::ranges::find(places, place, &PlaceRow::place);
}

std::span<const PlaceRow> place_rows() {
    return places;
}

std::span<const KindRow> kind_rows() {
    return kinds;
}

}  // namespace touchline
