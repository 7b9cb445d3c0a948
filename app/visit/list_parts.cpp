#include "app/visit/list_parts.h"

#include "app/visit/screen_model.h"

#include <algorithm>

namespace touchline {
namespace {

/// The rows of one screen of a list, besides its way out.
std::size_t rows_shown(std::size_t rows) {
    std::size_t shown = items_on_screen - 1;
    while (shown * shown * shown < rows) ++shown;
    return shown;
}

std::vector<ListPart> parts_by_key(const ListPart& part,
                                   const std::function<bool(std::size_t)>& begins_key) {
    std::vector<ListPart> parts;
    for (std::size_t row = part.first; row < part.end; ++row) {
        if (parts.empty() || begins_key(row)) parts.push_back({row, row});
        ++parts.back().end;
    }
    return parts;
}

/// Joins neighbours that have at most `most` rows together.
std::vector<ListPart> joined(const std::vector<ListPart>& parts, std::size_t most) {
    std::vector<ListPart> larger;
    for (const ListPart& part : parts) {
        if (larger.empty() || part.end - larger.back().first > most) larger.push_back(part);
        larger.back().end = part.end;
    }
    return larger;
}

std::vector<ListPart> equal_parts(const ListPart& part, std::size_t most) {
    const std::size_t count = (part.size() + most - 1) / most;
    std::vector<ListPart> parts;
    for (std::size_t i = 0; i < count; ++i)
        parts.push_back(
            {part.first + i * part.size() / count, part.first + (i + 1) * part.size() / count});
    return parts;
}

}  // namespace

std::vector<ListPart> parts_of(const ListPart& part, std::size_t rows,
                               const std::function<bool(std::size_t)>& begins_key) {
    const std::size_t shown = rows_shown(rows);
    if (part.size() <= shown) return {};
    const std::size_t most = part.size() <= shown * shown ? shown : shown * shown;
    const auto fits = [shown, most](const std::vector<ListPart>& parts) {
        return parts.size() <= shown && std::ranges::all_of(parts, [most](const ListPart& each) {
                   return each.size() <= most;
               });
    };
    const std::vector<ListPart> by_key = parts_by_key(part, begins_key);
    if (fits(by_key)) return by_key;
    const std::vector<ListPart> by_keys = joined(by_key, most);
    if (fits(by_keys)) return by_keys;
    return equal_parts(part, most);
}

}  // namespace touchline
