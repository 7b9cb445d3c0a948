#include "vision/contour/linking.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace touchline {
namespace {

constexpr double most_of_line = 0.7;       // for the line to be a stroke of one width
constexpr double least_cover = 0.7;        // of the shorter line, by points asked
constexpr double opposite_cosine = 0.866;  // cosine of 30 degrees
constexpr double across_cosine = 0.819;    // cosine of 35 degrees
constexpr double least_line = 2.0;         // length over width: less is a blob, not a stripe
constexpr double least_ring = 3.0;         // half the way round over width; a disc has 1.6
constexpr std::size_t every = 3;           // points of about 0.7 px: pairing needs no more of them

/// What lies between two facing edges.
enum class Stripe { dark, light };

/// The point on the other side of a stripe.
struct Facing {
    PointRef to;
    Stripe stripe = Stripe::dark;
    double width_px = 0.0;
};

/// Returns the stripe between two edge points: they are edges of one if their light sides are
/// opposite (within 30 degrees) and the way over runs across both (within 35 degrees).
std::optional<Stripe> stripe_between(const EdgePoint& p, const EdgePoint& q) {
    const cv::Point2d over = q.at - p.at;
    const cv::Point2d light_p(p.to_light[0], p.to_light[1]);
    const cv::Point2d light_q(q.to_light[0], q.to_light[1]);
    const double at_p = over.dot(light_p);  // > 0: the light is between them
    const double at_q = -over.dot(light_q);
    const bool is_across = at_p * at_q > 0.0 && std::min(std::abs(at_p), std::abs(at_q)) >
                                                    across_cosine * cv::norm(over);
    if (!is_across || light_p.dot(light_q) > -opposite_cosine) return std::nullopt;
    return at_p < 0.0 ? Stripe::dark : Stripe::light;
}

/// Returns the nearest of the chains' points (all in `grid`) that faces `p` at less than
/// `widest_px`; `may_face` chooses among them by PointRef.
template <class MayFace>
std::optional<Facing> facing(const EdgePoint& p, const std::vector<Chain>& chains,
                             const PointGrid& grid, double widest_px, MayFace&& may_face) {
    std::optional<Facing> nearest;
    double least_squared = widest_px * widest_px;
    grid.near(p.at, widest_px, [&](const PointRef& ref) {
        const EdgePoint& q = chains[ref.chain].points[ref.index];
        const cv::Point2d over = q.at - p.at;
        const double squared = over.dot(over);
        if (squared < least_squared && squared > 0.0 && may_face(ref)) {
            if (const std::optional<Stripe> stripe = stripe_between(p, q)) {
                least_squared = squared;
                nearest = Facing{ref, *stripe, std::sqrt(squared)};
            }
        }
    });
    return nearest;
}

/// A line that faces a longer one along more than 70 % of itself, over less than half its length.
struct FacingPair {
    std::size_t shorter = 0;
    std::size_t longer = 0;
    Stripe stripe = Stripe::dark;
    double width_px = 0.0;  // mean
};

/// A ring round a stripe.
struct ThinRing {
    std::size_t tip = 0;  // if begun here, its two halves (by points) are the stripe's sides
    Stripe stripe = Stripe::dark;
    double width_px = 0.0;  // mean
};

bool is_most(std::size_t part, std::size_t whole) {
    return static_cast<double>(part) > least_cover * static_cast<double>(whole);
}

struct Faced {
    std::size_t times = 0;
    double widths_px = 0.0;
};

/// The best place to begin a ring of n points, and how many of the pairs of points in `across` then
/// have one point in either half.
struct Tip {
    std::size_t tip = 0;
    std::size_t parted = 0;
};

Tip best_tip(const std::vector<std::pair<std::size_t, std::size_t>>& across, std::size_t n) {
    Tip best;
    for (std::size_t tip = 0; tip < n / 2; tip += every) {
        const auto is_first_half = [&](std::size_t i) { return (i + n - tip) % n < n / 2; };
        const auto parted =
            static_cast<std::size_t>(std::ranges::count_if(across, [&](const auto& p) {
                return is_first_half(p.first) != is_first_half(p.second);
            }));
        if (parted > best.parted) best = {tip, parted};
    }
    return best;
}

/// Returns all such pairs, narrowest first; each point faces the nearest line only.
std::vector<FacingPair> facing_pairs(const std::vector<Chain>& chains, cv::Size picture,
                                     double widest_px) {
    const PointGrid grid(chains, picture, widest_px);
    std::vector<double> lengths_px;
    for (const Chain& chain : chains) lengths_px.push_back(length_of(chain));
    std::vector<FacingPair> pairs;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        std::map<std::pair<std::size_t, Stripe>, Faced> others;
        std::size_t asked = 0;
        for (std::size_t i = 0; i < chains[c].points.size(); i += every, ++asked) {
            const auto faced = facing(chains[c].points[i], chains, grid, widest_px,
                                      [c](const PointRef& ref) { return ref.chain != c; });
            if (faced) {
                Faced& other = others[{faced->to.chain, faced->stripe}];
                ++other.times;
                other.widths_px += faced->width_px;
            }
        }
        for (const auto& [other, faced] : others) {
            const auto rank = [&](std::size_t i) { return std::pair(lengths_px[i], i); };
            const double width_px = faced.widths_px / static_cast<double>(faced.times);
            if (is_most(faced.times, asked) && rank(c) < rank(other.first) &&
                lengths_px[c] > least_line * width_px) {
                pairs.push_back({c, other.first, other.second, width_px});
            }
        }
    }
    std::ranges::stable_sort(pairs, {}, &FacingPair::width_px);
    return pairs;
}

