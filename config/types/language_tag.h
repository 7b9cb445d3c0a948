// The language in which a text is wanted, tagged as BCP 47 and SVG's xml:lang do: "en", "de",
// "pt-BR". Threads: a plain value.
#pragma once

#include <string>

namespace touchline {

/// Any text is a tag: a language that nobody wrote in gets what is there. Empty is English. It
/// comes from who chose a language, never from the process's locale.
struct LanguageTag {
    std::string text = "en";

    friend bool operator==(const LanguageTag&, const LanguageTag&) = default;
};

}  // namespace touchline
