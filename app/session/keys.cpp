#include "app/session/keys.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace touchline {

namespace {

constexpr KeyRow row(Key key, Action action, std::string_view name, std::string_view words) {
    return {key, key, action, name, words};
}

constexpr std::array table{
    row(Key::right, Action::next_picture, "Right", "next picture"),
    row(Key::left, Action::previous_picture, "Left", "previous picture"),
    row(Key{'K'}, Action::next_view, "K", "next picture of the page, then the page as a whole"),
    row(Key{'J'}, Action::previous_view, "J", "the picture of the page before"),
    row(Key{'I'}, Action::next_page, "I", "next page"),
    row(Key{'U'}, Action::previous_page, "U", "the page before"),
    KeyRow{Key{'1'}, Key{'5'}, Action::set_detail, "1 to 5",
           "detail: 1 silhouette, 2 main parts, 5 everything"},
    row(Key{'L'}, Action::toggle_level_automatic, "L", "level by hand speed, or fixed"),
    row(Key::page_up, Action::coarser_level, "Page Up", "fixed level, one coarser"),
    row(Key::page_down, Action::finer_level, "Page Down", "fixed level, one finer"),
    row(Key::up, Action::firmer, "Up", "firmer outlines"),
    row(Key::down, Action::softer, "Down", "softer outlines"),
    row(Key{'M'}, Action::next_mode, "M",
        "how an outline feels: wall, groove, ridge, stay on line"),
    row(Key{'P'}, Action::toggle_pop_through, "P",
        "a wall gives way to a long firm push, or holds"),
    row(Key{' '}, Action::toggle_force, "Space", "force off, or on again"),
    row(Key{'E'}, Action::emergency_stop, "E", "emergency stop: no force until C"),
    row(Key{'C'}, Action::clear_fault, "C", "operator: clear what stopped the force"),
    row(Key{'R'}, Action::keep_recording, "R", "operator: keep a recording of the last minute"),
    row(Key{'O'}, Action::home_again, "O", "find the handle's home again"),
    row(Key{'B'}, Action::toggle_boxes, "B", "error boxes of the curve on or off"),
    row(Key{'H'}, Action::toggle_keys, "H", "this list of keys on or off"),
    row(Key{'S'}, Action::next_sounds, "S", "sounds: none, short ones, all"),
    row(Key{'V'}, Action::toggle_speech, "V", "speech off, or on again"),
    row(Key{'A'}, Action::repeat_speech, "A", "say it again"),
    row(Key{'X'}, Action::stop_speech, "X", "stop speaking; every key does"),
    row(Key{'Z'}, Action::pause_speech, "Z", "pause, or speak on"),
    row(Key{','}, Action::slower_speech, "Comma", "speak slower"),
    row(Key{'.'}, Action::faster_speech, "Full stop", "speak faster"),
    row(Key{'-'}, Action::softer_sound, "Minus", "softer"),
    row(Key{'='}, Action::louder_sound, "Equals", "louder"),
    row(Key{'N'}, Action::next_language, "N", "next language"),
    row(Key::f15, Action::headphones_in, "F15", "keypad: the headphones are in"),
    row(Key::f16, Action::headphones_out, "F16", "keypad: the headphones are out"),
    row(Key{'Q'}, Action::quit, "Q", "quit"),
    row(Key::escape, Action::quit, "Escape", "quit"),
};

}  // namespace

std::span<const KeyRow> key_table() {
    return table;
}

std::optional<KeyAction> action_of(Key key) {
    const auto found = std::find_if(table.begin(), table.end(), [key](const KeyRow& row) {
        return row.first <= key && key <= row.last;
    });
    if (found == table.end()) return std::nullopt;
    const auto offset = static_cast<std::uint32_t>(key) - static_cast<std::uint32_t>(found->first);
    return KeyAction{found->action, static_cast<int>(offset)};
}

std::string keys_as_markdown() {
    std::string text = "| key | what it does |\n|---|---|\n";
    for (const KeyRow& row : table) text += fmt::format("| {} | {} |\n", row.name, row.words);
    return text;
}

}  // namespace touchline