/// Returns the ring if its halves face each other along more than 70 % of them, over less than a
/// third of their length.
std::optional<ThinRing> thin_ring(const std::vector<Chain>& chains, std::size_t ring,
                                  const PointGrid& grid, double widest_px) {
    const std::vector<EdgePoint>& points = chains[ring].points;
    const std::size_t n = points.size();
    std::vector<std::pair<std::size_t, std::size_t>> across;
    std::size_t asked = 0;
    std::map<Stripe, Faced> stripes;
    for (std::size_t i = 0; i < n; i += every, ++asked) {
        const auto faced = facing(points[i], chains, grid, widest_px,
                                  [ring](const PointRef& ref) { return ref.chain == ring; });
        if (faced) {
            across.emplace_back(i, faced->to.index);
            ++stripes[faced->stripe].times;
            stripes[faced->stripe].widths_px += faced->width_px;
        }
    }
    for (const auto& [stripe, faced] : stripes) {
        const double width_px = faced.widths_px / static_cast<double>(faced.times);
        const bool is_long = 0.5 * length_of(chains[ring]) > least_ring * width_px;
        if (is_most(faced.times, asked) && is_long) {
            const auto [tip, parted] = best_tip(across, n);
            return is_most(parted, asked) ? std::optional(ThinRing{tip, stripe, width_px})
                                          : std::nullopt;
        }
    }
    return std::nullopt;
}

/// A place between the two sides of a stripe.
struct Middle {
    std::size_t on_side = 0;  // indices of the points that face each other
    std::size_t on_opposite = 0;
    EdgePoint point;
};

void append(std::vector<EdgePoint>& points, const std::vector<EdgePoint>& more) {
    points.insert(points.end(), more.begin(), more.end());
}

/// Continues a stripe's middle beyond the stripe: straight if both sides run into one point, else
/// along the side that runs on longer.
std::vector<EdgePoint> run_on(std::vector<EdgePoint> a, std::vector<EdgePoint> b, bool at_front) {
    const auto last = [&](const std::vector<EdgePoint>& run) {
        return at_front ? run.front() : run.back();
    };
    if (!a.empty() && !b.empty() && last(a).at == last(b).at) return {last(a)};
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
            if (ring) rings.emplace_back(c, *ring);
        }
        for (const auto& [c, ring] : rings) is_merged[c] = merge_ring(c, ring);
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
        begin_at(ring.tip, points);
        points.push_back(points.front());
        const std::size_t half = points.size() / 2;
        Chain side{part_of(points, 0, half + 1)};
        Chain opposite{part_of(points, half, points.size())};
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
        if (middles.size() < 2) return std::nullopt;
        if (side.is_closed) begin_after_longest_break(side, middles);
        if (middles.front().on_opposite > middles.back().on_opposite) {
            std::ranges::reverse(opposite.points);
            for (Middle& m : middles) m.on_opposite = opposite.points.size() - 1 - m.on_opposite;
        }
        const Middle& first = middles.front();
        const Middle& last = middles.back();
        const auto others = [&](std::size_t from, std::size_t to) {
            const bool is_open = !side.is_closed && !opposite.is_closed;
            return is_open ? part_of(opposite.points, from, to) : std::vector<EdgePoint>{};
        };
        Chain middle;
        std::ranges::transform(middles, std::back_inserter(middle.points), &Middle::point);
        Chain line{
            run_on(part_of(side.points, 0, first.on_side), others(0, first.on_opposite), true),
            side.is_closed};
        append(line.points, middle.points);
        append(line.points, run_on(part_of(side.points, last.on_side + 1, side.points.size()),
                                   others(last.on_opposite + 1, opposite.points.size()), false));
        if (length_of(middle) > most_of_line * length_of(line)) line.width_px = width_px;
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
        begin_at(shift, ring.points);
        for (Middle& m : middles) m.on_side = (m.on_side + n - shift) % n;
    }

    /// Moves the fixed points of a removed line onto the new one, wherever they are shared.
    void move_fixed_points(const Chain& old, Chain& line) {
        for (const EdgePoint& point : old.points) {
            if (!point.is_fixed) continue;
            EdgePoint& nearest = *std::ranges::min_element(
                line.points, {}, [&](const EdgePoint& p) { return distance(p.at, point.at); });
            nearest.is_fixed = true;
            for (Chain& chain : chains_) {
                for (EdgePoint& other : chain.points) {
                    if (other.is_fixed && other.at == point.at) other.at = nearest.at;
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
