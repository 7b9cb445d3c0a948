#include "vision/prepare/sheet_sides.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int paper_run_px = 5;         // of paper: the sheet has begun
constexpr double deepest_share = 0.25;  // of the picture's side: no sheet begins further in
const double most_lean = std::tan(10.0 * std::numbers::pi / 180.0);
constexpr double on_edge_px = 1.3;
constexpr double mostly_on_edge = 0.7;  // of the rows: strokes may run off the sheet
constexpr double least_beyond = 0.12;   // of the rows have bed
constexpr double least_depth_px = 1.5;  // of the bed, if there is any
constexpr int edge_tries = 32;          // places along a side through which lines are tried

/// Returns where the paper begins in each row of the view; nothing where it does not.
std::vector<std::optional<int>> depths_of(const cv::Mat1b& paper) {
    const int deepest = static_cast<int>(deepest_share * paper.cols);
    std::vector<std::optional<int>> depths(static_cast<std::size_t>(paper.rows));
    for (int y = 0; y < paper.rows; ++y) {
        int run = 0;
        for (int x = 0; x < deepest + paper_run_px && run < paper_run_px; ++x) {
            run = paper(y, x) != 0 ? run + 1 : 0;
            if (run == paper_run_px) depths[static_cast<std::size_t>(y)] = x + 1 - paper_run_px;
        }
    }
    return depths;
}

/// Fits the edge through the middle of the rows that agree with it.
SheetEdge settled(const SheetEdge& edge, const std::vector<std::optional<int>>& depths) {
    std::vector<cv::Point2f> on;
    for (std::size_t row = 0; row < depths.size(); ++row) {
        const auto at = static_cast<double>(row);
        if (depths[row].value_or(0) > 0 && std::abs(*depths[row] - edge.at(at)) <= on_edge_px) {
            on.emplace_back(static_cast<float>(*depths[row]), static_cast<float>(row));
        }
    }
    cv::Vec4d line;  // its direction, then a point of it
    cv::fitLine(on, line, cv::DIST_L2, 0.0, 0.01, 0.01);
    const double lean = line[0] / line[1];
    return {line[2] - lean * line[3], lean};
}

constexpr double least_hole = 0.012;  // of the longer side: across
constexpr double most_hole = 0.05;
constexpr double hole_from_edge = 0.1;  // of the picture across: its middle lies no further in
constexpr double even_holes = 0.03;     // of the side: how even they lie about its middle
constexpr double same_hole = 0.15;      // of the hole across
constexpr double in_row_px = 4.0;       // as far from the edge
constexpr double soft_rim_px = 3.0;
constexpr std::size_t most_holes = 6;

struct Hole {
    cv::Point2d middle;
    double across_px = 0.0;
};

std::vector<Hole> discs_of(const cv::Mat1b& ink) {
    cv::Mat1i label;
    cv::Mat1i stats;
    cv::Mat1d centres;
    const int n = cv::connectedComponentsWithStats(ink, label, stats, centres, 8, CV_32S);
    const double longer = std::max(ink.cols, ink.rows);
    std::vector<Hole> found;
    for (int i = 1; i < n; ++i) {
        const int width = stats(i, cv::CC_STAT_WIDTH);
        const int height = stats(i, cv::CC_STAT_HEIGHT);
        const double across = 0.5 * (width + height);
        const double round =
            stats(i, cv::CC_STAT_AREA) / (0.25 * std::numbers::pi * width * height);
        if (across >= least_hole * longer && across <= most_hole * longer &&
            std::abs(width - height) <= 0.1 * across + 1.0 && round > 0.9 && round < 1.15) {
            found.push_back({{centres(i, 0), centres(i, 1)}, across});
        }
    }
    return found;
}

/// The place of a hole beside a side of the sheet.
struct Beside {
    double along_px = 0.0;  // from the middle of the side
    double in_px = 0.0;     // from its edge
};

Beside beside(std::size_t side, const Hole& hole, cv::Size whole, const SheetEdges& edges) {
    const SideView& view = side_views[side];
    const cv::Size size = view.is_transposed ? cv::Size(whole.height, whole.width) : whole;
    const cv::Point2d at =
        view.is_transposed ? cv::Point2d(hole.middle.y, hole.middle.x) : hole.middle;
    const double in = view.is_flipped ? size.width - 1 - at.x : at.x;
    const auto depth = [&](std::size_t other, double row) {
        return edges[other] ? std::max(0.0, edges[other]->at(row)) : 0.0;
    };
    const std::size_t before = view.is_transposed ? 0 : 1;  // the sides that this one runs to
    const double middle = 0.5 * (size.height + depth(before, at.x) - depth(before + 2, at.x));
    return {at.y - middle, in - depth(side, at.y)};
}

