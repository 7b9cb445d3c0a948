#include "tests/lab/bench/collision/peers.h"

#include <vector>

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

namespace touchline::bench {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Line = Kernel::Segment_3;
using Lines = std::vector<Line>;
using Primitive = CGAL::AABB_segment_primitive<Kernel, Lines::const_iterator>;
using Traits = CGAL::AABB_traits<Kernel, Primitive>;
using Tree = CGAL::AABB_tree<Traits>;

Point in_space(Position p) {
    return {p.x, p.y, 0.0};
}

Lines lines_of(ClosedCurve curve) {
    Lines lines;
    lines.reserve(curve.size());
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const Segment edge = edge_of(curve, i);
        lines.emplace_back(in_space(edge.a), in_space(edge.b));
    }
    return lines;
}

/// Answers what the library's traversal asks at nodes and leaves.
class FirstCrossing {
  public:
    FirstCrossing(Position from, Position way, ClosedCurve curve, Lines::const_iterator first_line)
        : from_(from),
          way_(way),
          curve_(curve),
          first_line_(first_line),
          left_(in_space(from), in_space(from + way)) {}

    [[nodiscard]] static bool go_further() { return true; }

    void intersection(const Line& /*motion*/, const Primitive& primitive) {
        const auto edge = static_cast<std::uint32_t>(primitive.id() - first_line_);
        const auto before = first_;
        keep_first(first_, from_, way_, edge_of(curve_, edge), edge);
        const bool is_earlier = first_ && (!before || first_->share < before->share);
        if (is_earlier) left_ = Line(left_.source(), in_space(from_ + first_->share * way_));
    }

    template <class Node>
    [[nodiscard]] bool do_intersect(const Line& /*motion*/, const Node& node) const {
        return CGAL::do_intersect(left_, node.bbox());
    }

    [[nodiscard]] const std::optional<Crossing>& result() const { return first_; }

  private:
    Position from_, way_;
    ClosedCurve curve_;
    Lines::const_iterator first_line_;
    Line left_;  // the motion up to the first crossing found
    std::optional<Crossing> first_;
};

}  // namespace

struct AabbTree::Index {
    explicit Index(ClosedCurve curve) : lines(lines_of(curve)), tree(lines.cbegin(), lines.cend()) {
        tree.accelerate_distance_queries();
    }

    Lines lines;
    Tree tree;
};

AabbTree::AabbTree(ClosedCurve curve) : curve_(curve), index_(std::make_unique<Index>(curve)) {}

AabbTree::AabbTree(AabbTree&&) noexcept = default;
AabbTree::~AabbTree() = default;

std::optional<Crossing> AabbTree::first_crossing(Position from, Position to) const {
    FirstCrossing visitor(from, to - from, curve_, index_->lines.cbegin());
    index_->tree.traversal(Line(in_space(from), in_space(to)), visitor);
    return visitor.result();
}

Nearest AabbTree::nearest(Position p) const {
    const Point at = index_->tree.closest_point(in_space(p));
    const Position point{at.x(), at.y()};
    return {point, norm(p - point)};
}

}  // namespace touchline::bench
