// audio-cues/words/glossary.md, and whether a text keeps to it. Threads: pure functions.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

struct BarredWord {
    std::string word;
    std::vector<std::string> unless;  // begins words of the English text, or holds the word
};

struct GlossaryRow {
    std::string english;                      // the term
    bool is_always = false;                   // in bold: translated so wherever it stands
    std::map<std::string, std::string> said;  // the term, by language code
    std::map<std::string, std::vector<BarredWord>> barred;  // by language code
};

/// The rows of the table, whose head names each language's code in parentheses. A line that is no
/// row is passed over.
[[nodiscard]] std::vector<GlossaryRow> glossary_of(std::string_view markdown);

/// Every barred word of the language in the text, as a line that says what to use instead; a
/// language without a column has none. `english`: the text that it translates.
[[nodiscard]] std::vector<std::string> barred_in(const std::vector<GlossaryRow>& glossary,
                                                 const std::string& code, const std::string& text,
                                                 const std::string& english);

/// Every term in bold of the English text that the translation says otherwise, as barred_in().
[[nodiscard]] std::vector<std::string> missing_in(const std::vector<GlossaryRow>& glossary,
                                                  const std::string& code, const std::string& text,
                                                  const std::string& english);

}  // namespace touchline
