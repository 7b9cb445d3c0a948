#include "vision/prepare/sheet_edge.h"

#include "config/types/angle.h"
#include "vision/contour/gradient.h"
#include "vision/prepare/paper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double scan_pixels = 6e4;     // four tenths of a millimetre at the hand each
constexpr double most_equal = 0.8;      // of neighbouring pixels: with more, a program painted it
constexpr double rim = 0.12;            // of each side: the bed may lie there
constexpr float dark_share = 0.6F;      // of the lightest: no paper, however shaded
constexpr double least_paper = 0.2;     // of the picture
constexpr float like_paper = 22.0F;     // grey levels, all channels together
constexpr float grey_levels = 30.0F;    // levels between channels: of lids and their shadows
constexpr double same_bed = 60.0;       // grey levels, all channels together
constexpr double soft_margin_px = 2.0;  // inside the edge, where it is soft
constexpr double rounding_share = 0.1;  // of the shorter side: the largest rounding

/// A copy of a picture, seen so that one of its four sides is the left one.
struct SideView {
    bool is_flipped = false;  // left and right, afterwards
    bool is_transposed = false;

    cv::Mat of(const cv::Mat& mat) const {
        cv::Mat out = is_transposed ? cv::Mat(mat.t()) : mat.clone();
        if (is_flipped) cv::flip(out, out, 1);
        return out;
    }

    /// Converts a place in the view to one in the picture, which is `size` large.
    cv::Point2d back(cv::Point2d at, cv::Size size) const {
        if (is_flipped) at.x = (is_transposed ? size.height : size.width) - 1 - at.x;
        return is_transposed ? cv::Point2d(at.y, at.x) : at;
    }
};

constexpr std::array<SideView, 4> side_views{
    {{false, false}, {false, true}, {true, false}, {true, true}}};  // left, top, right, bottom

/// The edge of the sheet on one side: how deep the bed is, by rows of the view.
struct SheetEdge {
    double first_px = 0.0;
    double lean = 0.0;

    double at(double row) const { return first_px + lean * row; }
};

using SheetEdges = std::array<std::optional<SheetEdge>, 4>;  // in the order of side_views

constexpr int paper_run_px = 5;         // of paper: the sheet has begun
constexpr double deepest_share = 0.25;  // of the picture's side: no sheet begins further in
const double most_lean = std::tan(radians(10.0));
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

/// Returns the straight edge on the left of a view that most rows agree with; `paper`: 255 where it
/// is. The edge leans at most 10 degrees and lies within a quarter of the width. O(pixels + rows).
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

/// Returns 255 where holes are: two to six discs that are alike, in a row beside one side of the
/// sheet, even about its middle. `ink`: neither paper nor beyond the sheet. O(pixels).
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

/// Returns whether a program painted it, and no scanner saw it: most pixels equal their neighbours
/// exactly.
bool is_painted(const cv::Mat& picture) {
    constexpr int row_step = 16;
    std::size_t equal = 0;
    std::size_t asked = 0;
    for (int y = 0; y < picture.rows; y += row_step) {
        const cv::Vec3b* row = picture.ptr<cv::Vec3b>(y);
        for (int x = 1; x < picture.cols; ++x, ++asked) equal += row[x] == row[x - 1] ? 1U : 0U;
    }
    return static_cast<double>(equal) >= most_equal * static_cast<double>(asked);
}

/// Returns the median colour of what lies beyond the edge.
cv::Vec3f bed_beyond(const cv::Mat3f& view, const SheetEdge& edge) {
    cv::Vec3f sum;
    int count = 0;
    for (int y = 0; y < view.rows; ++y) {
        for (int x = 0; x + 1 < edge.at(y); ++x, ++count) sum += view(y, x);
    }
    return count == 0 ? cv::Vec3f() : sum * (1.0F / static_cast<float>(count));
}

bool is_grey(const cv::Vec3f& colour) {
    return *std::ranges::max_element(colour.val) - *std::ranges::min_element(colour.val) <=
           grey_levels;
}

