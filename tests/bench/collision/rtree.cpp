#include "tests/bench/collision/rtree.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace touchline::bench {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::point<double, 2, bg::cs::cartesian>;
using Box = bg::model::box<Point>;
using Line = bg::model::segment<Point>;
using Value = std::pair<Box, std::uint32_t>;

std::vector<Value> boxes_of(ClosedCurve curve) {
    std::vector<Value> boxes;
    boxes.reserve(curve.size());
    for (std::uint32_t i = 0; i < curve.size(); ++i) {
        const Segment e = edge_of(curve, i);
        boxes.emplace_back(Box{{std::min(e.a.x, e.b.x), std::min(e.a.y, e.b.y)},
                               {std::max(e.a.x, e.b.x), std::max(e.a.y, e.b.y)}},
                           i);
    }
    return boxes;
}

}  // namespace

struct RTree::Index {
    bg::index::rtree<Value, bg::index::rstar<16>> tree;
};

RTree::RTree(ClosedCurve curve)
    : curve_(curve),
      index_(std::make_unique<Index>(Index{decltype(Index::tree)(boxes_of(curve))})) {}

RTree::RTree(RTree&&) noexcept = default;
RTree::~RTree() = default;

std::optional<Crossing> RTree::first_crossing(Position from, Position to) const {
    std::optional<Crossing> first;
    const Line motion{{from.x, from.y}, {to.x, to.y}};
    const auto query = bg::index::intersects(motion);
    for (auto it = index_->tree.qbegin(query); it != index_->tree.qend(); ++it) {
        keep_first(first, from, to - from, curve_, it->second);
    }
    return first;
}

Nearest RTree::nearest(Position p) const {
    SquaredFoot best{p, std::numeric_limits<double>::infinity()};
    const Point at{p.x, p.y};
    const auto query = bg::index::nearest(at, static_cast<unsigned>(curve_.size()));
    for (auto it = index_->tree.qbegin(query); it != index_->tree.qend(); ++it) {
        if (bg::comparable_distance(at, it->first) >= best.squared_m2) break;
        const SquaredFoot found = squared_foot(p, edge_of(curve_, it->second));
        if (found.squared_m2 < best.squared_m2) best = found;
    }
    return {best.point, std::sqrt(best.squared_m2)};
}

}  // namespace touchline::bench
