// What the workers of this folder are started for, on their command lines: touchline-figure for all
// of a picture or a place in it, touchline-trace for one step of its way to a map.
// Threads: values and pure functions.
#pragma once

#include "app/documents/decode/picture.h"
#include "config/types/result.h"
#include "vision/simplify/trace.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// In shares of the picture's width and height from its upper left corner, 0 ... 1.
struct PlaceInPicture {
    double x = 0.5;
    double y = 0.5;

    friend bool operator==(const PlaceInPicture&, const PlaceInPicture&) = default;
};

[[nodiscard]] std::vector<std::string> words_of(const PlaceInPicture& place);

/// Nothing unless the words are two numbers from 0 to 1.
[[nodiscard]] std::optional<PlaceInPicture> place_of(const std::vector<std::string>& words);

/// The share that is cut off each side of a picture, in percent, 0 to 40; other numbers cut off
/// nothing.
struct PhotoCut {
    double left = 0.0;
    double right = 0.0;
    double top = 0.0;
    double bottom = 0.0;
};

/// The picture without the sides; at least one pixel stays. A view, no copy.
[[nodiscard]] cv::Mat cut_off(const cv::Mat& picture, const PhotoCut& cut);

/// 8-bit BGR as a picture. O(pixels).
[[nodiscard]] Picture picture_of(const cv::Mat& bgr);

/// photo: turns a camera's frame into a page. lines: finds a page's lines and makes a first map of
/// them. map: makes a map of lines that were found before.
enum class TraceStep : std::uint8_t { photo, lines, map };

struct TraceWork {
    TraceStep step = TraceStep::lines;
    TraceOptions options;
    bool wants_edges = false;      // also the picture of the edges' strengths
    bool has_main_things = false;  // a mask comes before the page (traced.h)
    PhotoCut cut;
};

[[nodiscard]] std::vector<std::string> arguments_of(const TraceWork& work);

/// Reads the same back, bit for bit. Fails for anything else. The ranges of the numbers are checked
/// where they are used.
[[nodiscard]] Result<TraceWork> trace_work_in(std::span<const std::string> arguments);

}  // namespace touchline
