// Turns the lines of a picture into outlines that a hand can follow, at one of five details, and
// finds words for them.
//
// in the zoom -> breaks closed -> ranked, a frame last -> each, the most salient first: smoothed
// at the detail's scale, loops cut off, kept a gap away from what is there -> until the detail's
// strokes or length are used up -> TactileMap
//
// Threads: pure functions.
#pragma once

#include "config/types/tactile_map.h"
#include "vision/contour/chain.h"
#include "vision/simplify/detail_limits.h"
#include "vision/simplify/zoom.h"

#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// The lines of a picture as they were found, before any choice for the hand. Once kept, they serve
/// every detail and zoom.
struct PictureLines {
    std::vector<Chain> chains;  // working pixels; arms of a junction share their point
    cv::Size working;           // size of the working picture, pixels
    cv::Size picture;           // size of the picture as given, pixels
    double high = 1.0;          // strength at which a line is strong enough
};

enum class Complexity { simple, medium, complex };

[[nodiscard]] std::string_view word_of(Complexity complexity);

struct SimplifyReport {
    int parts = 0;         // outlines in the map
    double line_mm = 0.0;  // of all of them
    Complexity complexity = Complexity::simple;
    int lines = 0;     // found, without frames
    int left_out = 0;  // of these, the lines that the detail has no room for, or that are too short
                       // or too near
    bool is_full = false;  // the detail has no room left
    int breaks_closed = 0;
    int crossings_opened = 0;
    int frames_dropped = 0;  // at details 1 and 2: a frame around everything that no line meets
    std::string words;       // for speech: sentences of at most 15 words
};

struct Simplified {
    TactileMap map;  // no outlines: no line was found
    SimplifyReport report;
};

/// Keeps to limits_for(detail, area): number and length of the strokes, and the gap. Two outlines,
/// or two places of one more than four gaps apart along it, are a gap apart, except within a gap of
/// a place where one ends on the other, where a crossing was opened, or of a corner. Outlines do
/// not cross themselves or each other. The most salient outer line is always kept; if it alone is
/// longer than the detail allows, it is smoothed until it is not. If every line is shorter than the
/// detail's shortest stroke, the longest are kept. Points are canonical (config/types/map_frame.h),
/// the most salient outline comes first, ids are "outline-1" ..., labels say the place;
/// `Outline::detail` is the lowest detail whose number and length of strokes hold the outline and
/// all before it. Deterministic. Threads: pure function. Takes some milliseconds; for a ring that
/// comes near to itself everywhere, some tens.
[[nodiscard]] Simplified simplified(const PictureLines& lines, const Area& area, int detail,
                                    const Zoom& zoom = {});

/// Returns where the middle of an outline's extent lies, in thirds of the area: "upper left",
/// "top", "upper right", "left", "middle", "right", "lower left", "bottom", "lower right".
/// O(points).
[[nodiscard]] std::string_view place_of(const Outline& outline, const Area& area);

/// Labels all outlines by kind and place: "closed line, upper left"; the second of a kind and place
/// is "closed line 2, upper left". `of`: what each one shows.
void label_by_place(TactileMap& map, const std::vector<LineOf>& of);

/// Returns how hard the map is to take in, by the strokes and the length of line that a detail
/// allows.
[[nodiscard]] Complexity complexity_of(int parts, double line_mm, const Area& area);

/// Returns sentences of at most 15 words: how many parts, how long, how hard, where the largest is,
/// and what helps if lines were left out.
[[nodiscard]] std::string words_for(const TactileMap& map, const SimplifyReport& report,
                                    int detail);

}  // namespace touchline
