#include "vision/contour/rings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace touchline {
namespace {

/// The sides of a cell of four elements: above, right, below, left.
enum Side : std::size_t { side_above, side_right, side_below, side_left };

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
        Side out = side_above;
        do {
            is_done_(cell) |= out == side_above ? 1 : 0;
            ring.points.push_back({crossing(cell, out)});
            cell = across(cell, out);
            out = way_out(cell, static_cast<Side>((out + 2) % 4));
        } while (out != side_above || is_done_(cell) == 0);
        return ring;
    }

    static cv::Point across(cv::Point cell, Side side) {
        constexpr std::array<std::array<int, 2>, 4> side_steps{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
        return cell + cv::Point(side_steps[side][0], side_steps[side][1]);
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
            if (is_way_out(cell, side)) return side;
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

constexpr int no_link = -1;

/// A place where a line crosses from one pixel to the next, and its links on either side: other
/// crossings, or nodes (junctions) as -2 - index.
struct BorderCrossing {
    EdgePoint point;
    std::array<int, 2> next{no_link, no_link};

    void link(int other) { next[next[0] == no_link ? 0 : 1] = other; }
};

class BorderTracer {
  public:
    BorderTracer(const cv::Mat1b& map, const LabPicture& lab, const std::vector<cv::Vec3f>& palette)
        : map_(map),
          lab_(lab),
          palette_(palette),
          right_(map.size(), no_link),
          below_(map.size(), no_link) {}

    std::vector<Chain> traced() {
        find_crossings();
        for (int y = 0; y + 1 < map_.rows; ++y) {
            for (int x = 0; x + 1 < map_.cols; ++x) link_cell(y, x);
        }
        is_used_.assign(crossings_.size(), false);
        std::vector<Chain> lines;
        for (const bool is_open : {true, false}) {  // first the open ones; the rest are rings
            for (std::size_t i = 0; i < crossings_.size(); ++i) {
                const bool is_end = crossings_[i].next[0] < 0 || crossings_[i].next[1] < 0;
                if (!is_used_[i] && is_end == is_open) lines.push_back(walked(static_cast<int>(i)));
            }
        }
        return lines;
    }

  private:
    void find_crossings() {
        for (int y = 0; y < map_.rows; ++y) {
            for (int x = 0; x < map_.cols; ++x) {
                if (x + 1 < map_.cols && map_(y, x) != map_(y, x + 1)) {
                    right_(y, x) = add({x, y}, {x + 1, y});
                }
                if (y + 1 < map_.rows && map_(y, x) != map_(y + 1, x)) {
                    below_(y, x) = add({x, y}, {x, y + 1});
                }
            }
        }
    }

    int add(cv::Point p, cv::Point q) {
        const cv::Vec3f& from = palette_[map_(p)];
        const cv::Vec3f step = palette_[map_(q)] - from;
        const float square = step.dot(step);
        const float at_p = (lab_(p) - from).dot(step) / square;
        const float at_q = (lab_(q) - from).dot(step) / square;
        constexpr float steep = 0.1F;  // a flatter course does not tell the place
        const float t =
            at_q - at_p > steep ? std::clamp((0.5F - at_p) / (at_q - at_p), 0.02F, 0.98F) : 0.5F;
        BorderCrossing crossing;
        crossing.point.at = cv::Point2d(p) + static_cast<double>(t) * cv::Point2d(q - p);
        crossing.point.strength = gradient_over_step * std::sqrt(static_cast<double>(square));
        crossings_.push_back(crossing);
        return static_cast<int>(crossings_.size()) - 1;
    }

    /// Links the crossings on the four sides of the cell whose upper left pixel is (x, y).
    void link_cell(int y, int x) {
        std::array<int, 4> around{right_(y, x), below_(y, x + 1), right_(y + 1, x), below_(y, x)};
        const auto n = std::ranges::count_if(around, [](int c) { return c != no_link; });
        if (n == 0) return;
        if (n == 2) {
            const auto a = std::ranges::find_if(around, [](int c) { return c != no_link; });
            const auto b = std::find_if(a + 1, around.end(), [](int c) { return c != no_link; });
            link(*a, *b);
            return;
        }
        if (n == 4 && map_(y, x) == map_(y + 1, x + 1) && is_diagonal_joined(y, x)) {
            link(around[0], around[1]);
            link(around[2], around[3]);
        } else if (n == 4 && map_(y, x + 1) == map_(y + 1, x)) {
            link(around[0], around[3]);
            link(around[1], around[2]);
        } else {
            add_junction(around);
        }
    }

    /// Returns whether the colour of the upper left and lower right pixel runs through between the
    /// other two: if those differ, yes; else if the middle of the cell looks more like it.
    bool is_diagonal_joined(int y, int x) const {
        if (map_(y, x + 1) != map_(y + 1, x)) return true;
        const cv::Vec3f middle =
            0.25F * (lab_(y, x) + lab_(y, x + 1) + lab_(y + 1, x) + lab_(y + 1, x + 1));
        const cv::Vec3f to_own = middle - palette_[map_(y, x)];
        const cv::Vec3f to_other = middle - palette_[map_(y, x + 1)];
        return to_own.dot(to_own) <= to_other.dot(to_other);
    }

    void link(int a, int b) {
        crossings_[static_cast<std::size_t>(a)].link(b);
        crossings_[static_cast<std::size_t>(b)].link(a);
    }

    void add_junction(const std::array<int, 4>& around) {
        EdgePoint junction;
        junction.is_fixed = true;
        int n = 0;
        for (const int c : around) {
            if (c != no_link) {
                const EdgePoint& point = crossings_[static_cast<std::size_t>(c)].point;
                junction.at += point.at;
                junction.strength = std::max(junction.strength, point.strength);
                crossings_[static_cast<std::size_t>(c)].link(-2 - static_cast<int>(nodes_.size()));
                ++n;
            }
        }
        junction.at *= 1.0 / n;
        nodes_.push_back(junction);
    }

    /// Walks from a crossing along its links to the next junction, the frame, or round to itself.
    Chain walked(int start) {
        Chain line;
        int here = start;
        std::size_t entry = crossing(here).next[1] < 0 ? 1 : 0;
        add_node(crossing(here).next[entry], line);
        while (!is_used_[static_cast<std::size_t>(here)]) {
            is_used_[static_cast<std::size_t>(here)] = true;
            line.points.push_back(crossing(here).point);
            const int next = crossing(here).next[1 - entry];
            if (next < 0) {
                add_node(next, line);
                return line;
            }
            entry = crossing(next).next[0] == here ? 0 : 1;
            here = next;
        }
        line.is_closed = true;
        return line;
    }

    void add_node(int link, Chain& line) const {
        if (link < no_link) line.points.push_back(nodes_[static_cast<std::size_t>(-2 - link)]);
    }

    const BorderCrossing& crossing(int i) const { return crossings_[static_cast<std::size_t>(i)]; }

    const cv::Mat1b& map_;
    const LabPicture& lab_;
    const std::vector<cv::Vec3f>& palette_;
    cv::Mat1i right_;  // crossing between a pixel and the next one, or no_link
    cv::Mat1i below_;
    std::vector<BorderCrossing> crossings_;
    std::vector<EdgePoint> nodes_;
    std::vector<bool> is_used_;
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

bool holds(const Chain& ring, const cv::Point2d& at) {
    std::vector<cv::Point2f> points;
    for (const EdgePoint& point : ring.points) points.emplace_back(point.at);
    return cv::pointPolygonTest(points, at, false) > 0.0;
}

float strength_at(const cv::Mat1f& strength, const cv::Point2d& at) {
    const cv::Point p(cvRound(at.x), cvRound(at.y));
    return cv::Rect({}, strength.size()).contains(p) ? strength(p) : 0.0F;
}

bool is_on_frame(const cv::Point2d& at, cv::Size size) {
    return at.x < 1.0 || at.y < 1.0 || at.x > size.width - 2.0 || at.y > size.height - 2.0;
}

void snap(Chain& ring, const cv::Mat1f& strength, double reach_px) {
    const auto n = static_cast<int>(ring.points.size());
    const auto at = [&](int i) {
        return ring.points[static_cast<std::size_t>((i % n + n) % n)].at;
    };
    std::vector<double> offset(ring.points.size(), 0.0);
    std::vector<cv::Point2d> normal(ring.points.size());
    for (int i = 0; i < n; ++i) {
        const cv::Point2d along = at(i + 3) - at(i - 3);
        const double length = std::max(1e-9, cv::norm(along));
        const auto k = static_cast<std::size_t>(i);
        normal[k] = {-along.y / length, along.x / length};
        double best = 0.0;
        for (double d = -reach_px; d <= reach_px && !is_on_frame(at(i), strength.size());
             d += 0.5) {
            const double near = std::exp(-0.5 * d * d / (0.25 * reach_px * reach_px));
            const double value =
                near * static_cast<double>(strength_at(strength, at(i) + d * normal[k]));
            if (value > best) {
                best = value;
                offset[k] = d;
            }
        }
    }
    constexpr int agree = 7;  // points, of which the median is taken
    for (int i = 0; i < n; ++i) {
        std::array<double, agree> around{};
        for (int k = 0; k < agree; ++k) {
            around[static_cast<std::size_t>(k)] =
                offset[static_cast<std::size_t>((i + k - agree / 2 + n) % n)];
        }
        std::ranges::nth_element(around, around.begin() + agree / 2);
        const auto k = static_cast<std::size_t>(i);
        ring.points[k].at += around[agree / 2] * normal[k];
    }
}

std::vector<Chain> region_borders(const cv::Mat1b& map, const LabPicture& lab,
                                  const std::vector<cv::Vec3f>& palette) {
    return BorderTracer(map, lab, palette).traced();
}

}  // namespace touchline
