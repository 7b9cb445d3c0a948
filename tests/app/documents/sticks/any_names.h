// Names such as people and attackers make, and their characters. Threads: pure functions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rapidcheck.h>
#include <unicode/uchar.h>
#include <unicode/utf8.h>

namespace touchline {

/// Generates a name from what people and attackers put into names.
inline rc::Gen<std::string> any_name() {
    const auto piece = rc::gen::oneOf(
        rc::gen::map(rc::gen::arbitrary<char>(), [](char c) { return std::string(1, c); }),
        rc::gen::elementOf(std::vector<std::string>{"a",          "Z",
                                                    "7",          " ",
                                                    ".",          "'",
                                                    "\\",         "<",
                                                    "[[",         "%s",
                                                    "\n",         "\x1b[2J",
                                                    "\u00e4",     "e\u0301",
                                                    "\u0301",     "\u200b",
                                                    "\u202e",     "\u2066",
                                                    "\ufeff",     "\u2028",
                                                    "\u3164",     "\u732b",
                                                    "\U0001f41f", "\U000e0041",
                                                    "\xc0\xaf",   "\xed\xa0\x80",
                                                    "\xff",       "\u0085"}));
    return rc::gen::map(rc::gen::container<std::vector<std::string>>(piece), [](const auto& all) {
        std::string name;
        for (const std::string& one : all) name += one;
        return name;
    });
}

inline std::u32string characters_of(const std::string& text) {
    std::u32string all;
    for (std::size_t i = 0; i < text.size();) {
        UChar32 c = 0;
        U8_NEXT_UNSAFE(text.data(), i, c);
        all.push_back(static_cast<char32_t>(c));
    }
    return all;
}

inline bool has_mask(char32_t c, std::uint32_t mask) {
    return (U_MASK(u_charType(static_cast<UChar32>(c))) & mask) != 0;
}

}  // namespace touchline
