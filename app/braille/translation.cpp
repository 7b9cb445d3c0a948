#include "app/braille/translation.h"

#include "app/braille/characters.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <mutex>
#include <span>

#include <fmt/format.h>
#include <liblouis/liblouis.h>

namespace touchline {
namespace {

/// The patterns of Unicode's braille stand for themselves, which not every table says.
#define TOUCHLINE_PATTERNS ",braille-patterns.cti"

struct LanguageTables {
    std::string_view language;
    const char* uncontracted;
    const char* contracted;  // null: there is none
};

constexpr std::array tables{
    LanguageTables{"en", "en-ueb-g1.ctb" TOUCHLINE_PATTERNS, "en-ueb-g2.ctb" TOUCHLINE_PATTERNS},
    LanguageTables{"de", "de-g0.utb" TOUCHLINE_PATTERNS, "de-g2.ctb" TOUCHLINE_PATTERNS},
    LanguageTables{"fr", "fr-bfu-comp6.utb" TOUCHLINE_PATTERNS, "fr-bfu-g2.ctb" TOUCHLINE_PATTERNS},
    LanguageTables{"es", "es-g1.ctb" TOUCHLINE_PATTERNS, "es-g2.ctb" TOUCHLINE_PATTERNS},
    LanguageTables{"it", "it-it-comp6.utb" TOUCHLINE_PATTERNS, nullptr},
};

#undef TOUCHLINE_PATTERNS

static_assert(sizeof(widechar) == sizeof(char32_t), "liblouis was built for 16 bits a character");

constexpr unsigned int pattern_base = 0x2800;
constexpr int translation_mode = dotsIO | ucBrl | noUndefined;
/// Text goes to liblouis in pieces of at most so many characters, which bounds its memory.
constexpr std::size_t piece_length = 1000;
/// More cells than any text of our tables takes for one character.
constexpr std::size_t most_cells_per_character = 64;
constexpr std::size_t most_remembered = 4096;

const LanguageTables* tables_of(std::string_view language_tag) {
    const std::string_view language = language_tag.substr(0, language_tag.find_first_of("-_"));
    const auto* const found = std::ranges::find(tables, language, &LanguageTables::language);
    return found == tables.end() ? nullptr : found;
}

/// All that liblouis keeps, and what we remember of its tables.
struct Louis {
    std::mutex lock;
    std::map<std::pair<const char*, char32_t>, bool> known;
};

void be_silent(logLevels /*level*/, const char* /*line*/) {}

Louis& louis() {
    static Louis one;
    static const bool is_silent = [] {
        lou_registerLogCallback(be_silent);
        return true;
    }();
    (void)is_silent;
    return one;
}

/// What liblouis is given, and for each of its characters the place in the text.
struct PlainText {
    std::vector<widechar> codes;
    std::vector<int> places;
    std::size_t question_marks = 0;  // for what the table lacks

