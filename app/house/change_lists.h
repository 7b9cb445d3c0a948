// The two lists that make a change whole: the moves of one that is under way, and the record of the
// last. Both are texts of words with blanks between.
// Threads: values and pure functions.
#pragma once

#include "app/house/places.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// What a change replaced: there was something before, or nothing.
struct ChangedThing {
    HouseRoot root = HouseRoot::settings;
    std::string name;
    bool was_there = false;

    friend bool operator==(const ChangedThing&, const ChangedThing&) = default;
};

/// The change that this kiosk is at. It is a file, changed with all else.
struct ChangeRecord {
    std::uint64_t number = 0;  // of the change, from 1
    std::int64_t made_s = 0;   // of the bundle
    std::vector<ChangedThing> things;

    friend bool operator==(const ChangeRecord&, const ChangeRecord&) = default;
};

/// One of the things that change together. All names are of the root's folder.
struct Move {
    HouseRoot root = HouseRoot::settings;
    std::string name;
    std::string incoming;  // empty: there will be nothing
    std::string outgoing;  // where what was there goes to
};

/// All that lies beside its place for a change begins so.
inline constexpr std::string_view beside_mark = ".house-";

[[nodiscard]] std::string incoming_name(std::uint64_t number, std::string_view name);

[[nodiscard]] std::string outgoing_name(std::uint64_t number, std::string_view name);

/// A name of a file or folder that the lists can hold: of one part, without blanks and line ends.
[[nodiscard]] bool is_listed_name(std::string_view name);

[[nodiscard]] std::string journal_text(const std::vector<Move>& moves);

/// Nothing if the text is no such list.
[[nodiscard]] std::optional<std::vector<Move>> moves_in(std::string_view text);

[[nodiscard]] std::string record_text(const ChangeRecord& record);

/// Nothing if the text is no such record.
[[nodiscard]] std::optional<ChangeRecord> record_in(std::string_view text);

}  // namespace touchline
