// Reads audio-cues/words/glossary.md and checks whether a text keeps to it.
// Threads: pure functions.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

struct BarredWord {
    std::string word;
    std::vector<std::string> unless;  // beginnings of English words, or phrases with the word, that
                                      // allow it
};

struct GlossaryRow {
    std::string english;                                    // the English term
    bool is_always = false;                                 // in bold: must always be translated so
    std::map<std::string, std::string> said;                // the translated term, by language code
    std::map<std::string, std::vector<BarredWord>> barred;  // by language code
};

/// Returns the rows of the table, whose header names each language's code in parentheses. Ignores
/// lines that are not rows.
[[nodiscard]] std::vector<GlossaryRow> glossary_of(std::string_view markdown);

/// Returns a line for every barred word of the language in the text, which says what to use
/// instead; none for a language without a column. `english`: the original of the text.
[[nodiscard]] std::vector<std::string> barred_in(const std::vector<GlossaryRow>& glossary,
                                                 const std::string& code, const std::string& text,
                                                 const std::string& english);

/// Returns a line, like barred_in(), for every bold term of the English text that the translation
/// renders otherwise.
[[nodiscard]] std::vector<std::string> missing_in(const std::vector<GlossaryRow>& glossary,
                                                  const std::string& code, const std::string& text,
                                                  const std::string& english);

}  // namespace touchline
