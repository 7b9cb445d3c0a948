#include "vision/simplify/ranking.h"

#include "config/types/map_limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double kLength_mm =
    150.0;  // about once round a thing of a hand's size: longer counts little more
constexpr double kOpen = 2.0 / 3.0;
constexpr double kInside = 0.7;
constexpr double kLeastStrength = 1e-6;  // of `high`: the part of a border in a zoom may have none

double salience_of(const Chain& line, double outer_share, double high) {
    double sum = 0.0;
    for (const EdgePoint& p : line.points) {
        sum += p.strength;
    }
    const double r = std::max(kLeastStrength, sum / static_cast<double>(line.points.size()) / high);
    const double length = 1.0 - std::exp(-length_of(line) / kLength_mm);
    const double salience = r / (1.0 + r) * length * (line.is_closed ? 1.0 : kOpen) *
                            (kInside + (1.0 - kInside) * outer_share);
    return std::max(MapLimits::least_weight, salience);
}

}  // namespace

std::vector<RankedLine> ranked(std::vector<Chain> lines, const std::vector<double>& outer_shares,
                               double high) {
    std::vector<RankedLine> order;
    order.reserve(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double salience = salience_of(lines[i], outer_shares[i], high);
        order.push_back({std::move(lines[i]), salience, outer_shares[i]});
    }
    std::ranges::stable_sort(order, std::ranges::greater{}, &RankedLine::salience);
    return order;
}

}  // namespace touchline
