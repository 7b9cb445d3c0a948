// One model of every screen, for visitor and operator alike: what is drawn is what is spoken and
// what the six keys walk through. Threads: values and pure functions.
#pragma once

#include "audio-cues/words/language.h"
#include "config/types/key_role.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// What can be done with an item: text is only read; choice is chosen; setting has a value that
/// Up and Down change while it is held by Select; toggle is on or off.
enum class ItemRole : std::uint8_t { text, choice, setting, toggle };

/// A row of a screen. Texts are in the language of the screen and never hold markup.
struct ScreenItem {
    int id = 0;  // what it stands for, to whoever made the screen
    ItemRole role = ItemRole::choice;
    std::string name;   // never empty
    std::string value;  // of a setting or toggle, in words; else empty
    std::string hint;   // one sentence, said after a pause; may be empty

    friend bool operator==(const ScreenItem&, const ScreenItem&) = default;
};

/// Beside the items: nothing, the picture that is felt, or what the camera sees.
enum class ScreenView : std::uint8_t { none, picture, camera };

struct SpokenScreen {
    std::string title;  // never empty; said first
    std::string text;   // sentences after it; may be empty
    std::vector<ScreenItem> items;
    std::optional<std::size_t> focus;  // of items; nothing: none has it
    ScreenView view = ScreenView::none;

    friend bool operator==(const SpokenScreen&, const SpokenScreen&) = default;
};

/// "Cat, 2 of 5", "Firmness, medium, setting, 1 of 4": name, value, role of what changes, place.
/// `item` of screen.items.
[[nodiscard]] std::string spoken_item(const SpokenScreen& screen, std::size_t item,
                                      const Language& language);

/// All of it, for who asks twice: title, text, the item that has the focus.
[[nodiscard]] std::string spoken_screen(const SpokenScreen& screen, const Language& language);

/// The sentence after what is there, with a full stop between where there was no stop. Nothing for
/// an empty one.
void add_sentence(std::string& text, const std::string& sentence);

struct FocusMove {
    std::size_t focus = 0;
    bool has_wrapped = false;  // past an end: worth a sound
};

/// Up or down the list, around its ends. Nothing where there are no items.
[[nodiscard]] std::optional<FocusMove> move_focus(const SpokenScreen& screen, bool is_down);

}  // namespace touchline
