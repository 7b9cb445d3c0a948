#include "tests/lab/bench/collision/peers.h"

#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include <boost/function_output_iterator.hpp>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace touchline::bench {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::point<double, 2, bg::cs::cartesian>;
using Line = bg::model::segment<Point>;
using Value = std::pair<Line, std::uint32_t>;

Line line_of(Position a, Position b) {
    return {{a.x, a.y}, {b.x, b.y}};
}

std::vector<Value> lines_of(ClosedCurve curve) {
    std::vector<Value> lines;
    lines.reserve(curve.size());
    for (std::uint32_t i = 0; i < curve.size(); ++i) {
        const Segment edge = edge_of(curve, i);
        lines.emplace_back(line_of(edge.a, edge.b), i);
    }
    return lines;
}

}  // namespace

struct RTree::Index {
    bg::index::rtree<Value, bg::index::rstar<16>> tree;
};

RTree::RTree(ClosedCurve curve)
    : curve_(curve), index_(new Index{decltype(Index::tree)(lines_of(curve))}) {}

RTree::RTree(RTree&&) noexcept = default;
RTree::~RTree() = default;

std::optional<Crossing> RTree::first_crossing(Position from, Position to) const {
    std::optional<Crossing> first;
    const auto keep = [&](const Value& value) {
        keep_first(first, from, to - from, edge_of(curve_, value.second), value.second);
    };
    index_->tree.query(bg::index::intersects(line_of(from, to)),
                       boost::make_function_output_iterator(keep));
    return first;
}

Nearest RTree::nearest(Position p) const {
    std::vector<Value> found;
    found.reserve(1);
    index_->tree.query(bg::index::nearest(Point(p.x, p.y), 1), std::back_inserter(found));
    const SquaredFoot foot = squared_foot(p, edge_of(curve_, found.front().second));
    return {foot.point, std::sqrt(foot.squared_m2)};
}

}  // namespace touchline::bench
