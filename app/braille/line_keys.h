// What the keys of a braille display mean: BrlAPI's commands, which brltty makes of every display's
// own keys. Threads: pure functions.
#pragma once

#include "app/braille/line_pages.h"
#include "config/settings/keys.h"

#include <cstdint>
#include <optional>
#include <variant>

namespace touchline {

/// A turn is the line's own business; a role goes to the kiosk.
using LineKey = std::variant<LineTurn, KeyRole>;

/// Returns the meaning of a key code of BrlAPI (brlapi_keyCode_t); nothing: it has none here.
///
/// Displays have a way to page (left and right a window), to go a line up and down, and a routing
/// key over each cell; nearly all have keys for top, bottom and home as well. So these are the six
/// roles: up and down a line, any routing key for Select, top for Back, home for Repeat, bottom for
/// Help. A braille keyboard's arrows, Enter and Escape, and a display's own keys for back and help
/// do as they say.
[[nodiscard]] std::optional<LineKey> line_key_of(std::uint64_t code);

}  // namespace touchline
