#include "tests/vision/boundary/boundary_score.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace touchline::testing {
namespace {

constexpr double reach_over_diagonal = 0.0075;
constexpr int no_partner = -1;

using Neighbours = std::array<bool, 8>;  // clockwise from above

Neighbours neighbours(const cv::Mat1b& map, cv::Point at) {
    constexpr std::array<std::array<int, 2>, 8> neighbour_steps{
        {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};
    Neighbours n{};
    for (std::size_t i = 0; i < n.size(); ++i) {
        n[i] = map(at.y + neighbour_steps[i][1], at.x + neighbour_steps[i][0]) != 0;
    }
    return n;
}

/// Guo and Hall's conditions: one run of neighbours, not an end, and on this pass's side.
bool may_go(const Neighbours& n, bool is_first_pass) {
    int runs = 0;
    int pairs_a = 0;
    int pairs_b = 0;
    for (std::size_t i = 0; i < 8; i += 2) {
        runs += !n[i] && (n[i + 1] || n[(i + 2) % 8]) ? 1 : 0;
        pairs_a += n[(i + 7) % 8] || n[i] ? 1 : 0;
        pairs_b += n[i] || n[i + 1] ? 1 : 0;
    }
    const int fewest = std::min(pairs_a, pairs_b);
    const bool is_other_side =
        is_first_pass ? (n[4] || n[5] || !n[7]) && n[6] : (n[0] || n[1] || !n[3]) && n[2];
    return runs == 1 && fewest >= 2 && fewest <= 3 && !is_other_side;
}

/// Removes at once everything that a pass may remove. Returns whether there was anything.
bool thin_once(cv::Mat1b& map, std::vector<cv::Point>& left, bool is_first_pass) {
    std::vector<cv::Point> going;
    std::vector<cv::Point> staying;
    for (const cv::Point& p : left) {
        (may_go(neighbours(map, p), is_first_pass) ? going : staying).push_back(p);
    }
    for (const cv::Point& p : going) {
        map(p) = 0;
    }
    left = std::move(staying);
    return !going.empty();
}

std::vector<cv::Point> disc(double radius) {
    const int r = static_cast<int>(radius);
    std::vector<cv::Point> offsets;
    for (int y = -r; y <= r; ++y) {
        for (int x = -r; x <= r; ++x) {
            if (x * x + y * y <= radius * radius) {
                offsets.emplace_back(x, y);
            }
        }
    }
    std::ranges::stable_sort(offsets, {}, [](const cv::Point& p) { return p.dot(p); });
    return offsets;
}

std::vector<cv::Point> pixels_of(const cv::Mat1b& map) {
    std::vector<cv::Point> pixels;
    for (int y = 0; y < map.rows; ++y) {
        for (int x = 0; x < map.cols; ++x) {
            if (map(y, x) != 0) {
                pixels.emplace_back(x, y);
            }
        }
    }
    return pixels;
}

template <class T>
auto& at(T& values, int i) {
    return values[static_cast<std::size_t>(i)];
}

/// The largest matching between pixels within reach of each other (Hopcroft, Karp 1973), which
/// first takes the nearest.
class Matching {
  public:
    Matching(const std::vector<cv::Point>& edges, const cv::Mat1b& truth,
             const std::vector<cv::Point>& reach)
        : edges_(edges), reach_(reach), ids_(truth.size(), no_partner) {
        int count = 0;
        for (const cv::Point& p : pixels_of(truth)) {
            ids_(p) = count++;
        }
        mate_of_edge_.assign(edges.size(), no_partner);
        mate_of_truth_.assign(static_cast<std::size_t>(count), no_partner);
    }

    /// Returns each edge pixel's partner, or no_partner.
    [[nodiscard]] const std::vector<int>& run() {
        take_nearest();
        while (layer()) {
            next_.assign(edges_.size(), 0);
            for (int edge = 0; edge < edge_count(); ++edge) {
                if (at(mate_of_edge_, edge) == no_partner && at(level_, edge) == 0) {
                    augment(edge);
                }
            }
        }
        return mate_of_edge_;
    }

  private:
    int edge_count() const { return static_cast<int>(edges_.size()); }

    int neighbour(int edge, std::size_t k) const {
        const cv::Point p = at(edges_, edge) + reach_[k];
        const bool is_inside = p.x >= 0 && p.y >= 0 && p.x < ids_.cols && p.y < ids_.rows;
        return is_inside ? ids_(p) : no_partner;
    }

    void pair(int edge, int truth) {
        at(mate_of_edge_, edge) = truth;
        at(mate_of_truth_, truth) = edge;
    }

    void take_nearest() {
        for (std::size_t k = 0; k < reach_.size(); ++k) {
            for (int edge = 0; edge < edge_count(); ++edge) {
                const int truth =
                    at(mate_of_edge_, edge) == no_partner ? neighbour(edge, k) : no_partner;
                if (truth != no_partner && at(mate_of_truth_, truth) == no_partner) {
                    pair(edge, truth);
                }
            }
        }
    }

    /// Searches breadth first from the edges without a partner; false if no free truth is in reach.
    bool layer() {
        level_.assign(edges_.size(), no_partner);
        std::vector<int> queue;
        for (int edge = 0; edge < edge_count(); ++edge) {
            if (at(mate_of_edge_, edge) == no_partner) {
                at(level_, edge) = 0;
                queue.push_back(edge);
            }
        }
        int last = std::numeric_limits<int>::max();
        for (std::size_t i = 0; i < queue.size() && at(level_, queue[i]) < last; ++i) {
            for (std::size_t k = 0; k < reach_.size(); ++k) {
                const int truth = neighbour(queue[i], k);
                if (truth == no_partner) {
                    continue;
                }
                const int other = at(mate_of_truth_, truth);
                if (other == no_partner) {
                    last = std::min(last, at(level_, queue[i]));
                } else if (at(level_, other) == no_partner) {
                    at(level_, other) = at(level_, queue[i]) + 1;
                    queue.push_back(other);
                }
            }
        }
        return last != std::numeric_limits<int>::max();
    }

    /// Searches depth first along rising levels for a free truth; each edge looks at each neighbour
    /// once.
    bool augment(int edge) {
        for (std::size_t& k = at(next_, edge); k < reach_.size();) {
            const int truth = neighbour(edge, k++);
            if (truth == no_partner) {
                continue;
            }
            const int other = at(mate_of_truth_, truth);
            if (other == no_partner ||
                (at(level_, other) == at(level_, edge) + 1 && augment(other))) {
                pair(edge, truth);
                return true;
            }
        }
        return false;
    }

    const std::vector<cv::Point>& edges_;
    const std::vector<cv::Point>& reach_;
    cv::Mat1i ids_;  // of the truth's pixels
    std::vector<int> mate_of_edge_;
    std::vector<int> mate_of_truth_;
    std::vector<int> level_;
    std::vector<std::size_t> next_;
};

}  // namespace

double BoundaryCounts::precision() const {
    return edges_all > 0.0 ? edges_hit / edges_all : 0.0;
}

double BoundaryCounts::recall() const {
    return truth_all > 0.0 ? truth_hit / truth_all : 0.0;
}

double BoundaryCounts::f() const {
    const double sum = precision() + recall();
    return sum > 0.0 ? 2.0 * precision() * recall() / sum : 0.0;
}

BoundaryCounts& BoundaryCounts::operator+=(const BoundaryCounts& more) {
    truth_hit += more.truth_hit;
    truth_all += more.truth_all;
    edges_hit += more.edges_hit;
    edges_all += more.edges_all;
    return *this;
}

cv::Mat1b thinned(const cv::Mat1b& map) {
    cv::Mat1b lines = map.clone();
    std::vector<cv::Point> left = pixels_of(lines(cv::Rect(1, 1, map.cols - 2, map.rows - 2)));
    for (cv::Point& p : left) {
        p += cv::Point(1, 1);
    }
    bool is_changing = true;
    while (is_changing) {
        is_changing = thin_once(lines, left, true);
        is_changing = thin_once(lines, left, false) || is_changing;
    }
    return lines;
}

BoundaryCounts boundary_counts(const cv::Mat1b& strength, int least,
                               const std::vector<cv::Mat1b>& annotators) {
    const std::vector<cv::Point> edges = pixels_of(thinned(cv::Mat(strength >= least)));
    const std::vector<cv::Point> reach =
        disc(reach_over_diagonal * std::hypot(strength.rows, strength.cols));
    std::vector<bool> is_hit(edges.size(), false);
    BoundaryCounts counts;
    counts.edges_all = static_cast<double>(edges.size());
    for (const cv::Mat1b& truth : annotators) {
        Matching matching(edges, truth, reach);
        const std::vector<int>& mates = matching.run();
        for (std::size_t i = 0; i < mates.size(); ++i) {
            counts.truth_hit += mates[i] != no_partner ? 1.0 : 0.0;
            is_hit[i] = is_hit[i] || mates[i] != no_partner;
        }
        counts.truth_all += cv::countNonZero(truth);
    }
    counts.edges_hit = static_cast<double>(std::ranges::count(is_hit, true));
    return counts;
}

void BoundarySweep::add(const cv::Mat1b& strength, const std::vector<cv::Mat1b>& annotators) {
    for (std::size_t i = 0; i < least.size(); ++i) {
        counts[i] += boundary_counts(strength, least[i], annotators);
    }
}

BoundaryCounts BoundarySweep::automatic() const {
    const auto at = std::ranges::find(least, automatic_level);
    return counts[static_cast<std::size_t>(at - least.begin())];
}

BoundaryCounts BoundarySweep::best() const {
    return *std::ranges::max_element(counts, {}, &BoundaryCounts::f);
}

}  // namespace touchline::testing
