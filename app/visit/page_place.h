// A place in a document: the page, the part of it that is felt, and both in words.
// Threads: a value, and a pure function.
#pragma once

#include "audio-cues/words/language.h"

#include <cstdint>
#include <string>

namespace touchline {

/// The state of the search for a photograph's main things. none: not a photograph. impossible: the
/// search could not run now. absent: the detector is not installed or has no room, and there is no
/// person. found: the things are the views before the whole.
enum class ThingSearch : std::uint8_t { none, under_way, unclear, impossible, absent, found };

/// The views of a page are its pictures in reading order, or the main things of a photograph, the
/// largest first, and then those that a visitor has found. The page as a whole comes last.
struct PagePlace {
    int page = 1;        // 1 ... page_count
    int page_count = 0;  // 0: not known yet
    int view = 1;        // 1 ... view_count; any larger number means the last
    int view_count = 0;  // 0: not known yet
    ThingSearch things = ThingSearch::none;
    bool is_face = false;  // the view is a face drawn in lines

    friend bool operator==(const PagePlace&, const PagePlace&) = default;
};

/// A view beyond every count, which means the last.
inline constexpr int last_view = 1'000'000;

/// "Page 2 of 10"; empty for a single page.
[[nodiscard]] std::string told_page(int page, int page_count, const Language& language);

/// "Page 2 of 10. Picture 1 of 3 on this page"; empty for a document of one page and one picture.
[[nodiscard]] std::string words_of(const PagePlace& place, const Language& language);

}  // namespace touchline
