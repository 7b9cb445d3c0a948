// Where in a document: which page, and what of it.
// Threads: a value.
#pragma once

namespace touchline {

/// Views of a page are its pictures in reading order, then the page as a whole.
struct PagePlace {
    int page = 1;        // 1 ... page_count
    int page_count = 0;  // 0: not known yet
    int view = 1;        // 1 ... view_count; beyond it the last is meant
    int view_count = 0;  // 0: not known yet

    friend bool operator==(const PagePlace&, const PagePlace&) = default;
};

/// A view beyond every count.
inline constexpr int last_view = 1'000'000;

}  // namespace touchline
