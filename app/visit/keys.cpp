#include "app/visit/keys.h"

#include <algorithm>
#include <array>

namespace touchline {

namespace {

constexpr auto table = std::to_array<KeyRow>({
    {Key{'A'}, Action::repeat_speech, "A", "say it again; twice: the whole screen"},
    {Key{'Z'}, Action::pause_speech, "Z", "pause, or speak on"},
    {Key{','}, Action::slower_speech, "Comma", "speak slower"},
    {Key{'.'}, Action::faster_speech, "Full stop", "speak faster"},
    {Key{'E'}, Action::emergency_stop, "E", "emergency stop: no force until C"},
    {Key{'C'}, Action::clear_fault, "C", "for the operator: clear what stopped the force"},
    {Key{'R'}, Action::hold_recording, "R",
     "for the operator: hold the last minute in memory; with the PIN given, save it"},
    {Key{'O'}, Action::home_again, "O", "for the operator: find the handle’s starting point again"},
    {Key{'V'}, Action::toggle_live_view, "V", "live view on or off"},
    {Key{'B'}, Action::toggle_boxes, "B", "error boxes of the curve in it, on or off"},
    {Key::remove, Action::erase_line, "Delete",
     "for whoever draws: the next press of the pen erases a line"},
    {Key{'U'}, Action::undo_line, "U", "for whoever draws: undo the last change"},
    {Key{'Y'}, Action::redo_line, "Y", "for whoever draws: do again what was undone"},
    {Key::f15, Action::headphones_in, "F15", "keypad: the headphones are in"},
    {Key::f16, Action::headphones_out, "F16", "keypad: the headphones are out"},
    {Key{'Q'}, Action::quit, "Q", "for the operator: ask, and then quit"},
});

}  // namespace

std::span<const KeyRow> key_table() {
    return table;
}

std::optional<Action> action_of(Key key) {
    const auto* const found = std::ranges::find(table, key, &KeyRow::key);
    if (found == table.end()) return std::nullopt;
    return found->action;
}

}  // namespace touchline
