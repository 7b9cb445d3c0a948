#include "vision/prepare/sheet_sides.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int kRun_px = 5;         // of paper: the sheet has begun
constexpr double kDeepest = 0.25;  // of the picture's side: no sheet begins further in
const double kMostLean = std::tan(10.0 * std::numbers::pi / 180.0);
constexpr double kOnEdge_px = 1.3;
constexpr double kMostlyOnEdge = 0.7;   // of the rows: strokes may run off the sheet
constexpr double kLeastBeyond = 0.12;   // of the rows have bed
constexpr double kLeastDepth_px = 1.5;  // of the bed, if there is any
constexpr int kEdgeTries = 32;          // places along a side through which lines are tried

/// Returns where the paper begins in each row of the view; nothing where it does not.
std::vector<std::optional<int>> depths_of(const cv::Mat1b& paper) {
    const int deepest = static_cast<int>(kDeepest * paper.cols);
    std::vector<std::optional<int>> depths(static_cast<std::size_t>(paper.rows));
    for (int y = 0; y < paper.rows; ++y) {
        int run = 0;
        for (int x = 0; x < deepest + kRun_px && run < kRun_px; ++x) {
            run = paper(y, x) != 0 ? run + 1 : 0;
            if (run == kRun_px) {
                depths[static_cast<std::size_t>(y)] = x + 1 - kRun_px;
            }
        }
    }
    return depths;
}

/// Fits the edge through the middle of the rows that agree with it.
SheetEdge settled(const SheetEdge& edge, const std::vector<std::optional<int>>& depths) {
    std::vector<cv::Point2f> on;
    for (std::size_t row = 0; row < depths.size(); ++row) {
        const auto at = static_cast<double>(row);
        if (depths[row].value_or(0) > 0 && std::abs(*depths[row] - edge.at(at)) <= kOnEdge_px) {
            on.emplace_back(static_cast<float>(*depths[row]), static_cast<float>(row));
        }
    }
    cv::Vec4d line;  // its direction, then a point of it
    cv::fitLine(on, line, cv::DIST_L2, 0.0, 0.01, 0.01);
    const double lean = line[0] / line[1];
    return {line[2] - lean * line[3], lean};
}

}  // namespace

cv::Mat SideView::of(const cv::Mat& mat) const {
    cv::Mat out = is_transposed ? cv::Mat(mat.t()) : mat.clone();
    if (is_flipped) {
        cv::flip(out, out, 1);
    }
    return out;
}

cv::Point2d SideView::back(cv::Point2d at, cv::Size size) const {
    if (is_flipped) {
        at.x = (is_transposed ? size.height : size.width) - 1 - at.x;
    }
    return is_transposed ? cv::Point2d(at.y, at.x) : at;
}

std::optional<SheetEdge> edge_of(const cv::Mat1b& paper) {
    const std::vector<std::optional<int>> depths = depths_of(paper);
    const auto is_known = [](const std::optional<int>& depth) { return depth.has_value(); };
    // Rows at the ends may lie beside the sheet, on the bed of the next side.
    const auto from = std::ranges::find_if(depths, is_known) - depths.begin();
    const auto to = std::find_if(depths.rbegin(), depths.rend(), is_known).base() - depths.begin();
    const auto rows = to - from;
    if (rows < paper.rows / 2) {
        return std::nullopt;
    }
    std::optional<SheetEdge> best;
    std::ptrdiff_t most = static_cast<std::ptrdiff_t>(kMostlyOnEdge * static_cast<double>(rows));
    const auto row_of = [&](int i) { return from + rows * (2 * i + 1) / (2 * kEdgeTries); };
    for (int i = 0; i < kEdgeTries; ++i) {
        for (int j = i + kEdgeTries / 4; j < kEdgeTries; ++j) {
            const auto one = depths[static_cast<std::size_t>(row_of(i))];
            const auto other = depths[static_cast<std::size_t>(row_of(j))];
            if (one.value_or(0) == 0 || other.value_or(0) == 0) {
                continue;
            }
            SheetEdge edge;
            edge.lean =
                static_cast<double>(*other - *one) / static_cast<double>(row_of(j) - row_of(i));
            edge.first_px = *one - edge.lean * static_cast<double>(row_of(i));
            std::ptrdiff_t on = 0;
            std::ptrdiff_t beyond = 0;
            for (auto row = from; row < to; ++row) {
                const double expected = std::max(0.0, edge.at(static_cast<double>(row)));
                const auto& depth = depths[static_cast<std::size_t>(row)];
                on += depth && std::abs(*depth - expected) <= kOnEdge_px ? 1 : 0;
                beyond += expected >= kLeastDepth_px ? 1 : 0;
            }
            const bool is_edge =
                std::abs(edge.lean) <= kMostLean &&
                static_cast<double>(beyond) >= kLeastBeyond * static_cast<double>(rows);
            if (is_edge && on > most) {
                most = on;
                best = edge;
            }
        }
    }
    return best ? std::optional(settled(*best, depths)) : std::nullopt;
}

}  // namespace touchline
