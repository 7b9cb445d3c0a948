// Private to app/decode: the texts that an SVG shows, and where.
// Threads: pure functions; one handle, one thread.
#pragma once

#include "app/decode/text_line.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <librsvg/rsvg.h>

namespace touchline::decode {

/// A <text> that can be asked for by its id.
struct SvgText {
    std::string words;
    std::string id;
};

struct SvgWithTexts {
    std::string svg;  // every <text> has an id
    std::vector<SvgText> texts;
};

/// At most max_word_boxes texts. A document that cannot be parsed comes back as it is. O(text).
[[nodiscard]] SvgWithTexts with_ids(std::string_view svg);

/// Where the text is painted in a picture that fills `viewport`; nothing where none of it is.
[[nodiscard]] std::optional<TextBox> box_of(RsvgHandle* handle, const SvgText& text,
                                            const RsvgRectangle& viewport);

}  // namespace touchline::decode
