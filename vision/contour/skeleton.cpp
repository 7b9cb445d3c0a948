#include "vision/contour/skeleton.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <limits>

namespace touchline {
namespace {

constexpr float steps_per_pixel = 8.0F;  // of depth

/// Whether a pixel may go, by its eight neighbours (bit k: neighbour k, round the pixel, even bits
/// beside it): it is not an end, and its neighbours stay connected without it (Yokoi's number is
/// 1).
constexpr std::array<bool, 256> removable_table() {
    std::array<bool, 256> table{};
    for (unsigned code = 0; code < 256; ++code) {
        const auto empty = [&](unsigned k) { return (code >> (k % 8U) & 1U) == 0U ? 1 : 0; };
        int parts = 0;
        for (unsigned k = 0; k < 8; k += 2) {
            parts += empty(k) - empty(k) * empty(k + 1) * empty(k + 2);
        }
        table[code] = parts == 1 && std::popcount(code) >= 2;
    }
    return table;
}

constexpr std::array<bool, 256> removable = removable_table();

class Thinning {
  public:
    Thinning(const cv::Mat1b& mask, const cv::Mat1f& depth)
        : width_(mask.cols + 2),
          around_{1, 1 - width_, -width_, -1 - width_, -1, width_ - 1, width_, width_ + 1},
          inside_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(mask.rows + 2), 0),
          level_(inside_.size(), 0) {
        for (int y = 0; y < mask.rows; ++y) {
            for (int x = 0; x < mask.cols; ++x) {
                if (mask(y, x) != 0) {
                    add(static_cast<std::size_t>((y + 1) * width_ + x + 1), depth(y, x));
                }
            }
        }
    }

    /// Goes level by level, from the four sides in turn: going from one side only would remove a
    /// line that is two pixels wide from its end.
    void peel() {
        for (std::size_t level = 0; level < queues_.size(); ++level) {
            std::vector<std::size_t> asked = std::move(queues_[level]);
            while (!asked.empty()) {
                std::vector<std::size_t> again;
                for (const std::size_t side : {2U, 6U, 0U, 4U}) {
                    peel_side(asked, side, static_cast<int>(level), again);
                }
                asked = std::move(again);
            }
        }
    }

    [[nodiscard]] cv::Mat1b rest(cv::Size size) const {
        cv::Mat1b kept(size);
        for (int y = 0; y < size.height; ++y) {
            const auto row = inside_.begin() + (y + 1) * width_ + 1;
            std::copy(row, row + size.width, kept[y]);
        }
        return kept;
    }

  private:
    void add(std::size_t p, float depth) {
        const auto level = static_cast<std::size_t>(depth * steps_per_pixel);
        if (queues_.size() <= level) queues_.resize(level + 1);
        inside_[p] = 255;
        level_[p] = static_cast<int>(level);
        queues_[level].push_back(p);
    }

    [[nodiscard]] std::size_t neighbour(std::size_t p, std::size_t k) const {
        return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(p) + around_[k]);
    }

    [[nodiscard]] unsigned code_of(std::size_t p) const {
        unsigned code = 0;
        for (std::size_t k = 0; k < 8; ++k) code |= (inside_[neighbour(p, k)] & 1U) << k;
        return code;
    }

    /// Removes what now lies open to that side, if it may go; its neighbours are checked again.
    void peel_side(const std::vector<std::size_t>& asked, std::size_t side, int level,
                   std::vector<std::size_t>& again) {
        std::vector<std::size_t> open;
        std::ranges::copy_if(asked, std::back_inserter(open), [&](std::size_t p) {
            return inside_[p] != 0 && inside_[neighbour(p, side)] == 0;
        });
        for (const std::size_t p : open) {
            if (inside_[p] == 0 || !removable[code_of(p)]) continue;
            inside_[p] = 0;
            for (std::size_t k = 0; k < 8; ++k) {
                const std::size_t q = neighbour(p, k);
                if (inside_[q] != 0 && level_[q] <= level) again.push_back(q);
            }
        }
    }

    int width_;  // of a row with its frame
    std::array<int, 8> around_;
    std::vector<unsigned char> inside_;
    std::vector<int> level_;
    std::vector<std::vector<std::size_t>> queues_;  // by depth
};

constexpr std::size_t no_node = std::numeric_limits<std::size_t>::max();
constexpr double spur_over_width = 0.8;
constexpr double bridge_over_width = 1.0;
constexpr double loop_over_width = 1.5;

