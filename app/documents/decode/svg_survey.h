// Looks over an SVG before it is drawn: which languages a map speaks and where it is silent, for
// its author, and how often parts are drawn again. Threads: pure functions.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// The tags (xml:lang) of the texts that exist, each once; "" for a text without a tag.
using SaidLanguages = std::vector<std::string>;

struct SurveyedPart {
    std::string id;  // may be empty
    int line = 0;    // in the file, from 1
    SaidLanguages name;
};

struct SvgSurvey {
    SaidLanguages title;
    SaidLanguages description;
    std::vector<SurveyedPart> parts;  // every shape that is drawn, every <text>
};

/// Fails with one line if it is no SVG. O(text).
[[nodiscard]] Result<SvgSurvey> survey_svg(std::string_view text);

/// True if one of them serves `language`. A text without a tag is in `untagged`.
[[nodiscard]] bool speaks(const SaidLanguages& said, std::string_view language,
                          std::string_view untagged);

/// The line of the first XML error, from 1; 0 if there is none. O(text).
[[nodiscard]] int xml_error_line(std::string_view text);

namespace decode {

/// Maps repeat a sign some hundred times; this many take a tenth of a second.
constexpr std::size_t most_drawn_again = 20'000;

/// How many elements are drawn because another refers to them (use, pattern, marker, mask,
/// clip-path, filter), each time with everything they refer to in turn. most_drawn_again + 1 for
/// any more, and for chains of references deeper than in any drawing; 0 if it is no XML. A marker
/// counts once per path, though it is drawn at each corner. O(text).
[[nodiscard]] std::size_t drawn_again(std::string_view svg);

}  // namespace decode
}  // namespace touchline