    void put(char32_t code, int place) {
        codes.push_back(static_cast<widechar>(code));
        places.push_back(place);
    }
};

struct Cells {
    std::vector<widechar> patterns;
    std::vector<int> cell_of_code;
    std::vector<int> code_of_cell;
};

/// Returns nothing if the table cannot be used.
bool translate(const char* table, std::span<const widechar> codes, Cells& cells) {
    cells.cell_of_code.assign(codes.size(), 0);
    for (std::size_t share = 8; share <= most_cells_per_character; share *= 2) {
        const std::size_t room = codes.size() * share + 16;
        cells.patterns.assign(room, 0);
        cells.code_of_cell.assign(room, 0);
        int given = static_cast<int>(codes.size());
        int made = static_cast<int>(room);
        const int is_done = lou_translate(table, codes.data(), &given, cells.patterns.data(), &made,
                                          nullptr, nullptr, cells.cell_of_code.data(),
                                          cells.code_of_cell.data(), nullptr, translation_mode);
        if (is_done == 0) return false;
        if (given != static_cast<int>(codes.size())) continue;
        cells.patterns.resize(static_cast<std::size_t>(std::max(made, 0)));
        cells.code_of_cell.resize(cells.patterns.size());
        return true;
    }
    return false;
}

/// Whether the table writes the character with at least one dot.
bool is_known(Louis& state, const char* table, char32_t code) {
    const std::pair key{table, code};
    if (const auto found = state.known.find(key); found != state.known.end()) return found->second;
    Cells cells;
    const std::array one{static_cast<widechar>(code)};
    const bool is_written =
        translate(table, one, cells) &&
        std::ranges::any_of(cells.patterns, [](widechar cell) { return (cell & 0xffU) != 0; });
    if (state.known.size() >= most_remembered) state.known.clear();
    state.known.emplace(key, is_written);
    return is_written;
}

PlainText plain_text(Louis& state, const char* table, const TextCharacters& text) {
    PlainText plain;
    for (const TextCharacter& character : text.characters) {
        if (character.kind == BrailleKind::nothing) continue;
        if (character.kind == BrailleKind::blank) {
            plain.put(U' ', character.first);
        } else if (is_known(state, table, character.code)) {
            plain.put(character.code, character.first);
        } else {
            const auto found_likes = likes_of(character.code);
            const auto all_known = [&](const std::u32string& like) {
                return std::ranges::all_of(
                    like, [&](char32_t code) { return is_known(state, table, code); });
            };
            const auto found = std::ranges::find_if(found_likes, all_known);
            if (found == found_likes.end()) continue;  // not even a question mark: no table of ours
            if (*found == U"?") ++plain.question_marks;
            for (const char32_t code : *found) plain.put(code, character.first);
        }
    }
    return plain;
}

/// Returns the length of the next piece: up to the last blank that fits, or all that fits.
std::size_t next_piece(std::span<const widechar> codes) {
    if (codes.size() <= piece_length) return codes.size();
    const auto fitting = codes.first(piece_length);
    const auto blank = std::find(fitting.rbegin(), fitting.rend(), widechar{' '});
    const auto kept = static_cast<std::size_t>(fitting.rend() - blank);
    return kept > 0 ? kept : piece_length;
}

}  // namespace

bool has_braille(std::string_view language_tag) {
    return tables_of(language_tag) != nullptr;
}

bool has_contractions(std::string_view language_tag) {
    const LanguageTables* const found = tables_of(language_tag);
    return found != nullptr && found->contracted != nullptr;
}

Result<BrailleText> braille_of(std::string_view text, const std::string& language_tag,
                               BrailleGrade grade) {
    const LanguageTables* const language = tables_of(language_tag);
    if (language == nullptr) {
        return failure(
            fmt::format("No braille table for the language \"{}\": there are tables for "
                        "en, de, fr, es and it.",
                        language_tag));
    }
    const bool is_contracted = grade == BrailleGrade::contracted && language->contracted != nullptr;
    const char* const table = is_contracted ? language->contracted : language->uncontracted;
    const TextCharacters read = characters_of(text);
    Louis& state = louis();
    const std::lock_guard guard(state.lock);
    if (lou_getTable(table) == nullptr) {
        return failure(
            fmt::format("liblouis cannot read its braille table \"{}\": install the "
                        "package liblouis-data.",
                        table));
    }
    const PlainText plain = plain_text(state, table, read);

    constexpr int none = std::numeric_limits<int>::max();
    BrailleText result;
    result.first_cell.assign(static_cast<std::size_t>(read.count), none);
    Cells cells;
    for (std::size_t from = 0; from < plain.codes.size();) {
        const auto rest = std::span(plain.codes).subspan(from);
        const std::size_t length = next_piece(rest);
        if (!translate(table, rest.first(length), cells)) {
            return failure(
                fmt::format("liblouis cannot translate with its braille table \"{}\": "
                            "install the package liblouis-data anew.",
                            table));
        }
        const auto first = static_cast<int>(result.cells.size());
        const auto place_of = [&](int code) {
            const int last = static_cast<int>(length) - 1;
            return plain.places[from + static_cast<std::size_t>(std::clamp(code, 0, last))];
        };
        for (std::size_t i = 0; i < length; ++i) {
            int& cell = result.first_cell[static_cast<std::size_t>(plain.places[from + i])];
            cell = std::min(cell, first + std::max(cells.cell_of_code[i], 0));
        }
        for (std::size_t i = 0; i < cells.patterns.size(); ++i) {
            const widechar pattern = cells.patterns[i];
            const bool is_pattern = pattern >= pattern_base && pattern <= pattern_base + 0xffU;
            result.cells.push_back(static_cast<std::uint8_t>(is_pattern ? pattern & 0xffU : 0));
            const int before = result.character.empty() ? 0 : result.character.back();
            result.character.push_back(std::max(before, place_of(cells.code_of_cell[i])));
        }
        from += length;
    }
    result.question_marks = plain.question_marks;
    // Who has no cell of its own has the next one's, so it goes from the end.
    int next = static_cast<int>(result.cells.size());
    for (auto cell = result.first_cell.rbegin(); cell != result.first_cell.rend(); ++cell) {
        *cell = next = std::min(*cell, next);
    }
    return result;
}

char braille_ascii(std::uint8_t cell) {
    // The dots as bits give the order.
    static constexpr std::string_view characters =
        " A1B'K2L@CIF/MSP\"E3H9O6R^DJG>NTQ,*5<-U8V.%[$+X!&;:4\\0Z7(_?W]#Y)=";
    static_assert(characters.size() == 64);
    return characters[cell & 0x3fU];
}

}  // namespace touchline