bool are_punched(const std::vector<Hole>& row, const std::vector<Beside>& places, double side_px) {
    if (row.size() < 2 || row.size() > most_holes) return false;
    double sum_px = 0.0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        sum_px += places[i].along_px;
        const double first_px = row.front().across_px;
        if (std::abs(row[i].across_px - first_px) > same_hole * first_px + 1.0 ||
            std::abs(places[i].in_px - places.front().in_px) > in_row_px) {
            return false;
        }
    }
    return std::abs(sum_px) <= even_holes * side_px * static_cast<double>(row.size());
}

}  // namespace

cv::Mat SideView::of(const cv::Mat& mat) const {
    cv::Mat out = is_transposed ? cv::Mat(mat.t()) : mat.clone();
    if (is_flipped) cv::flip(out, out, 1);
    return out;
}

cv::Point2d SideView::back(cv::Point2d at, cv::Size size) const {
    if (is_flipped) at.x = (is_transposed ? size.height : size.width) - 1 - at.x;
    return is_transposed ? cv::Point2d(at.y, at.x) : at;
}

std::optional<SheetEdge> edge_of(const cv::Mat1b& paper) {
    const std::vector<std::optional<int>> depths = depths_of(paper);
    const auto is_known = [](const std::optional<int>& depth) { return depth.has_value(); };
    // Rows at the ends may lie beside the sheet, on the bed of the next side.
    const auto from = std::ranges::find_if(depths, is_known) - depths.begin();
    const auto to = std::find_if(depths.rbegin(), depths.rend(), is_known).base() - depths.begin();
    const auto rows = to - from;
    if (rows < paper.rows / 2) return std::nullopt;
    std::optional<SheetEdge> best;
    std::ptrdiff_t most = static_cast<std::ptrdiff_t>(mostly_on_edge * static_cast<double>(rows));
    const auto row_of = [&](int i) { return from + rows * (2 * i + 1) / (2 * edge_tries); };
    for (int i = 0; i < edge_tries; ++i) {
        for (int j = i + edge_tries / 4; j < edge_tries; ++j) {
            const auto one = depths[static_cast<std::size_t>(row_of(i))];
            const auto other = depths[static_cast<std::size_t>(row_of(j))];
            if (one.value_or(0) == 0 || other.value_or(0) == 0) continue;
            SheetEdge edge;
            edge.lean =
                static_cast<double>(*other - *one) / static_cast<double>(row_of(j) - row_of(i));
            edge.first_px = *one - edge.lean * static_cast<double>(row_of(i));
            std::ptrdiff_t on = 0;
            std::ptrdiff_t beyond = 0;
            for (auto row = from; row < to; ++row) {
                const double expected = std::max(0.0, edge.at(static_cast<double>(row)));
                const auto& depth = depths[static_cast<std::size_t>(row)];
                on += depth && std::abs(*depth - expected) <= on_edge_px ? 1 : 0;
                beyond += expected >= least_depth_px ? 1 : 0;
            }
            const bool is_edge =
                std::abs(edge.lean) <= most_lean &&
                static_cast<double>(beyond) >= least_beyond * static_cast<double>(rows);
            if (is_edge && on > most) {
                most = on;
                best = edge;
            }
        }
    }
    return best ? std::optional(settled(*best, depths)) : std::nullopt;
}

cv::Mat1b punched_holes(const cv::Mat1b& ink, const SheetEdges& edges) {
    cv::Mat1b punched(ink.size(), uchar{0});
    const std::vector<Hole> discs = discs_of(ink);
    for (std::size_t side = 0; side < side_views.size(); ++side) {
        const bool is_upright = !side_views[side].is_transposed;
        const double across_px = is_upright ? ink.cols : ink.rows;
        const double side_px = is_upright ? ink.rows : ink.cols;
        std::vector<Hole> row;
        std::vector<Beside> places;
        for (const Hole& disc : discs) {
            const Beside place = beside(side, disc, ink.size(), edges);
            if (place.in_px <= hole_from_edge * across_px) {
                row.push_back(disc);
                places.push_back(place);
            }
        }
        if (are_punched(row, places, side_px)) {
            for (const Hole& hole : row) {
                cv::circle(punched, cv::Point(hole.middle),
                           cvRound(0.5 * hole.across_px + soft_rim_px), cv::Scalar(255),
                           cv::FILLED);
            }
        }
    }
    return punched;
}

}  // namespace touchline
