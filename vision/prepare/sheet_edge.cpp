#include "vision/prepare/sheet_edge.h"

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

constexpr double kScanPixels = 6e4;  // four tenths of a millimetre at the hand each
constexpr double kMostEqual = 0.8;   // of neighbouring pixels: more are painted, not seen
constexpr double kRim = 0.12;        // of each side: there the bed may lie
constexpr float kDark = 0.6F;        // of the lightest: no paper, however shaded
constexpr double kLeastPaper = 0.2;  // of the picture
constexpr float kLikePaper = 22.0F;  // grey levels, all channels together
constexpr int kRun_px = 5;           // of paper: the sheet has begun
constexpr double kDeepest = 0.25;    // of the picture's side: no sheet begins further in
const double kMostLean = std::tan(10.0 * std::numbers::pi / 180.0);
constexpr double kOnEdge_px = 1.3;
constexpr double kMostlyOnEdge = 0.7;   // of the rows: strokes may run off the sheet
constexpr double kLeastBeyond = 0.12;   // of the rows have bed
constexpr double kLeastDepth_px = 1.5;  // of the bed, where there is any
constexpr int kEdgeTries = 32;          // places along a side that lines are tried through
constexpr float kGrey = 30.0F;          // levels between channels: of lids and their shadows
constexpr double kSameBed = 60.0;       // grey levels, all channels together
constexpr double kMargin_px = 2.0;      // inside the edge, where it is soft
constexpr double kCorner = 0.1;         // of the shorter side: the largest rounding
constexpr double kLeastHole = 0.012;    // of the longer side: across
constexpr double kMostHole = 0.05;
constexpr double kHoleFromEdge = 0.1;  // of the picture across: its middle lies no further in
constexpr double kEvenHoles = 0.03;    // of the side: how even they lie about its middle
constexpr double kSameHole = 0.15;     // of the hole across
constexpr double kInRow_px = 4.0;      // as far from the edge
constexpr std::size_t kMostHoles = 6;

/// Whether a program painted it, and no scanner saw it: most pixels equal their neighbours exactly.
bool is_painted(const cv::Mat& picture) {
    constexpr int kRowStep = 16;
    std::size_t equal = 0;
    std::size_t asked = 0;
    for (int y = 0; y < picture.rows; y += kRowStep) {
        const cv::Vec3b* row = picture.ptr<cv::Vec3b>(y);
        for (int x = 1; x < picture.cols; ++x, ++asked) {
            equal += row[x] == row[x - 1] ? 1U : 0U;
        }
    }
    return static_cast<double>(equal) >= kMostEqual * static_cast<double>(asked);
}

/// The copy of a picture, seen so that one of its four sides is the left one.
struct View {
    bool is_flipped = false;  // left and right, after
    bool is_transposed = false;

    [[nodiscard]] cv::Mat of(const cv::Mat& mat) const {
        cv::Mat out = is_transposed ? cv::Mat(mat.t()) : mat.clone();
        if (is_flipped) {
            cv::flip(out, out, 1);
        }
        return out;
    }

    /// A place in the view, in the picture that is `size` large.
    [[nodiscard]] cv::Point2d back(cv::Point2d at, cv::Size size) const {
        if (is_flipped) {
            at.x = (is_transposed ? size.height : size.width) - 1 - at.x;
        }
        return is_transposed ? cv::Point2d(at.y, at.x) : at;
    }
};

constexpr std::array<View, 4> kSides{
    {{false, false}, {false, true}, {true, false}, {true, true}}};  // left, top, right, bottom

/// The edge of the sheet on one side: how deep the bed is, by rows of the view.
struct Edge {
    double first_px = 0.0;
    double lean = 0.0;
    cv::Vec3f bed;

    [[nodiscard]] double at(double row) const { return first_px + lean * row; }
};

/// Where the paper begins in each row of the view; nothing where it does not.
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

/// The middle colour of what lies beyond the edge.
cv::Vec3f bed_beyond(const cv::Mat3f& view, const Edge& edge) {
    cv::Vec3f sum;
    int count = 0;
    for (int y = 0; y < view.rows; ++y) {
        for (int x = 0; x + 1 < edge.at(y); ++x, ++count) {
            sum += view(y, x);
        }
    }
    return count == 0 ? cv::Vec3f() : sum * (1.0F / static_cast<float>(count));
}