/// Returns the picture without what is surely not paper: its rim, where the bed may lie, and
/// everything that is dark in a channel.
cv::Mat3f likely_paper(const cv::Mat3f& picture) {
    cv::Mat1f least(picture.size());
    std::ranges::transform(picture, least.begin(), [](const cv::Vec3f& p) {
        return std::min({p[0], p[1], p[2]});
    });
    const float dark = dark_share * quantile(least, 0.95);
    const auto is_rim = [](int at, int size) {
        return std::min(at, size - 1 - at) < static_cast<int>(rim * size);
    };
    cv::Mat3f likely = picture.clone();
    for (int y = 0; y < picture.rows; ++y) {
        for (int x = 0; x < picture.cols; ++x) {
            if (is_rim(y, picture.rows) || is_rim(x, picture.cols) || least(y, x) < dark)
                likely(y, x) = no_paper(x, y);
        }
    }
    return likely;
}

/// A small copy of the picture, its paper, and what was found around the sheet.
class Scan {
  public:
    explicit Scan(const cv::Mat& picture) {
        reduced(picture, scan_pixels).convertTo(copy_, CV_32FC3);
        const Paper paper(likely_paper(copy_));
        part_ = paper.part();
        surface_ = cv::Mat3f(copy_.size());
        paper_ = cv::Mat1b(copy_.size());
        std::vector<cv::Vec3f> row;
        for (int y = 0; y < copy_.rows; ++y) {
            paper.fill_row(y, row);
            std::ranges::copy(row, surface_[y]);
            for (int x = 0; x < copy_.cols; ++x) {
                const cv::Vec3f off = copy_(y, x) - surface_(y, x);
                paper_(y, x) = off.dot(off) < like_paper * like_paper ? 255 : 0;
            }
        }
    }

    /// Returns the paper's colour, taken from the nearest place of the sheet for places beyond it,
    /// because no surface is known there.
    [[nodiscard]] cv::Mat3f paper_beside(const cv::Mat1b& beyond) const {
        return painted_over(surface_, beyond);
    }

    /// Returns what does not belong to the sheet, 255; empty if everything does.
    [[nodiscard]] cv::Mat1b around() {
        if (part_ < least_paper) return {};
        find_edges();
        beyond_ = cv::Mat1b(copy_.size(), uchar{0});
        for (std::size_t side = 0; side < side_views.size(); ++side) {
            if (edges_[side]) fill_beyond(side_views[side], *edges_[side]);
        }
        add_corners();
        beyond_ |= punched_holes(cv::Mat(~(paper_ | beyond_)), edges_);
        return cv::countNonZero(beyond_) > 0 ? beyond_ : cv::Mat1b();
    }

  private:
    /// A lid is grey, and a bed of another colour lies on all sides, so a band of a drawing is
    /// neither.
    void find_edges() {
        for (std::size_t side = 0; side < side_views.size(); ++side) {
            edges_[side] = edge_of(side_views[side].of(paper_));
            if (edges_[side]) beds_[side] = bed_beyond(side_views[side].of(copy_), *edges_[side]);
        }
        const auto is_like_first = [&](std::size_t side) {
            return edges_[side] && edges_[0] && cv::norm(beds_[side] - beds_[0]) < same_bed;
        };
        if (is_like_first(0) && is_like_first(1) && is_like_first(2) && is_like_first(3)) return;
        for (std::size_t side = 0; side < side_views.size(); ++side) {
            if (edges_[side] && !is_grey(beds_[side])) edges_[side].reset();
        }
    }

    void fill_beyond(const SideView& view, const SheetEdge& edge) {
        const int rows = view.is_transposed ? copy_.cols : copy_.rows;
        std::vector<cv::Point> points;
        for (const cv::Point2d& at :
             {cv::Point2d(-1.0, -1.0), cv::Point2d(edge.at(-1.0) + soft_margin_px, -1.0),
              cv::Point2d(edge.at(rows) + soft_margin_px, rows), cv::Point2d(-1.0, rows)}) {
            const cv::Point2d back = view.back({std::max(-1.0, at.x), at.y}, copy_.size());
            points.emplace_back(cvRound(back.x), cvRound(back.y));
        }
        cv::fillConvexPoly(beyond_, points, cv::Scalar(255));
    }

