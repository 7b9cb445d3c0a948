// Where in a document: which page, and what of it.
// Threads: a value.
#pragma once

#include <cstdint>

namespace touchline {

/// What is known of a photograph's main things; none: of what is no photograph. impossible: they
/// could not be looked for now. absent: what finds them is not installed or has no room, and no
/// person is one. found: they are the views before the whole.
enum class ThingSearch : std::uint8_t { none, under_way, unclear, impossible, absent, found };

/// Views of a page are its pictures in reading order, or the main things of a photograph, the
/// largest first, and then those that a visitor has found; then the page as a whole.
struct PagePlace {
    int page = 1;        // 1 ... page_count
    int page_count = 0;  // 0: not known yet
    int view = 1;        // 1 ... view_count; beyond it the last is meant
    int view_count = 0;  // 0: not known yet
    ThingSearch things = ThingSearch::none;
    bool is_face = false;  // the view is a face that was drawn in lines

    friend bool operator==(const PagePlace&, const PagePlace&) = default;
};

/// A view beyond every count.
inline constexpr int last_view = 1'000'000;

}  // namespace touchline
