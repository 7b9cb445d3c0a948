#include "vision/prepare/sheet_edge.h"

#include "vision/contour/gradient.h"
#include "vision/prepare/paper.h"
#include "vision/prepare/sheet_sides.h"

#include <algorithm>
#include <array>
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