struct Arm {
    std::vector<cv::Point> pixels;
    std::size_t from = no_node;  // node, or free
    std::size_t to = no_node;
    bool is_closed = false;
    bool is_dropped = false;
};

struct Node {
    cv::Point2d sum;
    double count = 0.0;  // pixels
    double depth = 0.0;  // greatest
    std::size_t merged_into = no_node;

    [[nodiscard]] cv::Point2d centre() const { return sum / count; }
};

class Tracer {
  public:
    Tracer(const cv::Mat1b& thin, const cv::Mat1f& depth)
        : depth_(depth), frame_({}, thin.size()), left_(thin.clone()), node_(thin.size(), -1) {
        find_nodes(thin);
        trace_arms();
    }

    Skeleton cleaned() {
        merge_bridged();
        drop_spurs();
        return skeleton();
    }

  private:
    template <class Visit>
    void around(const cv::Point& p, Visit&& visit) const {
        constexpr std::array<std::array<int, 2>, 8> neighbour_steps{
            {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
        for (const auto& [x, y] : neighbour_steps) {
            const cv::Point q(p.x + x, p.y + y);
            if (frame_.contains(q)) visit(q);
        }
    }

    /// Finds pixels with three neighbours or more, in clusters.
    void find_nodes(const cv::Mat1b& thin) {
        std::vector<cv::Point> branches;
        for (int y = 0; y < thin.rows; ++y) {
            for (int x = 0; x < thin.cols; ++x) {
                if (thin(y, x) == 0) continue;
                pixels_.emplace_back(x, y);
                int n = 0;
                around({x, y}, [&](const cv::Point& q) { n += thin(q) != 0 ? 1 : 0; });
                if (n >= 3) {
                    left_(y, x) = 0;
                    branches.emplace_back(x, y);
                    node_(y, x) = unnumbered;
                }
            }
        }
        for (const cv::Point& seed : branches) {
            if (node_(seed) == unnumbered) number_cluster(seed);
        }
    }

    void number_cluster(const cv::Point& seed) {
        const auto number = static_cast<int>(nodes_.size());
        nodes_.emplace_back();
        std::vector<cv::Point> cluster{seed};
        node_(seed) = number;
        for (std::size_t i = 0; i < cluster.size(); ++i) {
            const cv::Point p = cluster[i];
            nodes_.back().sum += cv::Point2d(p);
            nodes_.back().count += 1.0;
            nodes_.back().depth = std::max(nodes_.back().depth, static_cast<double>(depth_(p)));
            around(p, [&](const cv::Point& q) {
                if (node_(q) == unnumbered) {
                    node_(q) = number;
                    cluster.push_back(q);
                }
            });
        }
    }

    /// Traces arms from nodes, then from free ends, then round what is left.
    void trace_arms() {
        for (const cv::Point& p : pixels_) {
            if (node_(p) >= 0) {
                around(p, [&](const cv::Point& q) {
                    if (left_(q) != 0) walk(q, static_cast<std::size_t>(node_(p)));
                });
            }
        }
        for (const bool is_open : {true, false}) {
            for (const cv::Point& p : pixels_) {
                int n = 0;
                around(p, [&](const cv::Point& q) { n += left_(q) != 0 ? 1 : 0; });
                if (left_(p) != 0 && (n <= 1) == is_open) walk(p, no_node);
            }
        }
    }

    void walk(cv::Point here, std::size_t from) {
        Arm arm;
        arm.from = from;
        const cv::Point start = here;
        for (bool is_going = true; is_going;) {
            left_(here) = 0;
            arm.pixels.push_back(here);
            is_going = false;
            cv::Point next;
            int node = -1;
            bool is_at_start = false;
            around(here, [&](const cv::Point& q) {
                if (left_(q) != 0 && !is_going) {
                    is_going = true;
                    next = q;
                }
                const bool is_back = arm.pixels.size() == 1 && node_(q) >= 0 &&
                                     static_cast<std::size_t>(node_(q)) == from;
                node = node_(q) >= 0 && !is_back ? node_(q) : node;
                is_at_start = is_at_start || (q == start && arm.pixels.size() > 2);
            });
            if (node >= 0) {
                arm.to = static_cast<std::size_t>(node);
                is_going = false;
            }
            arm.is_closed = !is_going && from == no_node && node < 0 && is_at_start;
            here = next;
        }
        arms_.push_back(std::move(arm));
    }

    std::size_t root(std::size_t node) const {
        while (node != no_node && nodes_[node].merged_into != no_node)
            node = nodes_[node].merged_into;
        return node;
    }

    double length(const Arm& arm) const {
        double sum = 0.0;
        for (std::size_t i = 1; i < arm.pixels.size(); ++i) {
            sum += cv::norm(cv::Point2d(arm.pixels[i] - arm.pixels[i - 1]));
        }
        if (arm.from != no_node) sum += distance(nodes_[arm.from].centre(), arm.pixels.front());
        return arm.to != no_node ? sum + distance(nodes_[arm.to].centre(), arm.pixels.back()) : sum;
    }

    void merge_bridged() {
        for (Arm& arm : arms_) {
            if (arm.from == no_node || arm.to == no_node) continue;
            const std::size_t a = root(arm.from);
            const std::size_t b = root(arm.to);
            const double width_px = nodes_[a].depth + nodes_[b].depth;
            const double limit = (a == b ? loop_over_width : bridge_over_width) * width_px;
            // The nodes as they are now: many short bridges in a row do not make one node.
            const bool is_far = a != b && distance(nodes_[a].centre(), nodes_[b].centre()) > limit;
            if (length(arm) > limit || is_far) continue;
            arm.is_dropped = true;
            if (a != b) {
                nodes_[std::max(a, b)].merged_into = std::min(a, b);
                Node& kept = nodes_[std::min(a, b)];
                const Node& gone = nodes_[std::max(a, b)];
                kept.sum += gone.sum;
                kept.count += gone.count;
                kept.depth = std::max(kept.depth, gone.depth);
            }
        }
    }

    /// Drops all bumps of a node at once, if something longer is left there.
    void drop_spurs() {
        std::vector<std::vector<std::size_t>> spurs(nodes_.size());
        std::vector<int> others(nodes_.size(), 0);
        for (std::size_t i = 0; i < arms_.size(); ++i) {
            const Arm& arm = arms_[i];
            if (arm.is_dropped || (arm.from == no_node && arm.to == no_node)) continue;
            const bool is_free = arm.from == no_node || arm.to == no_node;
            const std::size_t node = root(arm.from != no_node ? arm.from : arm.to);
            if (is_free && length(arm) < spur_over_width * 2.0 * nodes_[node].depth + 0.5) {
                spurs[node].push_back(i);
            } else {
                ++others[node];
                others[root(is_free ? node : arm.to)] += is_free ? 0 : 1;
            }
        }
        for (std::size_t node = 0; node < nodes_.size(); ++node) {
            for (const std::size_t i : spurs[node]) arms_[i].is_dropped = others[node] > 0;
        }
    }

    Skeleton skeleton() const {
        Skeleton made;
        std::vector<std::vector<EndId>> ends(nodes_.size());
        for (const Arm& arm : arms_) {
            if (arm.is_dropped) continue;
            const std::size_t i = made.arms.size();
            made.arms.emplace_back();
            Chain& chain = made.arms.back();
            chain.is_closed = arm.is_closed;
            if (arm.from != no_node) {
                chain.points.push_back({nodes_[root(arm.from)].centre()});
                ends[root(arm.from)].push_back(front_of(i));
            }
            for (const cv::Point& p : arm.pixels) chain.points.push_back({cv::Point2d(p)});
            if (arm.to != no_node) {
                chain.points.push_back({nodes_[root(arm.to)].centre()});
                ends[root(arm.to)].push_back(back_of(i));
            }
        }
        for (std::vector<EndId>& node : ends) {
            if (node.size() >= 2) made.nodes.push_back(std::move(node));
        }
        return made;
    }

    static constexpr int unnumbered = std::numeric_limits<int>::max();

    const cv::Mat1f& depth_;
    cv::Rect frame_;
    cv::Mat1b left_;  // pixels of arms not walked yet
    cv::Mat1i node_;  // number of the node that a pixel belongs to, or -1
    std::vector<cv::Point> pixels_;
    std::vector<Node> nodes_;
    std::vector<Arm> arms_;
};

}  // namespace

cv::Mat1b thinned(const cv::Mat1b& mask, const cv::Mat1f& depth) {
    Thinning thinning(mask, depth);
    thinning.peel();
    return thinning.rest(mask.size());
}

Skeleton skeleton_of(const cv::Mat1b& thin, const cv::Mat1f& depth) {
    return Tracer(thin, depth).cleaned();
}

}  // namespace touchline
