// The few colours of a flat picture, and the colour of each pixel, without the mixtures along edges
// and the specks; areas that fade into one another; marks too small for an area of their own.
// Threads: pure functions.
#pragma once

#include "vision/contour/gradient.h"

#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// A map names the colour of each pixel by a byte, its place in a palette.
inline constexpr std::size_t most_colours = 256;

/// Returns at most 64 colours, the commonest first, at least 16 grey levels apart: the peaks of the
/// histogram (bins of 8) of all pixels that are like their neighbours. Leaves out colours of less
/// than 0.05 % of the picture, or of 0.6 % of one within 45 grey levels, and those within 45 of one
/// that are nearly all spots, neither lines nor areas. Never empty. O(pixels).
[[nodiscard]] std::vector<cv::Vec3f> palette_of(const LabPicture& lab, double noise);

/// Returns the nearest colour of the palette for each pixel. O(pixels).
[[nodiscard]] cv::Mat1b nearest_colours(const LabPicture& lab,
                                        const std::vector<cv::Vec3f>& palette);

/// Returns for each pixel the index of its colour in the palette, as nearest_colours says, except
/// that a pixel at an edge whose colour is a mixture of two colours beside it belongs to the nearer
/// of the two, although a third may look like it (black on white has grey edges). O(pixels).
[[nodiscard]] cv::Mat1b region_map(const LabPicture& lab, const std::vector<cv::Vec3f>& palette);

/// Gives regions (4-connected) of fewer than `least_px` pixels to what lies beside them, if there
/// are larger ones. O(pixels).
void overgrow_specks(cv::Mat1b& map, int least_px);

/// Gives the pixels of the mask to what lies beside them, all at the same pace; none stay, unless
/// there is nothing else. O(pixels).
void overgrow(cv::Mat1b& map, const cv::Mat1b& mask);

/// Returns the commonest colour of a map. O(pixels).
[[nodiscard]] uchar ground_of(const cv::Mat1b& map);

/// Returns by how much a colour differs from the ground at most, grey levels. O(colours).
[[nodiscard]] double strongest_contrast(const std::vector<cv::Vec3f>& palette, uchar ground);

/// Pixels of one colour beside each other in a row. Flat pictures have few such runs.
struct Run {
    int row = 0;
    int from = 0;  // columns from ... to - 1
    int to = 0;
    std::size_t region = 0;  // index of the first run of the same 4-connected region
};

/// Row by row, from the left. O(pixels).
[[nodiscard]] std::vector<Run> runs_of(const cv::Mat1b& map);

/// Joins regions of the map if their common border is no step, but part of a slow change of colour.
/// Each joined region gets its own colour at the end of the palette; the ground keeps its colour.
/// Does not join two regions of one even colour each, because a step may be blurred, nor two that
/// meet in a step elsewhere: a shape that fades into the ground on one side stays whole. Returns
/// 255 where remaining borders run without a step, a pixel to each side.
/// At most 256 colours; regions beyond that stay apart. More than 1500 regions are grain and stay
/// as they are. O(pixels + regions squared).
[[nodiscard]] cv::Mat1b join_fading(cv::Mat1b& map, std::vector<cv::Vec3f>& palette,
                                    const LabPicture& lab);

struct FineMarks {
    cv::Mat1b lines;     // 255 inside: long, or parts of the known strokes
    cv::Mat1b bits;      // all others: dashes, dots, letters
    cv::Mat1f contrast;  // to the area around, grey levels
};

/// An area's colours, without its strokes.
struct Areas {
    const cv::Mat1b& map;
    const std::vector<cv::Vec3f>& palette;
};

/// Finds thin pixels of a picture that differ from their area clearly and abruptly. `strokes` are
/// the ones already known; `smoothing_px` is the picture's smoothing. O(pixels).
[[nodiscard]] FineMarks fine_marks(const LabPicture& lab, const Areas& areas,
                                   const cv::Mat1b& strokes, double noise, double smoothing_px,
                                   double greatest_width_px);

}  // namespace touchline
