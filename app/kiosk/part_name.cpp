#include "app/kiosk/part_name.h"

#include "config/types/face_part.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace touchline {
namespace {

constexpr std::array<std::string_view, 9> kKinds{"closed line",
                                                 "line",
                                                 "dashed line",
                                                 "dotted line",
                                                 "rough area",
                                                 "line of text",
                                                 "figure",
                                                 "outline of the main thing",
                                                 "part of the main thing’s outline"};
constexpr std::array<std::string_view, 9> kPlaces{"upper left", "top",    "upper right",
                                                  "left",       "middle", "right",
                                                  "lower left", "bottom", "lower right"};

template <std::size_t n>
bool is_among(const std::array<std::string_view, n>& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

}  // namespace

std::string part_name(const std::string& label, const Language& language) {
    constexpr std::string_view kDigits = "0123456789";
    if (is_among(face_part_ids, label)) return language.text("part", label);
    const std::size_t comma = label.rfind(", ");
    if (comma == std::string::npos) return label;
    const std::string place = label.substr(comma + 2);
    std::string kind = label.substr(0, comma);
    const std::size_t last = kind.find_last_not_of(kDigits);
    std::string number;
    if (last != std::string::npos && last + 1 < kind.size() && kind[last] == ' ') {
        number = kind.substr(last + 1);
        kind.resize(last);
    }
    if (!is_among(kKinds, kind) || !is_among(kPlaces, place)) return label;
    const std::string said = language.text("part", kind);
    const std::string where = language.text("place", place);
    return number.empty() ? language.text("part", "{0}, {1}", {said, where})
                          : language.text("part", "{0} {1}, {2}", {said, number, where});
}

}  // namespace touchline
