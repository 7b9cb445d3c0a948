// The kinds of handle that an operator can choose from, described by what a hand finds on them.
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

/// One row per profile, the likeliest first.
[[nodiscard]] std::span<const KindRow> kind_rows();

}  // namespace touchline
