#include "haptics/probe/probe_shape.h"

#include <numbers>
#include <utility>

#include <fmt/core.h>

namespace touchline {
namespace {

constexpr double largest_radius_m = 0.02;
constexpr double disc_radius_m = 4e-3;
constexpr double way_error_m = 1e-9;
constexpr double corner_radius_m = 5e-4;  // rounds a corner, so that it does not catch on a line's

/// Returns a capsule whose chord points from the first point to the one furthest from it.
Capsule capsule_of_edges(std::span<const Segment> edges) {
    if (edges.size() == 1) return {edges[0], 0.0};
    const Position first = edges[0].a;
    Position furthest = first;
    for (const Segment& s : edges) {
        for (const Position p : {s.a, s.b}) {
            if (norm(p - first) > norm(furthest - first)) furthest = p;
        }
    }
    const Direction u = direction_of(furthest - first);
    Shadow at = no_shadow;
    for (const Segment& s : edges) {
        for (const Position p : {s.a, s.b}) {
            const double x = dot(u, p - first);
            const double y = cross(u, p - first);
            at.hold({x, x, y, y});
        }
    }
    return capsule_of({first, along<Position>(u, 1.0), at.along_low, at.along_high, at.across_low,
                       at.across_high});
}

ProbeShape rounded(const Outline& outline, Position held_at) {
    std::vector<Segment> edges = probes::edges_of(outline);
    for (Segment& edge : edges) edge = {edge.a - held_at, edge.b - held_at};
    return *ProbeShape::build(std::move(edges), corner_radius_m);
}

}  // namespace

void add_way(const ProbePose& from, const ProbeMove& move, std::vector<ProbePose>& way) {
    // How far the arc of the origin about the pivot leaves its chord.
    const double off_m = 0.125 * move.turn_rad * move.turn_rad * norm(move.pivot);
    const int parts = 1 + static_cast<int>(std::sqrt(off_m / way_error_m));
    for (int i = 1; i <= parts; ++i) way.push_back(from + (static_cast<double>(i) / parts) * move);
}

Result<ProbeShape> ProbeShape::build(std::vector<Segment> edges, double radius_m) {
    if (edges.empty()) return failure("the shape has no line; draw one outline at least");
    if (edges.size() > most_probe_edges) {
        return failure(fmt::format("the shape has {} edges; at most {} can be felt, simplify it",
                                   edges.size(), most_probe_edges));
    }
    if (!(radius_m >= 0.0 && radius_m <= largest_radius_m)) {
        return failure(fmt::format("a radius of {} m cannot be; it is 0 to 0.02 m", radius_m));
    }
    ProbeShape shape;
    for (const Segment& s : edges) {
        for (const Position p : {s.a, s.b}) {
            const double r_m = norm(p);
            if (!(r_m <= largest_probe_m)) {
                return failure(
                    fmt::format("the shape has a point {:.3g} m from its middle; at most 0.1 m "
                                "is possible, make it smaller or move it to the middle",
                                r_m));
            }
            shape.r_max_m_ = std::max(shape.r_max_m_, r_m);
        }
    }
    shape.edges_ = std::move(edges);
    shape.radius_m_ = radius_m;
    shape.nodes_.reserve(2 * shape.edges_.size());
    shape.nodes_.emplace_back();
    shape.split(0, 0, shape.edges_.size());
    return shape;
}

void ProbeShape::split(std::size_t node, std::size_t first, std::size_t last) {
    nodes_[node].capsule = capsule_of_edges(std::span(edges_).subspan(first, last - first));
    if (last - first == 1) {
        nodes_[node].edge = static_cast<std::int32_t>(first);
        return;
    }
    const std::size_t left = nodes_.size();
    nodes_[node].left = static_cast<std::int32_t>(left);
    nodes_.resize(left + 2);
    const std::size_t middle = first + (last - first) / 2;
    split(left, first, middle);
    split(left + 1, middle, last);
}

Result<ProbeShape> ProbeShape::of_map(const TactileMap& map, double radius_m) {
    std::vector<Segment> edges;
    for (const Outline& outline : map.outlines) {
        const auto more = probes::edges_of(outline);
        edges.insert(edges.end(), more.begin(), more.end());
    }
    return build(std::move(edges), radius_m);
}

namespace probes {
namespace {

Outline closed(std::vector<Position> points) {
    Outline outline;
    outline.points = std::move(points);
    outline.is_closed = true;
    return outline;
}

}  // namespace

std::vector<Segment> edges_of(const Outline& outline) {
    std::vector<Segment> edges;
    const auto& points = outline.points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) edges.push_back({points[i], points[i + 1]});
    if (outline.is_closed && points.size() > 2) edges.push_back({points.back(), points.front()});
    return edges;
}

ProbeShape disc(double radius_m) {
    return *ProbeShape::build({{}}, radius_m);
}

Outline bar(double length_m, double width_m) {
    const double l = 0.5 * length_m;
    const double w = 0.5 * width_m;
    return closed({{-l, -w}, {l, -w}, {l, w}, {-l, w}});
}

Outline ell(double leg_m, double width_m) {
    return closed({{0.0, 0.0},
                   {leg_m, 0.0},
                   {leg_m, width_m},
                   {width_m, width_m},
                   {width_m, leg_m},
                   {0.0, leg_m}});
}

Outline key(double length_m) {
    constexpr int bow_points = 13;
    const double l = length_m;
    const double bow_m = 0.25 * l;
    const double w = 0.06 * l;  // half the shank
    const double gap_rad = std::asin(w / bow_m);
    std::vector<Position> points;
    for (int i = 0; i < bow_points; ++i) {
        const double angle =
            gap_rad + (2.0 * std::numbers::pi - 2.0 * gap_rad) * i / (bow_points - 1);
        points.push_back({bow_m * std::cos(angle), bow_m * std::sin(angle)});
    }
    const std::vector<Position> bit{
        {0.66 * l, -w},       {0.66 * l, -0.22 * l}, {0.73 * l, -0.22 * l}, {0.73 * l, -0.1 * l},
        {0.83 * l, -0.1 * l}, {0.83 * l, -0.26 * l}, {0.9 * l, -0.26 * l},  {0.9 * l, w}};
    points.insert(points.end(), bit.begin(), bit.end());
    return closed(std::move(points));
}

}  // namespace probes

ProbeShape held_shape(HeldShape shape) {
    switch (shape) {
        case HeldShape::none:
            break;
        case HeldShape::disc:
            return probes::disc(disc_radius_m);
        case HeldShape::bar:
            return rounded(probes::bar(0.018, 0.004), {});
        case HeldShape::ell:
            return rounded(probes::ell(0.014, 0.004), {0.004, 0.004});
        case HeldShape::key:
            return rounded(probes::key(0.022), {0.007, 0.0});
    }
    return probes::disc(0.0);
}

}  // namespace touchline
