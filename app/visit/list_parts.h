// Parts a long list, so that each of its rows is reached through short lists.
// Threads: values and pure functions.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace touchline {

/// Rows first ... end - 1 of a list.
struct ListPart {
    std::size_t first = 0;
    std::size_t end = 0;

    [[nodiscard]] std::size_t size() const { return end - first; }

    friend bool operator==(const ListPart&, const ListPart&) = default;
};

/// The parts of `part`, in order; none if it is short enough to show its rows. There are as few as
/// a screen shows, and more only where three lists, one in the other, would not reach every row.
/// `begins_key(row)` is true for a row whose key (its first letter, its grade) is not that of the
/// row before: parts end where keys do if that makes none too large. `rows`: of the whole list.
/// O(part.size()).
[[nodiscard]] std::vector<ListPart> parts_of(const ListPart& part, std::size_t rows,
                                             const std::function<bool(std::size_t)>& begins_key);

}  // namespace touchline
