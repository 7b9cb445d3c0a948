// The language in which a text is wanted, tagged as BCP 47 and SVG's xml:lang do: "en", "de",
// "pt-BR". Threads: a plain value.
#pragma once

#include <string>

namespace touchline {

/// Any text is a tag: a language without texts gets what exists. Empty means English. The tag comes
/// from the person who chose a language, never from the process's locale.
struct LanguageTag {
    std::string text = "en";

    friend bool operator==(const LanguageTag&, const LanguageTag&) = default;
};

}  // namespace touchline
