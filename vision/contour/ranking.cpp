#include "vision/contour/ranking.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double kExtent_m = 0.040;  // a stroke that is felt as one of the picture's main lines
constexpr double kClosedGain = 1.5;  // a finger can lose an open line, not a closed one

double salience_of(const Chain& chain, double high, double metres_per_px) {
    double sum = 0.0;
    for (const EdgePoint& p : chain.points) {
        sum += p.strength;
    }
    const double r = sum / static_cast<double>(chain.points.size()) / high;
    const double extent = 1.0 - std::exp(-length_of(chain) * metres_per_px / kExtent_m);
    return r / (1.0 + r) * extent * (chain.is_closed ? 1.0 : 1.0 / kClosedGain);
}

}  // namespace

std::vector<RankedOutline> ranked(std::vector<Chain> chains, double high, double metres_per_px) {
    std::vector<RankedOutline> order;
    order.reserve(chains.size());
    for (Chain& chain : chains) {
        const double salience = salience_of(chain, high, metres_per_px);
        order.push_back({std::move(chain), salience, 0});
    }
    std::ranges::stable_sort(order, std::ranges::greater{}, &RankedOutline::salience);
    int count = 0;
    double line_m = 0.0;
    std::size_t detail = 0;
    for (RankedOutline& outline : order) {
        ++count;
        line_m += length_of(outline.chain) * metres_per_px;
        while (
            count > 1 && detail < kDetailBudgets.size() &&
            (count > kDetailBudgets[detail].outlines || line_m > kDetailBudgets[detail].line_m)) {
            ++detail;
        }
        outline.detail = static_cast<int>(detail) + 1;
    }
    return order;
}

}  // namespace touchline
