// The words of the panel: every fact on the screen is one named line of text first.
// Threads: values and pure functions.
#pragma once

#include "app/session/session.h"
#include "config/types/contact_event.h"
#include "config/types/force_status.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// "Level" and "2.5 of 6, by speed".
struct StatusLine {
    std::string name;
    std::string value;

    friend bool operator==(const StatusLine&, const StatusLine&) = default;
};

struct Status {
    std::string title;  // of the picture
    std::vector<StatusLine> lines;
    std::string message;  // what went wrong or is being done; may be empty

    friend bool operator==(const Status&, const Status&) = default;
};

/// `hand_words` say what the hand is; `last` is the last thing that happened to it. A fault of the
/// force is the message. Numbers are rounded to what can be read at a glance.
[[nodiscard]] Status describe(const Session& session, const HandState& hand,
                              const ForceStatus& force, const std::string& hand_words,
                              const std::optional<ContactEvent>& last);

/// "silhouette"; `detail` 1 ... 5.
[[nodiscard]] std::string_view detail_words(int detail);

[[nodiscard]] std::string words_of(Mode mode);
[[nodiscard]] std::string words_of(ContactState state);
[[nodiscard]] std::string words_of(ContactEventKind kind);

}  // namespace touchline
