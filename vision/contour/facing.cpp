#include "vision/contour/facing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace touchline {
namespace {

constexpr double kLeastCover = 0.7;  // of the shorter line, by points asked
constexpr double kOpposite = 0.866;  // cosine of 30 degrees
constexpr double kAcross = 0.819;    // cosine of 35 degrees
constexpr double kLeastLine = 2.0;   // length over width: less is a blob, not a stripe
constexpr double kLeastRing = 3.0;   // half the way round over width; a disc has 1.6
constexpr std::size_t kEvery = 3;    // points of about 0.7 px: pairing needs no more of them

bool is_most(std::size_t part, std::size_t whole) {
    return static_cast<double>(part) > kLeastCover * static_cast<double>(whole);
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
    for (std::size_t tip = 0; tip < n / 2; tip += kEvery) {
        const auto is_first_half = [&](std::size_t i) { return (i + n - tip) % n < n / 2; };
        const auto parted =
            static_cast<std::size_t>(std::ranges::count_if(across, [&](const auto& p) {
                return is_first_half(p.first) != is_first_half(p.second);
            }));
        if (parted > best.parted) {
            best = {tip, parted};
        }
    }
    return best;
}

}  // namespace

std::optional<Stripe> stripe_between(const EdgePoint& p, const EdgePoint& q) {
    const cv::Point2d over = q.at - p.at;
    const cv::Point2d light_p(p.to_light[0], p.to_light[1]);
    const cv::Point2d light_q(q.to_light[0], q.to_light[1]);
    const double at_p = over.dot(light_p);  // > 0: the light is between them
    const double at_q = -over.dot(light_q);
    const bool is_across =
        at_p * at_q > 0.0 && std::min(std::abs(at_p), std::abs(at_q)) > kAcross * cv::norm(over);
    if (!is_across || light_p.dot(light_q) > -kOpposite) {
        return std::nullopt;
    }
    return at_p < 0.0 ? Stripe::dark : Stripe::light;
}

std::vector<FacingPair> facing_pairs(const std::vector<Chain>& chains, cv::Size picture,
                                     double widest_px) {
    const PointGrid grid(chains, picture, widest_px);
    std::vector<double> lengths_px;
    for (const Chain& chain : chains) {
        lengths_px.push_back(length_of(chain));
    }
    std::vector<FacingPair> pairs;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        std::map<std::pair<std::size_t, Stripe>, Faced> others;
        std::size_t asked = 0;
        for (std::size_t i = 0; i < chains[c].points.size(); i += kEvery, ++asked) {
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
                lengths_px[c] > kLeastLine * width_px) {
                pairs.push_back({c, other.first, other.second, width_px});
            }
        }
    }
    std::ranges::stable_sort(pairs, {}, &FacingPair::width_px);
    return pairs;
}

std::optional<ThinRing> thin_ring(const std::vector<Chain>& chains, std::size_t ring,
                                  const PointGrid& grid, double widest_px) {
    const std::vector<EdgePoint>& points = chains[ring].points;
    const std::size_t n = points.size();
    std::vector<std::pair<std::size_t, std::size_t>> across;
    std::size_t asked = 0;
    std::map<Stripe, Faced> stripes;
    for (std::size_t i = 0; i < n; i += kEvery, ++asked) {
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
        const bool is_long = 0.5 * length_of(chains[ring]) > kLeastRing * width_px;
        if (is_most(faced.times, asked) && is_long) {
            const auto [tip, parted] = best_tip(across, n);
            return is_most(parted, asked) ? std::optional(ThinRing{tip, stripe, width_px})
                                          : std::nullopt;
        }
    }
    return std::nullopt;
}

}  // namespace touchline
