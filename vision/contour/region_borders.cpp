#include "vision/contour/region_borders.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline {
namespace {

// The gradient of a step between flat colours: a Gaussian's peak over sigma, with sigma about 1 px.
constexpr double kGradientOverStep = 0.4;
constexpr int kNone = -1;

/// A place where a line crosses from one pixel to the next, and its links on either side: other
/// crossings, or nodes (junctions) as -2 - index.
struct Crossing {
    EdgePoint point;
    std::array<int, 2> next{kNone, kNone};

    void link(int other) { next[next[0] == kNone ? 0 : 1] = other; }
};

class BorderTracer {
  public:
    BorderTracer(const cv::Mat1b& map, const LabPicture& lab, const std::vector<cv::Vec3f>& palette)
        : map_(map),
          lab_(lab),
          palette_(palette),
          right_(map.size(), kNone),
          below_(map.size(), kNone) {}

    std::vector<Chain> traced() {
        find_crossings();
        for (int y = 0; y + 1 < map_.rows; ++y) {
            for (int x = 0; x + 1 < map_.cols; ++x) {
                link_cell(y, x);
            }
        }
        is_used_.assign(crossings_.size(), false);
        std::vector<Chain> lines;
        for (const bool is_open : {true, false}) {  // first the open ones; the rest are rings
            for (std::size_t i = 0; i < crossings_.size(); ++i) {
                const bool is_end = crossings_[i].next[0] < 0 || crossings_[i].next[1] < 0;
                if (!is_used_[i] && is_end == is_open) {
                    lines.push_back(walked(static_cast<int>(i)));
                }
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
        constexpr float kSteep = 0.1F;  // a flatter course does not tell the place
        const float t =
            at_q - at_p > kSteep ? std::clamp((0.5F - at_p) / (at_q - at_p), 0.02F, 0.98F) : 0.5F;
        Crossing crossing;
        crossing.point.at = cv::Point2d(p) + static_cast<double>(t) * cv::Point2d(q - p);
        crossing.point.strength = kGradientOverStep * std::sqrt(static_cast<double>(square));
        crossings_.push_back(crossing);
        return static_cast<int>(crossings_.size()) - 1;
    }

    /// Links the crossings on the four sides of the cell whose upper left pixel is (x, y).
    void link_cell(int y, int x) {
        std::array<int, 4> around{right_(y, x), below_(y, x + 1), right_(y + 1, x), below_(y, x)};
        const auto n = std::ranges::count_if(around, [](int c) { return c != kNone; });
        if (n == 0) {
            return;
        }
        if (n == 2) {
            const auto a = std::ranges::find_if(around, [](int c) { return c != kNone; });
            const auto b = std::find_if(a + 1, around.end(), [](int c) { return c != kNone; });
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
        if (map_(y, x + 1) != map_(y + 1, x)) {
            return true;
        }
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
            if (c != kNone) {
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
        if (link < kNone) {
            line.points.push_back(nodes_[static_cast<std::size_t>(-2 - link)]);
        }
    }

    const Crossing& crossing(int i) const { return crossings_[static_cast<std::size_t>(i)]; }

    const cv::Mat1b& map_;
    const LabPicture& lab_;
    const std::vector<cv::Vec3f>& palette_;
    cv::Mat1i right_;  // crossing between a pixel and the next one, or kNone
    cv::Mat1i below_;
    std::vector<Crossing> crossings_;
    std::vector<EdgePoint> nodes_;
    std::vector<bool> is_used_;
};

}  // namespace

std::vector<Chain> region_borders(const cv::Mat1b& map, const LabPicture& lab,
                                  const std::vector<cv::Vec3f>& palette) {
    return BorderTracer(map, lab, palette).traced();
}

}  // namespace touchline