/// Through the middle of the rows that agree with it.
Edge settled(const Edge& edge, const std::vector<std::optional<int>>& depths) {
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
    return {line[2] - lean * line[3], lean, edge.bed};
}

/// The straight edge that most rows agree with.
std::optional<Edge> edge_of(const cv::Mat1b& paper) {
    const std::vector<std::optional<int>> depths = depths_of(paper);
    const auto is_known = [](const std::optional<int>& depth) { return depth.has_value(); };
    // Rows at the ends may lie beside the sheet, on the bed of the next side.
    const auto from = std::ranges::find_if(depths, is_known) - depths.begin();
    const auto to = std::find_if(depths.rbegin(), depths.rend(), is_known).base() - depths.begin();
    const auto rows = to - from;
    if (rows < paper.rows / 2) {
        return std::nullopt;
    }
    std::optional<Edge> best;
    std::ptrdiff_t most = static_cast<std::ptrdiff_t>(kMostlyOnEdge * static_cast<double>(rows));
    const auto row_of = [&](int i) { return from + rows * (2 * i + 1) / (2 * kEdgeTries); };
    for (int i = 0; i < kEdgeTries; ++i) {
        for (int j = i + kEdgeTries / 4; j < kEdgeTries; ++j) {
            const auto one = depths[static_cast<std::size_t>(row_of(i))];
            const auto other = depths[static_cast<std::size_t>(row_of(j))];
            if (one.value_or(0) == 0 || other.value_or(0) == 0) {
                continue;
            }
            Edge edge;
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

bool is_grey(const cv::Vec3f& colour) {
    return *std::ranges::max_element(colour.val) - *std::ranges::min_element(colour.val) <= kGrey;
}

/// The picture without what is no paper, be it evener: its rim, where the bed may lie, and all that
/// is dark in a channel. Gets colours that are far from all others and from each other.
cv::Mat3f likely_paper(const cv::Mat3f& picture) {
    cv::Mat1f least(picture.size());
    std::ranges::transform(picture, least.begin(), [](const cv::Vec3f& p) {
        return std::min({p[0], p[1], p[2]});
    });
    const float dark = kDark * quantile(least, 0.95);
    const auto is_rim = [](int at, int size) {
        return std::min(at, size - 1 - at) < static_cast<int>(kRim * size);
    };
    cv::Mat3f likely = picture.clone();
    for (int y = 0; y < picture.rows; ++y) {
        for (int x = 0; x < picture.cols; ++x) {
            if (is_rim(y, picture.rows) || is_rim(x, picture.cols) || least(y, x) < dark) {
                likely(y, x) = cv::Vec3f::all(-1000.0F * static_cast<float>(1 + (7 * y + x) % 97));
            }
        }
    }
    return likely;
}

/// A small copy of the picture, its paper, and what was found around the sheet.
class Scan {
  public:
    explicit Scan(const cv::Mat& picture) {
        reduced(picture, kScanPixels).convertTo(copy_, CV_32FC3);
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
                paper_(y, x) = off.dot(off) < kLikePaper * kLikePaper ? 255 : 0;
            }
        }
    }

    /// The paper's colour, of the nearest place of the sheet where it is beyond: no surface is
    /// known there.
    [[nodiscard]] cv::Mat3f paper_beside(const cv::Mat1b& beyond) const {
        cv::Mat1f apart;
        cv::Mat1i nearest;
        cv::distanceTransform(beyond, apart, nearest, cv::DIST_L2, cv::DIST_MASK_5,
                              cv::DIST_LABEL_PIXEL);
        std::vector<cv::Vec3f> colours(beyond.total() + 1);
        for (int y = 0; y < beyond.rows; ++y) {
            for (int x = 0; x < beyond.cols; ++x) {
                if (beyond(y, x) == 0) {
                    colours[static_cast<std::size_t>(nearest(y, x))] = surface_(y, x);
                }
            }
        }
        cv::Mat3f paper(beyond.size());
        std::ranges::transform(nearest, paper.begin(),
                               [&](int place) { return colours[static_cast<std::size_t>(place)]; });
        return paper;
    }

    /// What is not of the sheet, 255; empty where all is.
    [[nodiscard]] cv::Mat1b around() {
        if (part_ < kLeastPaper) {
            return {};
        }
        find_edges();
        beyond_ = cv::Mat1b(copy_.size(), uchar{0});
        for (std::size_t side = 0; side < kSides.size(); ++side) {
            if (edges_[side]) {
                fill_beyond(kSides[side], *edges_[side]);
            }
        }
        add_corners();
        add_holes();
        return cv::countNonZero(beyond_) > 0 ? beyond_ : cv::Mat1b();
    }

  private:
    /// A lid is grey; a bed of another colour lies on all sides, so that a band of a drawing is
    /// none.
    void find_edges() {
        for (std::size_t side = 0; side < kSides.size(); ++side) {
            edges_[side] = edge_of(kSides[side].of(paper_));
            if (edges_[side]) {
                edges_[side]->bed = bed_beyond(kSides[side].of(copy_), *edges_[side]);
            }
        }
        const auto is_like_first = [&](const std::optional<Edge>& edge) {
            return edge && edges_[0] && cv::norm(edge->bed - edges_[0]->bed) < kSameBed;
        };
        if (std::ranges::all_of(edges_, is_like_first)) {
            return;
        }
        for (std::optional<Edge>& edge : edges_) {
            if (edge && !is_grey(edge->bed)) {
                edge.reset();
            }
        }
    }

    void fill_beyond(const View& view, const Edge& edge) {
        const int rows = view.is_transposed ? copy_.cols : copy_.rows;
        std::vector<cv::Point> points;
        for (const cv::Point2d& at :
             {cv::Point2d(-1.0, -1.0), cv::Point2d(edge.at(-1.0) + kMargin_px, -1.0),
              cv::Point2d(edge.at(rows) + kMargin_px, rows), cv::Point2d(-1.0, rows)}) {
            const cv::Point2d back = view.back({std::max(-1.0, at.x), at.y}, copy_.size());
            points.emplace_back(cvRound(back.x), cvRound(back.y));
        }
        cv::fillConvexPoly(beyond_, points, cv::Scalar(255));
    }

    /// The bed that a rounded corner leaves free.
    void add_corners() {
        for (std::size_t side = 0; side < kSides.size(); ++side) {
            const auto& one = edges_[side];
            const auto& other = edges_[(side + 1) % kSides.size()];
            if (one && other) {
                add_corner(side, *one, *other);
            }
        }
    }

    void add_corner(std::size_t side, const Edge& one, const Edge& other) {
        // The corner, nearly: where one edge is as far from the frame as the other is.
        const bool is_far = side == 1 || side == 2;  // the next side lies at the view's far end
        const int rows = kSides[side].is_transposed ? copy_.cols : copy_.rows;
        const int next_rows = kSides[(side + 1) % 4].is_transposed ? copy_.cols : copy_.rows;
        const double across = other.at(side < 2 ? 0.0 : next_rows - 1.0);
        const double row = is_far ? rows - 1.0 - across : across;
        const cv::Point2d at = kSides[side].back({one.at(row), row}, copy_.size());
        const int reach = static_cast<int>(kCorner * std::min(copy_.cols, copy_.rows));
        const cv::Rect box =
            cv::Rect(cvRound(at.x) - reach, cvRound(at.y) - reach, 2 * reach + 1, 2 * reach + 1) &
            cv::Rect({}, copy_.size());
        if (box.empty()) {
            return;
        }
        const cv::Vec3f bed = 0.5F * (one.bed + other.bed);
        cv::Mat1b is_bed(box.size());
        for (int y = 0; y < box.height; ++y) {
            for (int x = 0; x < box.width; ++x) {
                const cv::Point p = box.tl() + cv::Point(x, y);
                is_bed(y, x) = paper_(p) == 0 && cv::norm(copy_(p) - bed) < kSameBed ? 255 : 0;
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
        const int margin = static_cast<int>(2.0 * kMargin_px) + 1;
        cv::dilate(grown, grown, cv::getStructuringElement(cv::MORPH_ELLIPSE, {margin, margin}));
        here |= grown;
    }

    struct Hole {
        cv::Rect box;
        cv::Point2d middle;
        double across_px = 0.0;
    };

    [[nodiscard]] std::vector<Hole> discs() const {
        cv::Mat1i label;
        cv::Mat1i stats;
        cv::Mat1d centres;
        const cv::Mat1b ink(~(paper_ | beyond_));
        const int n = cv::connectedComponentsWithStats(ink, label, stats, centres, 8, CV_32S);
        const double longer = std::max(copy_.cols, copy_.rows);
        std::vector<Hole> found;
        for (int i = 1; i < n; ++i) {
            const cv::Rect box(stats(i, cv::CC_STAT_LEFT), stats(i, cv::CC_STAT_TOP),
                               stats(i, cv::CC_STAT_WIDTH), stats(i, cv::CC_STAT_HEIGHT));
            const double across = 0.5 * (box.width + box.height);
            const double round =
                stats(i, cv::CC_STAT_AREA) / (0.25 * std::numbers::pi * box.width * box.height);
            if (across >= kLeastHole * longer && across <= kMostHole * longer &&
                std::abs(box.width - box.height) <= 0.1 * across + 1.0 && round > 0.9 &&
                round < 1.15) {
                found.push_back({box, {centres(i, 0), centres(i, 1)}, across});
            }
        }
        return found;
    }

    /// Where a hole lies beside a side of the sheet: along it from its middle, and from its edge.
    [[nodiscard]] cv::Point2d beside(std::size_t side, const Hole& hole) const {
        const View& view = kSides[side];
        const cv::Size size = view.is_transposed ? cv::Size(copy_.rows, copy_.cols) : copy_.size();
        const cv::Point2d at =
            view.is_transposed ? cv::Point2d(hole.middle.y, hole.middle.x) : hole.middle;
        const double in = view.is_flipped ? size.width - 1 - at.x : at.x;
        const auto depth = [&](std::size_t other, double row) {
            return edges_[other] ? std::max(0.0, edges_[other]->at(row)) : 0.0;
        };
        const std::size_t before = view.is_transposed ? 0 : 1;  // the sides that this one runs to
        const double middle = 0.5 * (size.height + depth(before, at.x) - depth(before + 2, at.x));
        return {at.y - middle, in - depth(side, at.y)};
    }

    /// Holes that a punch made: alike, in a row beside one side, even about its middle.
    void add_holes() {
        const std::vector<Hole> all = discs();
        for (std::size_t side = 0; side < kSides.size(); ++side) {
            const bool is_upright = !kSides[side].is_transposed;
            const double across = is_upright ? copy_.cols : copy_.rows;
            const double along = is_upright ? copy_.rows : copy_.cols;
            std::vector<Hole> row;
            double sum = 0.0;
            for (const Hole& hole : all) {
                const cv::Point2d at = beside(side, hole);
                if (at.y <= kHoleFromEdge * across) {
                    row.push_back(hole);
                    sum += at.x;
                }
            }
            if (row.size() < 2 || row.size() > kMostHoles) {
                continue;
            }
            const double first_px = beside(side, row.front()).y;
            const bool are_alike = std::ranges::all_of(row, [&](const Hole& hole) {
                return std::abs(hole.across_px - row.front().across_px) <=
                           kSameHole * row.front().across_px + 1.0 &&
                       std::abs(beside(side, hole).y - first_px) <= kInRow_px;
            });
            if (are_alike &&
                std::abs(sum) <= kEvenHoles * along * static_cast<double>(row.size())) {
                for (const Hole& hole : row) {
                    cv::circle(beyond_, cv::Point(hole.middle),
                               cvRound(0.5 * hole.across_px + kMargin_px + 1.0), cv::Scalar(255),
                               cv::FILLED);
                }
            }
        }
    }

    cv::Mat3f copy_;
    cv::Mat3f surface_;  // the paper's colour everywhere
    cv::Mat1b paper_;    // what is of that colour, 255
    double part_ = 0.0;  // of the picture that is paper
    std::array<std::optional<Edge>, 4> edges_;
    cv::Mat1b beyond_;
};

}  // namespace

cv::Mat within_sheet(const cv::Mat& picture) {
    if (picture.type() != CV_8UC3 || is_painted(picture)) {
        return picture;
    }
    Scan scan(picture);
    cv::Mat1b around = scan.around();
    if (around.empty()) {
        return picture;
    }
    cv::Mat paper;
    cv::resize(scan.paper_beside(around), paper, picture.size(), 0.0, 0.0, cv::INTER_LINEAR);
    paper.convertTo(paper, CV_8UC3);
    cv::resize(around, around, picture.size(), 0.0, 0.0, cv::INTER_NEAREST);
    cv::Mat within = picture.clone();
    paper.copyTo(within, around);
    return within;
}

}  // namespace touchline
