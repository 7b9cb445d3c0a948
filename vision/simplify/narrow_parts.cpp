#include "vision/contour/junctions.h"
#include "vision/contour/rings.h"
#include "vision/contour/skeleton.h"
#include "vision/simplify/shaping.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double least_cell_mm = 0.2;
constexpr double pin_reach_cells = 3.0;

/// Returns the distance of every cell in a mask to the nearest one outside, in cells.
cv::Mat1f distances(const cv::Mat& mask) {
    cv::Mat1f result;
    cv::distanceTransform(mask, result, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return result;
}

/// Cells over a ring; masks are 255 inside.
class Raster {
  public:
    Raster(const Chain& ring, double gap_mm)
        : cell_mm_(std::max(gap_mm / 32.0, least_cell_mm)),
          radius_cells_(0.5 * gap_mm / cell_mm_),
          rim_(static_cast<int>(std::ceil(2.0 * radius_cells_)) + 2) {
        cv::Point2d high = ring.points.front().at;
        low_ = high;
        for (const EdgePoint& p : ring.points) {
            low_ = {std::min(low_.x, p.at.x), std::min(low_.y, p.at.y)};
            high = {std::max(high.x, p.at.x), std::max(high.y, p.at.y)};
        }
        size_ = {static_cast<int>((high.x - low_.x) / cell_mm_) + 2 * rim_ + 1,
                 static_cast<int>((high.y - low_.y) / cell_mm_) + 2 * rim_ + 1};
    }

    cv::Mat filled(const Chain& ring) const {
        constexpr int fixed_point_bits = 8;
        std::vector<cv::Point> corners;
        for (const EdgePoint& p : ring.points) {
            const cv::Point2d at =
                ((p.at - low_) / cell_mm_ + cv::Point2d(rim_, rim_)) * (1 << fixed_point_bits);
            corners.emplace_back(static_cast<int>(std::lround(at.x)),
                                 static_cast<int>(std::lround(at.y)));
        }
        cv::Mat1b mask(size_, uchar{0});
        cv::fillPoly(mask, std::vector{corners}, cv::Scalar(255), cv::LINE_8, fixed_point_bits);
        return mask;
    }

    /// Takes away what is narrower than a gap, but keeps what is no deeper than a gap if asked to.
    cv::Mat opened(const cv::Mat& mask, bool keeps_shallow) const {
        const cv::Mat core = distances(mask) > radius_cells_;
        if (cv::countNonZero(core) == 0) return cv::Mat1b(mask.size(), uchar{0});
        const cv::Mat1f from_core = distances(255 - core);
        const cv::Mat bold = from_core <= radius_cells_;
        const cv::Mat narrow = mask & (255 - bold);
        return keeps_shallow ? mask & (bold | shallow(narrow, from_core)) : mask & bold;
    }

    cv::Mat closed(const cv::Mat& mask, bool keeps_shallow) const {
        return 255 - opened(255 - mask, keeps_shallow);
    }

    /// Returns outlines round a mask and its holes, in millimetres.
    std::vector<Chain> outlines(const cv::Mat& mask) const {
        cv::Mat1f soft;
        mask.convertTo(soft, CV_32F, 1.0 / 255.0);
        cv::GaussianBlur(soft, soft, {}, 1.0);
        return in_mm(iso_rings(soft, 0.5F));
    }

    /// Returns the middle lines of a mask's pieces, in millimetres; lines that go on through their
    /// junctions are one.
    std::vector<Chain> middle_lines(const cv::Mat& mask) const {
        const cv::Mat1f depth = distances(mask);
        Skeleton skeleton = skeleton_of(thinned(mask, depth), depth);
        JunctionSet junctions(radius_cells_, 2.0 * radius_cells_);
        for (const std::vector<EndId>& ends : skeleton.nodes) {
            if (ends.size() == 2) {
                junctions.add_joint(ends[0], ends[1]);
                continue;
            }
            junctions.add_cluster(ends, point_at(skeleton.arms, ends[0]).at);
        }
        return in_mm(junctions.assembled(std::move(skeleton.arms)));
    }

    double pin_reach_mm() const { return pin_reach_cells * cell_mm_; }

  private:
    std::vector<Chain> in_mm(std::vector<Chain> lines) const {
        for (Chain& line : lines) {
            for (EdgePoint& p : line.points) {
                p.at = low_ + (p.at - cv::Point2d(rim_, rim_)) * cell_mm_;
                p.is_fixed = false;
            }
        }
        return lines;
    }

    /// Returns the pieces of a mask that reach no further than a gap beyond what is bold.
    cv::Mat shallow(const cv::Mat& narrow, const cv::Mat1f& from_core) const {
        cv::Mat1i piece;
        const int pieces = cv::connectedComponents(narrow, piece, 8, CV_32S);
        std::vector<double> reach(static_cast<std::size_t>(pieces), 0.0);
        for (auto [p, r] = std::pair(piece.begin(), from_core.begin()); p != piece.end();
             ++p, ++r) {
            double& most = reach[static_cast<std::size_t>(*p)];
            most = std::max(most, static_cast<double>(*r));
        }
        cv::Mat1b result(narrow.size(), uchar{0});
        auto out = result.begin();
        for (const int p : piece) {
            const bool is_kept = p > 0 && reach[static_cast<std::size_t>(p)] <= 3.0 * radius_cells_;
            *out++ = is_kept ? 255 : 0;
        }
        return result;
    }

    double cell_mm_;
    double radius_cells_;
    int rim_;
    cv::Point2d low_;
    cv::Size size_;
};

/// The points of a line, which must outlive it, for queries of the nearest.
class Points {
  public:
    Points(const Chain& line, double cell_mm) : line_(line), grid_({line}, extent(line), cell_mm) {}

    /// Returns the index of the nearest point within reach.
    std::optional<std::size_t> nearest(cv::Point2d p, double reach_mm) const {
        std::optional<std::size_t> best;
        double least_mm = reach_mm;
        grid_.near(p, reach_mm, [&](const PointRef& ref) {
            const double apart_mm = distance(line_.points[ref.index].at, p);
            if (apart_mm < least_mm) {
                least_mm = apart_mm;
                best = ref.index;
            }
        });
        return best;
    }

  private:
    static cv::Size extent(const Chain& line) {
        cv::Size size(1, 1);
        for (const EdgePoint& p : line.points) {
            size.width = std::max(size.width, static_cast<int>(std::ceil(p.at.x)));
            size.height = std::max(size.height, static_cast<int>(std::ceil(p.at.y)));
        }
        return size;
    }

    const Chain& line_;
    PointGrid grid_;
};

/// Returns the line with strengths and fixed points of the ring that it came from.
Chain with_points_of(const Chain& ring, const Points& of_ring, double gap_mm, double pin_reach_mm,
                     Chain line) {
    for (EdgePoint& p : line.points) {
        const auto near = of_ring.nearest(p.at, gap_mm);
        p.strength = ring.points[near.value_or(0)].strength;
    }
    const Points of_line(line, gap_mm);
    for (const EdgePoint& corner : ring.points) {
        if (corner.is_fixed) {
            if (const auto near = of_line.nearest(corner.at, pin_reach_mm)) {
                line.points[*near] = corner;
            }
        }
    }
    return line;
}

}  // namespace

std::vector<Chain> parted_where_narrow(const Chain& ring, double gap_mm, Narrow first) {
    const Raster raster(ring, gap_mm);
    const cv::Mat mask = raster.filled(ring);
    const cv::Mat start = first == Narrow::parts ? mask : raster.closed(mask, false);
    const cv::Mat bold = raster.opened(start, true);
    const cv::Mat full = first == Narrow::parts ? raster.closed(bold, true) : bold;
    std::vector<Chain> lines = raster.outlines(full);
    for (const cv::Mat& narrow : {cv::Mat(start - bold), cv::Mat(full - bold)}) {
        std::ranges::move(raster.middle_lines(narrow), std::back_inserter(lines));
    }
    std::ranges::stable_sort(lines, [](const Chain& a, const Chain& b) {
        return std::pair(a.is_closed, length_of(a)) > std::pair(b.is_closed, length_of(b));
    });
    const Points of_ring(ring, gap_mm);
    for (Chain& line : lines) {
        line = with_points_of(ring, of_ring, gap_mm, raster.pin_reach_mm(), std::move(line));
    }
    return lines;
}

}  // namespace touchline
