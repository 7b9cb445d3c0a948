#include "audio-cues/words/part_name.h"

#include "config/types/thing_name.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

constexpr std::array<std::string_view, 9> part_kinds{"closed line",
                                                     "line",
                                                     "dashed line",
                                                     "dotted line",
                                                     "rough area",
                                                     "line of text",
                                                     "figure",
                                                     "outline of the main subject",
                                                     "part of the main subject’s outline"};
constexpr std::array<std::string_view, 9> part_places{"upper left", "top",    "upper right",
                                                      "left",       "middle", "right",
                                                      "lower left", "bottom", "lower right"};

template <std::size_t n>
bool is_among(const std::array<std::string_view, n>& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

}  // namespace

std::optional<TracedName> traced_name(std::string_view label) {
    constexpr std::string_view digits = "0123456789";
    const std::size_t comma = label.rfind(", ");
    if (comma == std::string_view::npos) return std::nullopt;
    TracedName name{std::string(label.substr(0, comma)), {}, std::string(label.substr(comma + 2))};
    const std::size_t last = name.kind.find_last_not_of(digits);
    if (last != std::string_view::npos && last + 1 < name.kind.size() && name.kind[last] == ' ') {
        name.number = name.kind.substr(last + 1);
        name.kind.resize(last);
    }
    if (!is_among(part_kinds, name.kind) || !is_among(part_places, name.place)) return std::nullopt;
    return name;
}

std::string part_name(const std::string& label, const Language& language) {
    if (is_among(face_part_ids, label)) return language.text("part", label);
    const auto name = traced_name(label);
    if (!name) return label;
    const std::string said = language.text("part", name->kind);
    const std::string where = language.text("place", name->place);
    return name->number.empty()
               ? language.text("part", "{0}, {1}", {said, where})
               : language.text("part", "{0} {1}, {2}", {said, name->number, where});
}

}  // namespace touchline
