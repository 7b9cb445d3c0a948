#include "vision/contour/double_edges.h"

#include "vision/contour/facing.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace touchline {
namespace {

constexpr double kMostOfLine = 0.7;  // for the line to be a stroke of one width

/// A place between the two sides of a stripe.
struct Middle {
    std::size_t on_side = 0;  // indices of the points that face each other
    std::size_t on_opposite = 0;
    EdgePoint point;
};

void append(std::vector<EdgePoint>& points, const std::vector<EdgePoint>& more) {
    points.insert(points.end(), more.begin(), more.end());
}

std::vector<EdgePoint> part(const std::vector<EdgePoint>& points, std::size_t from,
                            std::size_t to) {
    return {points.begin() + static_cast<std::ptrdiff_t>(from),
            points.begin() + static_cast<std::ptrdiff_t>(to)};
}

/// Continues a stripe's middle beyond the stripe: straight if both sides run into one point, else
/// along the side that runs on longer.
std::vector<EdgePoint> run_on(std::vector<EdgePoint> a, std::vector<EdgePoint> b, bool at_front) {
    const auto last = [&](const std::vector<EdgePoint>& run) {
        return at_front ? run.front() : run.back();
    };
    if (!a.empty() && !b.empty() && last(a).at == last(b).at) {
        return {last(a)};
    }
    return length_of({a, false}) >= length_of({b, false}) ? a : b;
}

class Merger {
  public:
    Merger(std::vector<Chain> chains, cv::Size picture, double widest_px)
        : chains_(std::move(chains)), picture_(picture), widest_px_(widest_px) {}

    std::vector<Chain> run() {
        std::vector<bool> is_merged(chains_.size(), false);
        const PointGrid grid(chains_, picture_, widest_px_);
        std::vector<std::pair<std::size_t, ThinRing>> rings;
        for (std::size_t c = 0; c < chains_.size(); ++c) {
            const auto ring =
                chains_[c].is_closed ? thin_ring(chains_, c, grid, widest_px_) : std::nullopt;
            if (ring) {
                rings.emplace_back(c, *ring);
            }
        }
        for (const auto& [c, ring] : rings) {
            is_merged[c] = merge_ring(c, ring);
        }
        for (const FacingPair& pair : facing_pairs(chains_, picture_, widest_px_)) {
            if (!is_merged[pair.shorter] && !is_merged[pair.longer] && merge(pair)) {
                is_merged[pair.shorter] = is_merged[pair.longer] = true;
            }
        }
        std::erase_if(chains_, [](const Chain& chain) { return chain.points.empty(); });
        return std::move(chains_);
    }

  private:
    bool merge_ring(std::size_t c, const ThinRing& ring) {
        std::vector<EdgePoint> points = chains_[c].points;
        std::ranges::rotate(points, points.begin() + static_cast<std::ptrdiff_t>(ring.tip));
        points.push_back(points.front());
        const std::size_t half = points.size() / 2;
        Chain side{part(points, 0, half + 1)};
        Chain opposite{part(points, half, points.size())};
        std::optional<Chain> line = merged(side, opposite, ring.stripe, ring.width_px);
        if (line) {
            const Chain old = std::exchange(chains_[c], {});
            move_fixed_points(old, *line);
            chains_[c] = std::move(*line);
        }
        return line.has_value();
    }

    bool merge(const FacingPair& pair) {
        Chain side = chains_[pair.longer];
        Chain opposite = chains_[pair.shorter];
        std::optional<Chain> line = merged(side, opposite, pair.stripe, pair.width_px);
        if (line) {
            chains_[pair.longer].points.clear();
            chains_[pair.shorter].points.clear();
            move_fixed_points(side, *line);
            move_fixed_points(opposite, *line);
            chains_[pair.longer] = std::move(*line);
        }
        return line.has_value();
    }

