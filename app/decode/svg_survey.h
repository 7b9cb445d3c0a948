// Tells the authors of map SVGs which languages a map speaks, and where it is silent.
// Threads: pure functions.
#pragma once

#include "config/types/result.h"

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

}  // namespace touchline
