#include "tests/audio-cues/words/glossary.h"

#include "config/types/utf8.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace touchline {
namespace {

std::string trimmed(std::string_view text) {
    const auto begin = text.find_first_not_of(' ');
    if (begin == std::string_view::npos) return {};
    return std::string(text.substr(begin, text.find_last_not_of(' ') + 1 - begin));
}

/// Splits at a sign, but not within parentheses, and drops empty parts.
std::vector<std::string> parted(std::string_view text, std::string_view sign) {
    std::vector<std::string> parts;
    int depth = 0;
    std::size_t begin = 0;
    for (std::size_t at = 0; at <= text.size(); ++at) {
        const bool is_end = at == text.size();
        if (!is_end && text[at] == '(') ++depth;
        if (!is_end && text[at] == ')') --depth;
        if (!is_end && (depth > 0 || !text.substr(at).starts_with(sign))) continue;
        parts.push_back(trimmed(text.substr(begin, at - begin)));
        begin = at + sign.size();
    }
    std::erase(parts, "");
    return parts;
}

/// Parses "clé (clé USB or key)".
BarredWord barred_word(const std::string& text) {
    const auto bracket = text.find(" (");
    if (bracket == std::string::npos) return {text, {}};
    const std::string inside = text.substr(bracket + 2, text.size() - bracket - 3);
    return {text.substr(0, bracket), parted(inside, " or ")};
}

/// Parses "de: Knauf; fr: pommeau".
std::map<std::string, std::vector<BarredWord>> barred_words(const std::string& cell) {
    std::map<std::string, std::vector<BarredWord>> barred;
    for (const std::string& part : parted(cell, ";")) {
        const auto colon = part.find(": ");
        if (colon == std::string::npos) continue;
        for (const std::string& word : parted(part.substr(colon + 1), ","))
            barred[part.substr(0, colon)].push_back(barred_word(word));
    }
    return barred;
}

/// Splits "| a | b |" into "a" and "b".
std::vector<std::string> cells_of(std::string_view line) {
    std::vector<std::string> cells;
    if (!line.starts_with("|")) return cells;
    line.remove_prefix(1);
    for (auto end = line.find('|'); end != std::string_view::npos; end = line.find('|')) {
        cells.push_back(trimmed(line.substr(0, end)));
        line.remove_prefix(end + 1);
    }
    return cells;
}

/// Returns "de" for "German (de)".
std::string code_in(const std::string& head) {
    const auto begin = head.find('(');
    return begin == std::string::npos ? "" : head.substr(begin + 1, head.find(')') - begin - 1);
}

/// Replaces typographic signs by keyboard signs, so that they separate words in the same way.
std::string plain(std::string text) {
    constexpr std::array<std::pair<const char*, const char*>, 10> signs{{{"\u2019", "'"},
                                                                         {"\u00a0", " "},
                                                                         {"\u202f", " "},
                                                                         {"\u201c", " "},
                                                                         {"\u201d", " "},
                                                                         {"\u201e", " "},
                                                                         {"\u00ab", " "},
                                                                         {"\u00bb", " "},
                                                                         {"\u2026", " "},
                                                                         {"\u2013", " "}}};
    for (const auto& [from, to] : signs) {
        const std::string sign = from;
        for (auto at = text.find(sign); at != std::string::npos; at = text.find(sign))
            text.replace(at, sign.size(), to);
    }
    return text;
}

bool is_of_word(char c) {
    return static_cast<unsigned char>(c) >= 0x80U || std::isalnum(static_cast<unsigned char>(c)) ||
           c == '-';
}

/// Lowers letters of ASCII and Latin-1.
std::string in_small_letters(std::string text) {
    bool is_latin = false;
    for (char& letter : text) {
        const auto c = static_cast<unsigned char>(letter);
        if (c < 0x80U) letter = static_cast<char>(std::tolower(c));
        if (is_latin && c < 0x9FU && c != 0x97U) letter = static_cast<char>(c + 0x20U);
        is_latin = c == 0xC3U;
    }
    return text;
}

/// Returns "Clé" for "clé", "Écran" for "écran".
std::string with_capital(std::string word) {
    const bool is_accented = word.size() > 1 && word[0] == '\xc3';
    if (is_accented) {
        word[1] = static_cast<char>(static_cast<unsigned char>(word[1]) & ~0x20U);
    } else {
        word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
    }
    return word;
}

/// Returns where `word` begins in the text as whole words; npos if it does not occur.
std::size_t word_at(const std::string& text, const std::string& word) {
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const auto end = at + word.size();
        if (at > 0 && is_of_word(text[at - 1])) continue;
        if (end == text.size() || !is_of_word(text[end])) return at;
    }
    return std::string::npos;
}

