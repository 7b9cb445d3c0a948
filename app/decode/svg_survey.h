// In which languages a map SVG speaks, and where it is silent: for those who make one.
// Threads: pure functions.
#pragma once

#include "config/types/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// The tags of the texts that are there (xml:lang), each once; "" for a text without a tag.
using SaidLanguages = std::vector<std::string>;

struct SurveyedPart {
    std::string id;  // may be empty
    int line = 0;    // of the file, from 1
    SaidLanguages name;
};

struct SvgSurvey {
    SaidLanguages title;
    SaidLanguages description;
    std::vector<SurveyedPart> parts;  // every shape that is drawn, every <text>
};

/// Fails with one line for what is no SVG. O(text).
[[nodiscard]] Result<SvgSurvey> survey_svg(std::string_view text);

/// Is one of them said to whoever wants `language`? A text without a tag is in `untagged`.
[[nodiscard]] bool speaks(const SaidLanguages& said, std::string_view language,
                          std::string_view untagged);

/// The line of the first thing that is no XML, from 1; 0 where all is. O(text).
[[nodiscard]] int xml_error_line(std::string_view text);

}  // namespace touchline
