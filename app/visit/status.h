// The words of the staff's live view. Every fact on it is first one named line of text.
// Threads: values and pure functions.
#pragma once

#include "app/visit/page_place.h"
#include "audio-cues/words/language.h"
#include "config/types/contact_event.h"
#include "config/types/hand_state.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// For example "Level" and "2.5 of 6, by speed".
struct StatusLine {
    std::string name;
    std::string value;

    friend bool operator==(const StatusLine&, const StatusLine&) = default;
};

struct Status {
    std::string title;  // the picture's title
    std::vector<StatusLine> lines;
    std::string message;  // what went wrong or is under way; may be empty

    friend bool operator==(const Status&, const Status&) = default;
};

/// What is felt, beside what the servo reports.
struct LiveFacts {
    std::string title;  // empty: no picture
    PagePlace place = {1, 1, 1, 1};
    int detail = 3;
    int coarsest_level = 0;
    bool has_pop_through = false;
    std::string hand_words;            // of the catalogue, context "panel"; empty: not known
    std::string hand_name;             // the device's name, for {0} in those words; may be empty
    std::optional<ContactEvent> last;  // the last contact event of the hand
    std::string message;
};

/// Describes it in the staff's language and words. A fault comes before the message. Rounds numbers
/// to what can be read at a glance.
[[nodiscard]] Status describe(const LiveFacts& facts, const HandState& hand,
                              const ForceStatus& force, const Language& language);

// English texts of the catalogue, contexts "detail", "mode", "shape", "contact" and "event"; names
// in the order of their enumerations.

inline constexpr std::array detail_names{"silhouette", "main parts", "parts", "fine parts",
                                         "everything"};
inline constexpr std::array mode_names{"wall", "groove", "ridge", "sticky line"};
inline constexpr std::array<const char*, held_shape_count> shape_names{"a point", "a disc", "a bar",
                                                                       "an angle", "a key"};

[[nodiscard]] std::string words_of(Mode mode);
[[nodiscard]] std::string words_of(ContactState state);
[[nodiscard]] std::string words_of(ContactEventKind kind);

/// A few words, like "on" or "waiting until the hand is clear of lines".
[[nodiscard]] std::string_view words_of(ForceState state);

/// Why the force is reduced; empty if nothing worth a word reduces it.
[[nodiscard]] std::string_view words_of(Limit limit);

}  // namespace touchline
