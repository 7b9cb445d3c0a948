// Private to app/decode: the texts that an SVG shows, and their places.
// Threads: pure functions; one handle, one thread.
#pragma once

#include "app/decode/text_line.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <librsvg/rsvg.h>

namespace touchline::decode {

/// A <text> that can be found by its id.
struct SvgText {
    std::string words;
    std::string id;
};

struct SvgWithTexts {
    std::string svg;  // every <text> has an id
    std::vector<SvgText> texts;
};

/// Gives at most max_word_boxes texts ids. A document that cannot be parsed comes back unchanged.
/// O(text).
[[nodiscard]] SvgWithTexts with_ids(std::string_view svg);

/// The box of the painted text in a picture that fills `viewport`; nothing if none of it is
/// painted.
[[nodiscard]] std::optional<TextBox> box_of(RsvgHandle* handle, const SvgText& text,
                                            const RsvgRectangle& viewport);

}  // namespace touchline::decode