    /// Returns the line in the middle; nothing if the sides hardly face each other. Turns the sides
    /// so that they run the same way.
    std::optional<Chain> merged(Chain& side, Chain& opposite, Stripe stripe,
                                double width_px) const {
        std::vector<Middle> middles = middles_of(side, opposite, stripe);
        if (middles.size() < 2) {
            return std::nullopt;
        }
        if (side.is_closed) {
            begin_after_longest_break(side, middles);
        }
        if (middles.front().on_opposite > middles.back().on_opposite) {
            std::ranges::reverse(opposite.points);
            for (Middle& m : middles) {
                m.on_opposite = opposite.points.size() - 1 - m.on_opposite;
            }
        }
        const Middle& first = middles.front();
        const Middle& last = middles.back();
        const auto others = [&](std::size_t from, std::size_t to) {
            const bool is_open = !side.is_closed && !opposite.is_closed;
            return is_open ? part(opposite.points, from, to) : std::vector<EdgePoint>{};
        };
        Chain middle;
        std::ranges::transform(middles, std::back_inserter(middle.points), &Middle::point);
        Chain line{run_on(part(side.points, 0, first.on_side), others(0, first.on_opposite), true),
                   side.is_closed};
        append(line.points, middle.points);
        append(line.points, run_on(part(side.points, last.on_side + 1, side.points.size()),
                                   others(last.on_opposite + 1, opposite.points.size()), false));
        if (length_of(middle) > kMostOfLine * length_of(line)) {
            line.width_px = width_px;
        }
        return line;
    }

    /// Returns where `side` faces `opposite`, along `side`.
    std::vector<Middle> middles_of(const Chain& side, const Chain& opposite, Stripe stripe) const {
        const std::vector<Chain> other{opposite};
        const PointGrid grid(other, picture_, widest_px_);
        std::vector<Middle> middles;
        for (std::size_t i = 0; i < side.points.size(); ++i) {
            const EdgePoint& p = side.points[i];
            const std::optional<Facing> faced =
                facing(p, other, grid, widest_px_, [](const PointRef&) { return true; });
            if (faced && faced->stripe == stripe) {
                const EdgePoint& q = opposite.points[faced->to.index];
                const double strength = std::max(p.strength, q.strength);
                middles.push_back({i, faced->to.index, {0.5 * (p.at + q.at), strength}});
            }
        }
        return middles;
    }

    /// Puts a ring's longest stretch without the other side last.
    static void begin_after_longest_break(Chain& ring, std::vector<Middle>& middles) {
        const std::size_t n = ring.points.size();
        std::size_t begin = 0;
        std::size_t longest = 0;
        for (std::size_t i = 0; i < middles.size(); ++i) {
            const std::size_t before = middles[(i + middles.size() - 1) % middles.size()].on_side;
            const std::size_t skipped = (middles[i].on_side + n - before - 1) % n;
            if (skipped > longest) {
                longest = skipped;
                begin = i;
            }
        }
        const std::size_t shift = middles[begin].on_side;
        std::ranges::rotate(middles, middles.begin() + static_cast<std::ptrdiff_t>(begin));
        std::ranges::rotate(ring.points, ring.points.begin() + static_cast<std::ptrdiff_t>(shift));
        for (Middle& m : middles) {
            m.on_side = (m.on_side + n - shift) % n;
        }
    }

    /// Moves the fixed points of a removed line onto the new one, wherever they are shared.
    void move_fixed_points(const Chain& old, Chain& line) {
        for (const EdgePoint& point : old.points) {
            if (!point.is_fixed) {
                continue;
            }
            EdgePoint& nearest = *std::ranges::min_element(
                line.points, {}, [&](const EdgePoint& p) { return distance(p.at, point.at); });
            nearest.is_fixed = true;
            for (Chain& chain : chains_) {
                for (EdgePoint& other : chain.points) {
                    if (other.is_fixed && other.at == point.at) {
                        other.at = nearest.at;
                    }
                }
            }
        }
    }

    std::vector<Chain> chains_;
    cv::Size picture_;
    double widest_px_;
};

}  // namespace

std::vector<Chain> with_double_edges_merged(std::vector<Chain> chains, cv::Size picture,
                                            double widest_px) {
    return Merger(std::move(chains), picture, widest_px).run();
}

}  // namespace touchline