    /// Adds the bed that a rounded corner leaves free.
    void add_corners() {
        for (std::size_t side = 0; side < side_views.size(); ++side) {
            const auto& one = edges_[side];
            const auto& other = edges_[(side + 1) % side_views.size()];
            if (one && other) add_corner(side, *one, *other);
        }
    }

    void add_corner(std::size_t side, const SheetEdge& one, const SheetEdge& other) {
        // The approximate corner: where one edge is as far from the frame as the other.
        const bool is_far = side == 1 || side == 2;  // the next side lies at the view's far end
        const int rows = side_views[side].is_transposed ? copy_.cols : copy_.rows;
        const int next_rows = side_views[(side + 1) % 4].is_transposed ? copy_.cols : copy_.rows;
        const double across = other.at(side < 2 ? 0.0 : next_rows - 1.0);
        const double row = is_far ? rows - 1.0 - across : across;
        const cv::Point2d at = side_views[side].back({one.at(row), row}, copy_.size());
        const int reach = static_cast<int>(rounding_share * std::min(copy_.cols, copy_.rows));
        const cv::Rect box =
            cv::Rect(cvRound(at.x) - reach, cvRound(at.y) - reach, 2 * reach + 1, 2 * reach + 1) &
            cv::Rect({}, copy_.size());
        if (box.empty()) return;
        const cv::Vec3f bed = 0.5F * (beds_[side] + beds_[(side + 1) % side_views.size()]);
        cv::Mat1b is_bed(box.size());
        for (int y = 0; y < box.height; ++y) {
            for (int x = 0; x < box.width; ++x) {
                const cv::Point p = box.tl() + cv::Point(x, y);
                is_bed(y, x) = paper_(p) == 0 && cv::norm(copy_(p) - bed) < same_bed ? 255 : 0;
            }
        }
        cv::Mat1b here = beyond_(box);
        is_bed |= here;
        cv::Mat1i label;
        const int n = cv::connectedComponents(is_bed, label, 4, CV_32S);
        std::vector<uchar> touches(static_cast<std::size_t>(n), 0);
        for (int y = 0; y < box.height; ++y) {
            for (int x = 0; x < box.width; ++x) {
                touches[static_cast<std::size_t>(label(y, x))] |= here(y, x);
            }
        }
        cv::Mat1b grown(box.size(), uchar{0});
        for (int y = 0; y < box.height; ++y) {
            for (int x = 0; x < box.width; ++x) {
                grown(y, x) = label(y, x) != 0 ? touches[static_cast<std::size_t>(label(y, x))] : 0;
            }
        }
        const int margin = static_cast<int>(2.0 * soft_margin_px) + 1;
        cv::dilate(grown, grown, cv::getStructuringElement(cv::MORPH_ELLIPSE, {margin, margin}));
        here |= grown;
    }

    cv::Mat3f copy_;
    cv::Mat3f surface_;  // the paper's colour everywhere
    cv::Mat1b paper_;    // the part of that colour, 255
    double part_ = 0.0;  // of the picture that is paper
    SheetEdges edges_;
    std::array<cv::Vec3f, 4> beds_;  // their colours, if there is an edge
    cv::Mat1b beyond_;
};

}  // namespace

cv::Mat within_sheet(const cv::Mat& picture) {
    if (picture.type() != CV_8UC3 || is_painted(picture)) return picture;
    Scan scan(picture);
    cv::Mat1b around = scan.around();
    if (around.empty()) return picture;
    cv::Mat paper;
    cv::resize(scan.paper_beside(around), paper, picture.size(), 0.0, 0.0, cv::INTER_LINEAR);
    paper.convertTo(paper, CV_8UC3);
    cv::resize(around, around, picture.size(), 0.0, 0.0, cv::INTER_NEAREST);
    cv::Mat within = picture.clone();
    paper.copyTo(within, around);
    return within;
}

}  // namespace touchline
