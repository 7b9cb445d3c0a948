#include "vision/contour/iso_rings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace touchline {
namespace {

/// The sides of a cell of four elements: above, right, below, left.
enum Side : std::size_t { kAbove, kRight, kBelow, kLeft };

class RingTracer {
  public:
    RingTracer(const cv::Mat1f& values, float level)
        : values_(values), level_(level), is_done_(values.rows + 1, values.cols + 1, uchar{0}) {}

    /// Every ring runs round an element that is high with a low one to its left or right, so it
    /// passes a cell's upper side on its way up or down. It begins where it comes up.
    std::vector<Chain> trace() {
        std::vector<Chain> rings;
        for (int y = 0; y <= values_.rows; ++y) {
            for (int x = 0; x <= values_.cols; ++x) {
                if (!is_high(x - 1, y - 1) && is_high(x, y - 1) && is_done_(y, x) == 0) {
                    rings.push_back(ring_from({x, y}));
                }
            }
        }
        return rings;
    }

  private:
    float value(int x, int y) const {
        const bool is_inside = x >= 0 && y >= 0 && x < values_.cols && y < values_.rows;
        return is_inside ? values_(y, x) : -std::numeric_limits<float>::infinity();
    }

    bool is_high(int x, int y) const { return value(x, y) >= level_; }

    /// Cell (x, y) has the elements x-1, x and y-1, y. The ring leaves it by its upper side; this
    /// follows it, high on the right, until it comes round.
    Chain ring_from(cv::Point cell) {
        Chain ring{{}, true};
        Side out = kAbove;
        do {
            is_done_(cell) |= out == kAbove ? 1 : 0;
            ring.points.push_back({crossing(cell, out)});
            cell = across(cell, out);
            out = way_out(cell, static_cast<Side>((out + 2) % 4));
        } while (out != kAbove || is_done_(cell) == 0);
        return ring;
    }

    static cv::Point across(cv::Point cell, Side side) {
        constexpr std::array<std::array<int, 2>, 4> kStep{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
        return cell + cv::Point(kStep[side][0], kStep[side][1]);
    }

    /// Returns the elements at a side's ends, clockwise round the cell.
    static std::array<cv::Point, 2> ends(cv::Point cell, Side side) {
        const std::array<cv::Point, 4> corners{cell - cv::Point(1, 1), cell - cv::Point(0, 1), cell,
                                               cell - cv::Point(1, 0)};
        return {corners[side], corners[(side + 1U) % 4U]};
    }

    /// A side through which the ring may leave has first a low element, then a high one. Of two
    /// such sides (high ones across a corner), returns the first to the right, which keeps the high
    /// ones apart.
    Side way_out(cv::Point cell, Side in) const {
        for (const std::size_t turn : {3U, 2U}) {
            const Side side = static_cast<Side>((in + turn) % 4);
            if (is_way_out(cell, side)) {
                return side;
            }
        }
        return static_cast<Side>((in + 1) % 4);
    }

    bool is_way_out(cv::Point cell, Side side) const {
        const auto [first, second] = ends(cell, side);
        return !is_high(first.x, first.y) && is_high(second.x, second.y);
    }

    cv::Point2d crossing(cv::Point cell, Side side) const {
        const auto [low, high] = ends(cell, side);
        const double below = static_cast<double>(level_ - value(low.x, low.y));
        const double step = static_cast<double>(value(high.x, high.y) - value(low.x, low.y));
        const double t = std::isfinite(step) ? below / step : 0.5;
        return cv::Point2d(low) + t * cv::Point2d(high - low);
    }

    const cv::Mat1f& values_;
    float level_;
    cv::Mat1b is_done_;  // for each cell: a ring has left through its upper side
};

}  // namespace

std::vector<Chain> iso_rings(const cv::Mat1f& values, float level) {
    return RingTracer(values, level).trace();
}

double area_within(const Chain& ring) {
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
        twice += ring.points[i].at.cross(ring.points[(i + 1) % ring.points.size()].at);
    }
    return 0.5 * twice;
}

}  // namespace touchline
