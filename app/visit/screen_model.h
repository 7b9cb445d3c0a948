// One model of every screen, for visitor and operator alike: what is drawn is also what is spoken
// and what the six keys walk through. Threads: values and pure functions.
#pragma once

#include "audio-cues/speech/spoken_text.h"
#include "audio-cues/words/language.h"
#include "config/settings/keys.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// What an item is for. text: only read. choice: chosen. setting: has a value that Up and Down
/// change while Select holds it. toggle: on or off.
enum class ItemRole : std::uint8_t { text, choice, setting, toggle };

/// A row of a screen. Its texts are in the screen's language and never hold markup.
struct ScreenItem {
    int id = 0;  // what it stands for, to the screen's maker
    ItemRole role = ItemRole::choice;
    std::string name;   // never empty
    std::string value;  // of a setting or toggle, in words; else empty
    std::string hint;   // one sentence, said after a pause; may be empty
    /// "picture 37 of 205", or empty; nothing: that among the items of the screen.
    std::optional<std::string> place = {};
    VoiceRecordingPtr recording = {};  // of the name; null: nobody recorded it

    friend bool operator==(const ScreenItem&, const ScreenItem&) = default;
};

/// What is shown beside the items: nothing, the picture that is felt, or the camera's view.
enum class ScreenView : std::uint8_t { none, picture, camera };

struct SpokenScreen {
    std::string title;  // never empty; said first
    std::string text;   // sentences after it; may be empty
    std::vector<ScreenItem> items;
    std::optional<std::size_t> focus;  // an index of items; nothing: no item has it
    ScreenView view = ScreenView::none;
    std::vector<std::string> way = {};  // titles of the screens below this one, from the first
    bool takes_any_key = false;         // every key does the same
    bool is_turning = false;            // Up and Down change the value of the item with the focus
    VoiceRecordingPtr title_recording = {};        // null: nobody recorded it
    std::vector<RecordedSpan> text_recorded = {};  // of the text

    friend bool operator==(const SpokenScreen&, const SpokenScreen&) = default;
};

/// "2 of 5"; empty for the only one.
[[nodiscard]] std::string told_place_among(std::size_t number, std::size_t count,
                                           const Language& language);

/// The item's own place, else that among the items; empty for a way out beside items that have
/// places of their own. `item` is an index of screen.items.
[[nodiscard]] std::string told_place(const SpokenScreen& screen, std::size_t item,
                                     const Language& language);

/// "Cat, 2 of 5", "Firmness, medium, setting, 1 of 4": name, value, role if it can change, place.
/// `item` is an index of screen.items.
[[nodiscard]] std::string spoken_item(const SpokenScreen& screen, std::size_t item,
                                      const Language& language);

/// The whole screen, for a person who asks twice: title, text, the item that has the focus.
[[nodiscard]] std::string spoken_screen(const SpokenScreen& screen, const Language& language);

/// The same, and what of it is recorded.
[[nodiscard]] SpokenText told_title(const SpokenScreen& screen);
[[nodiscard]] SpokenText told_text(const SpokenScreen& screen);
[[nodiscard]] SpokenText told_item(const SpokenScreen& screen, std::size_t item,
                                   const Language& language);
[[nodiscard]] SpokenText told_screen(const SpokenScreen& screen, const Language& language);

/// Gives the item the focus, or the last one if there are fewer; none if there are none.
void set_focus(SpokenScreen& screen, std::size_t wanted);

/// Where the item with this id is; nothing: it is not shown.
[[nodiscard]] std::optional<std::size_t> place_of(const std::vector<ScreenItem>& items, int id);

/// What a screen of 720 rows shows at the standard size.
inline constexpr std::size_t items_on_screen = 7;

/// Appends the sentence, with a full stop before it if there was none. Does nothing for an empty
/// sentence.
void add_sentence(std::string& text, const std::string& sentence);
void add_sentence(SpokenText& text, const SpokenText& sentence);

/// The keys that do something now, in the order of KeyRole. None where any key does the same.
[[nodiscard]] std::vector<KeyRole> acting_keys(const SpokenScreen& screen);

struct FocusMove {
    std::size_t focus = 0;
    bool has_wrapped = false;  // past an end: worth a sound
};

/// Moves up or down the list and around its ends. Returns nothing if there are no items.
[[nodiscard]] std::optional<FocusMove> move_focus(const SpokenScreen& screen, bool is_down);

/// Moves as far as a screen shows, at most to the end of the list. Returns nothing at that end.
[[nodiscard]] std::optional<std::size_t> jump_focus(const SpokenScreen& screen, bool is_down);

}  // namespace touchline