bool begins_a_word(const std::string& text, const std::string& beginning) {
    for (auto at = text.find(beginning); at != std::string::npos; at = text.find(beginning, at + 1))
        if (at == 0 || !is_of_word(text[at - 1])) return true;
    return false;
}

bool is_there(const std::string& text, const std::string& word) {
    const bool is_said = word_at(text, word) != std::string::npos;
    return is_said || word_at(text, with_capital(word)) != std::string::npos;
}

std::string without(std::string text, const std::string& phrase) {
    for (const std::string& form : {phrase, with_capital(phrase)}) {
        for (auto at = word_at(text, form); at != std::string::npos; at = word_at(text, form))
            text.replace(at, form.size(), " ");
    }
    return text;
}

bool is_barred(const BarredWord& barred, std::string text, const std::string& english) {
    const std::string word = plain(barred.word);
    for (const std::string& allowed : barred.unless) {
        const std::string phrase = plain(allowed);
        if (is_there(phrase, word)) {
            text = without(text, phrase);
        } else if (begins_a_word(english, in_small_letters(phrase))) {
            return false;
        }
    }
    return is_there(text, word);
}

std::string first_letters(std::string_view word) {
    constexpr int most = 5;
    std::size_t end = 0;
    for (int letters = 0; end < word.size(); ++end) {
        const bool is_following = (static_cast<unsigned char>(word[end]) & 0xC0U) == 0x80U;
        if (!is_following && ++letters > most) break;
    }
    return std::string(word.substr(0, end));
}

/// Returns the first five letters of each word of a cell, without articles and words before ":".
std::vector<std::string> beginnings_of(const std::string& cell) {
    constexpr std::array<std::string_view, 9> articles{"der", "die", "das", "les", "los",
                                                       "las", "une", "una", "gli"};
    std::vector<std::string> beginnings;
    std::string word;
    for (const char c : in_small_letters(plain(cell)) + ' ') {
        if (is_of_word(c)) {
            word += c;
            continue;
        }
        const bool is_word = word.size() > 2 && std::ranges::count(articles, word) == 0;
        if (is_word && c != ':') beginnings.push_back(first_letters(word));
        word.clear();
    }
    return beginnings;
}

bool has_term(const std::string& english, const std::string& term) {
    const std::string text = in_small_letters(plain(english));
    const std::string one = in_small_letters(term);
    return is_there(text, one) || is_there(text, one + 's');
}

}  // namespace

std::vector<GlossaryRow> glossary_of(std::string_view markdown) {
    std::vector<GlossaryRow> rows;
    std::vector<std::string> head;
    while (!markdown.empty()) {
        const auto end = std::min(markdown.find('\n'), markdown.size());
        const auto cells = cells_of(markdown.substr(0, end));
        markdown.remove_prefix(std::min(end + 1, markdown.size()));
        if (cells.size() < 3 || cells[0].starts_with("---")) continue;
        if (head.empty()) {
            head = cells;
            continue;
        }
        GlossaryRow row;
        for (std::size_t i = 0; i < std::min(cells.size(), head.size()); ++i) {
            if (const std::string code = code_in(head[i]); !code.empty()) row.said[code] = cells[i];
        }
        std::string& english = row.said["en"];
        row.is_always = english.starts_with("**");
        std::erase(english, '*');
        row.english = english;
        row.barred = barred_words(cells.back());
        rows.push_back(row);
    }
    return rows;
}

std::vector<std::string> barred_in(const std::vector<GlossaryRow>& glossary,
                                   const std::string& code, const std::string& text,
                                   const std::string& english) {
    std::vector<std::string> found;
    const std::string plain_text = plain(text);
    const std::string plain_english = in_small_letters(plain(english));
    for (const GlossaryRow& row : glossary) {
        const auto words = row.barred.find(code);
        if (words == row.barred.end()) continue;
        for (const BarredWord& word : words->second) {
            if (is_barred(word, plain_text, plain_english))
                found.push_back("not \"" + word.word + "\" but \"" + row.said.at(code) + "\"");
        }
    }
    return found;
}

std::vector<std::string> missing_in(const std::vector<GlossaryRow>& glossary,
                                    const std::string& code, const std::string& text,
                                    const std::string& english) {
    std::vector<std::string> missing;
    const std::string said = in_small_letters(plain(text));
    for (const GlossaryRow& row : glossary) {
        const auto term = row.said.find(code);
        if (!row.is_always || term == row.said.end() || !has_term(english, row.english)) continue;
        const auto is_said = [&said](const std::string& word) { return begins_a_word(said, word); };
        if (!std::ranges::any_of(beginnings_of(term->second), is_said))
            missing.push_back("\"" + row.english + "\" is \"" + term->second + '"');
    }
    return missing;
}

}  // namespace touchline
