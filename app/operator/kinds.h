// The kinds of handle that an operator can choose from, told by what a hand finds on them.
// Threads: constant data.
#pragma once

#include <span>
#include <string_view>

namespace touchline {

/// Texts of the catalogue, context "kind".
struct KindRow {
    std::string_view profile;  // of haptics/pantograph/profile.h
    std::string_view name;
    std::string_view hint;  // how to tell it from the others
};

/// One for each profile; the likeliest first.
[[nodiscard]] std::span<const KindRow> kind_rows();

}  // namespace touchline
