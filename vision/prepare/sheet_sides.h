// The sides of a scan, each seen as the left one, the straight edges of its sheet, and the holes
// that a punch made beside them.
// Threads: pure functions.
#pragma once

#include <array>
#include <optional>

#include <opencv2/core.hpp>

namespace touchline {

/// A copy of a picture, seen so that one of its four sides is the left one.
struct SideView {
    bool is_flipped = false;  // left and right, afterwards
    bool is_transposed = false;

    [[nodiscard]] cv::Mat of(const cv::Mat& mat) const;

    /// Converts a place in the view to one in the picture, which is `size` large.
    [[nodiscard]] cv::Point2d back(cv::Point2d at, cv::Size size) const;
};

inline constexpr std::array<SideView, 4> side_views{
    {{false, false}, {false, true}, {true, false}, {true, true}}};  // left, top, right, bottom

/// The edge of the sheet on one side: how deep the bed is, by rows of the view.
struct SheetEdge {
    double first_px = 0.0;
    double lean = 0.0;

    [[nodiscard]] double at(double row) const { return first_px + lean * row; }
};

using SheetEdges = std::array<std::optional<SheetEdge>, 4>;  // in the order of side_views

/// Returns the straight edge on the left of a view that most rows agree with; `paper`: 255 where it
/// is. The edge leans at most 10 degrees and lies within a quarter of the width. O(pixels + rows).
[[nodiscard]] std::optional<SheetEdge> edge_of(const cv::Mat1b& paper);

/// Returns 255 where holes are: two to six discs that are alike, in a row beside one side of the
/// sheet, even about its middle. `ink`: neither paper nor beyond the sheet. O(pixels).
[[nodiscard]] cv::Mat1b punched_holes(const cv::Mat1b& ink, const SheetEdges& edges);

}  // namespace touchline
