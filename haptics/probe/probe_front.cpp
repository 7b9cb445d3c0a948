#include "haptics/probe/probe_front.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace touchline {
namespace {

constexpr int most_advances = 24;
constexpr double never = std::numeric_limits<double>::infinity();
constexpr double near_enough_m = 1e-10;  // to the kept distance: the motion ends there

/// How the room beside an end goes on over a move: room + rate t - bend t^2 / 2.
struct Falling {
    double room, rate, bend;
};

/// The room of an edge's end beyond `reach` along a fixed direction.
Falling falling(Position end, double reach, Direction n, Position origin, const ProbeMove& move) {
    const Position arm = end - origin;
    return {std::max(dot(n, end) - reach, 0.0), dot(n, move.by) + move.turn_rad * cross(arm, n),
            move.turn_rad * move.turn_rad * norm(arm)};
}

/// Returns the first moment at which the room falls to 0; infinity if it never does.
double exhausted(const Falling& f) {
    if (f.room <= 0.0 && f.rate <= 0.0) return f.rate < 0.0 || f.bend > 0.0 ? 0.0 : never;
    const double root = std::sqrt(f.rate * f.rate + 2.0 * f.bend * f.room);
    if (f.rate < 0.0) return 2.0 * f.room / (root - f.rate);
    return f.bend > 0.0 ? (root + f.rate) / f.bend : never;
}

/// Returns whether exhausted() is `share` or later: a falling parabola is above its ends in
/// between.
bool lasts(const Falling& f, double share) {
    return f.room + share * (f.rate - 0.5 * f.bend * share) >= 0.0;
}

/// Returns whether free_beside_line() would find `share` or more. This settles most pairs, and
/// without a root.
bool is_free_beside_line(const Segment& edge, const Segment& line, Direction n, Position origin,
                         const ProbeMove& move, double keep_m, double share) {
    const double reach = std::max(dot(n, line.a), dot(n, line.b)) + keep_m;
    return lasts(falling(edge.a, reach, n, origin, move), share) &&
           lasts(falling(edge.b, reach, n, origin, move), share);
}

/// Goes until the ends of the edge are too near along a fixed direction.
double free_beside_line(const Segment& edge, const Segment& line, Direction n, Position origin,
                        const ProbeMove& move, double keep_m) {
    const double reach = std::max(dot(n, line.a), dot(n, line.b)) + keep_m;
    return std::min({never, exhausted(falling(edge.a, reach, n, origin, move)),
                     exhausted(falling(edge.b, reach, n, origin, move))});
}

/// Goes until the ends of the line are too near along a direction that turns with the edge.
double free_beside_edge(const Segment& edge, const Segment& line, Direction n, Position origin,
                        const ProbeMove& move, double keep_m) {
    const double reach = std::min(dot(n, edge.a), dot(n, edge.b)) - keep_m;
    const double way_m = norm(move.by);
    const double turn = std::abs(move.turn_rad);
    double free = never;
    for (const Position end : {line.a, line.b}) {
        const Position arm = end - origin;
        const double rate = dot(n, move.by) - move.turn_rad * dot(left_of(n), arm);
        const double bend = turn * (turn * (norm(arm) + way_m) + 2.0 * way_m);
        free = std::min(free, exhausted({std::max(reach - dot(n, end), 0.0), rate, bend}));
    }
    return free;
}

constexpr std::size_t most_pairs = 4096;
constexpr std::size_t most_near = 512;
constexpr std::size_t block = 32;
constexpr double margin_m = 2e-3;     // of the way, before a front is made anew
constexpr double straight_m = 1e-10;  // a node no thicker counts as the line that it holds
constexpr double now = -std::numeric_limits<double>::infinity();
constexpr std::int32_t rendered = -1;  // as a node's level

double half_size(const Capsule& capsule) {
    return norm(capsule.chord.b - capsule.chord.a) + 2.0 * capsule.thickness_m;
}

}  // namespace

double clear_share(const EdgeAndLine& pair, const ProbePose& from, const ProbePlacement& start,
                   const ProbeMove& move, double keep_m, double most) {
    Separation at = pair.at;
    Segment edge = start(pair.edge);
    double share = 0.0;
    for (int i = 0; i < most_advances; ++i) {
        if (!(at.distance_m > 0.0)) return share;
        const Position origin = from.place() + share * move.by;
        const Direction n = at.normal;
        if (is_free_beside_line(edge, pair.line, n, origin, move, keep_m, most - share))
            return most;
        share += std::max(free_beside_line(edge, pair.line, n, origin, move, keep_m),
                          free_beside_edge(edge, pair.line, n, origin, move, keep_m));
        if (!(share < most)) return most;
        edge = ProbePlacement(from + share * move)(pair.edge);
        at = separation(edge, pair.line);
        if (at.distance_m - keep_m <= near_enough_m) return share;
    }
    return share;
}

void ProbeFront::reserve() {
    due_m_.reserve(most_pairs);
    block_due_m_.reserve(most_pairs / block + 1);
    pairs_.reserve(most_pairs);
    near_.reserve(most_near);
}

void ProbeFront::reset(const ProbeShape& shape, const Scene& scene, double level, FrontEnd end) {
    shape_ = &shape;
    end_ = end;
    outlines_ = RenderedOutlines(scene, level);
    reserve();
    is_stale_ = true;
}

void ProbeFront::set_level(double level) {
    outlines_ = RenderedOutlines(outlines_.scene(), level);
    is_stale_ = true;
}

void ProbeFront::remake(double reach_m) {
    due_m_.clear();
    block_due_m_.clear();
    pairs_.clear();
    way_m_ = 0.0;
    far_m_ = margin_m + 2.0 * reach_m;
    is_stale_ = false;
    if (!outlines_.scene().tree.has_nodes()) return;
    add({CollisionTree::top(), 0});
}

void ProbeFront::look(const ProbePlacement& shape, double keep_m, double reach_m,
                      Spender& spender) {
    near_.clear();
    unopened_m_ = INFINITY;
    const bool is_full = pairs_.size() > most_pairs - most_pairs / 4;
    if (is_stale_ || is_full || way_m_ + reach_m >= far_m_) remake(reach_m);
    const Look at{shape, keep_m, reach_m, spender};
    for (std::size_t i = 0; i * block < due_m_.size(); ++i) {
        if (block_due_m_[i] <= way_m_ + reach_m) look_at_block(i * block, at);
    }
}

void ProbeFront::look_at_block(std::size_t first, const Look& look) {
    const double limit = way_m_ + look.reach_m;
    const auto end = [&] { return std::min(first + block, due_m_.size()); };
    for (std::size_t i = first; i < end();) {
        if (due_m_[i] > limit || examine(i, look)) ++i;
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = first; i < end(); ++i) least = std::min(least, due_m_[i]);
    block_due_m_[first / block] = least;
}

void ProbeFront::add(const Pair& pair) {
    const std::size_t i = due_m_.size() / block;
    if (i == block_due_m_.size()) block_due_m_.push_back(now);
    block_due_m_[i] = now;
    pairs_.push_back(pair);
    due_m_.push_back(now);
}

bool ProbeFront::examine(std::size_t i, const Look& look) {
    Pair& pair = pairs_[i];
    const ProbeNode& probe = shape_->nodes()[static_cast<std::size_t>(pair.probe)];
    if (!pair.is_known) {
        pair.scene = capsule(pair.node, pair.is_end);
        pair.is_known = true;
    }
    const bool is_end = pair.is_end;
    const Capsule& scene = pair.scene;
    const Segment chord = look.shape(probe.capsule.chord);
    const Separation at = separation(chord, scene.chord);
    const double gap_m =
        at.distance_m - probe.capsule.thickness_m - scene.thickness_m - look.keep_m;
    if (gap_m > look.reach_m) {
        if (way_m_ + gap_m > far_m_) {
            drop(i);
            return false;
        }
        due_m_[i] = way_m_ + gap_m;
        return true;
    }
    if (is_end && probe.edge >= 0) {
        due_m_[i] = way_m_ + gap_m;
        if (near_.size() < most_near) {
            const Segment& edge = shape_->edges()[static_cast<std::size_t>(probe.edge)];
            near_.push_back({{edge, scene.chord, at}, pair.node});
        } else {
            unopened_m_ = std::min(unopened_m_, gap_m);
        }
        return true;
    }
    const bool is_scene =
        probe.edge >= 0 || (!is_end && half_size(scene) > half_size(probe.capsule));
    if (look.spender.spend(1) && split(i, is_scene)) return false;
    due_m_[i] = now;
    unopened_m_ = std::min(unopened_m_, gap_m);
    return true;
}

bool ProbeFront::split(std::size_t i, bool is_scene) {
    if (pairs_.size() + 3 > most_pairs) return false;
    const Pair pair = pairs_[i];
    std::array<Pair, 4> parts;
    std::size_t count = 2;
    if (is_scene) {
        const TreeChildren children = parts_of(pair.node);
        count = static_cast<std::size_t>(children.count);
        for (std::size_t k = 0; k < count; ++k) parts[k] = {children.nodes[k], pair.probe};
    } else {
        const std::int32_t left = shape_->nodes()[static_cast<std::size_t>(pair.probe)].left;
        parts[0] = {pair.node, left};
        parts[1] = {pair.node, left + 1};
    }
    replace(i, {parts.data(), count});
    return true;
}

void ProbeFront::replace(std::size_t i, std::span<const Pair> parts) {
    if (parts.empty()) {
        drop(i);
        return;
    }
    pairs_[i] = parts[0];
    due_m_[i] = now;
    for (const Pair& part : parts.subspan(1)) add(part);
}

void ProbeFront::drop(std::size_t i) {
    pairs_[i] = pairs_.back();
    due_m_[i] = due_m_.back();
    pairs_.pop_back();
    due_m_.pop_back();
}

/// Returns the level of the nodes that hold a piece as rendered.
int ProbeFront::leaf_level(int piece) const {
    return static_cast<int>(
        std::ceil(outlines_.scene().curves.rendered_level(piece, outlines_.level())));
}

/// Goes down to the nodes that hold the rendered curve, then to its segments: two for a blend.
TreeChildren ProbeFront::parts_of(const TreeNode& node) const {
    const Scene& scene = outlines_.scene();
    if (node.piece < 0 || node.level > leaf_level(node.piece)) {
        return scene.tree.children(scene.curves, node);
    }
    const double level = scene.curves.rendered_level(node.piece, outlines_.level());
    if (level == node.level) return {{{{node.piece, rendered, node.index}}}, 1};
    const int first = 2 * node.index;
    const bool has_two = first + 1 < scene.curves.rendered_count(node.piece, level);
    return {{{{node.piece, rendered, first}, {node.piece, rendered, first + 1}}}, has_two ? 2 : 1};
}

SegmentRef ProbeFront::segment_of(const NearPair& pair) const {
    const TreeNode& node = pair.node;
    if (node.level == rendered) return {node.piece, node.index};
    const CurveSet& curves = outlines_.scene().curves;
    const double level = curves.rendered_level(node.piece, outlines_.level());
    const int parts = 1 << (node.level - static_cast<int>(std::floor(level)));
    const double t = foot(pair.geometry.at.on_second, pair.geometry.line).parameter;
    const int part = std::min(static_cast<int>(t * parts), parts - 1);
    const int last = curves.rendered_count(node.piece, level) - 1;
    return {node.piece, std::min(node.index * parts + part, last)};
}

Capsule ProbeFront::capsule(const TreeNode& node, bool& is_end) {
    is_end = node.level == rendered;
    if (is_end) return {outlines_.segment({node.piece, node.index}), 0.0};
    const Scene& scene = outlines_.scene();
    const Box box = scene.tree.box_of_node(scene.curves, node);
    Capsule capsule = capsule_of(box);
    if (node.piece < 0) return capsule;
    if (end_ == FrontEnd::nodes) {
        is_end = node.level == leaf_level(node.piece);
        return capsule;
    }
    is_end = capsule.thickness_m <= straight_m && box.along_low >= 0.0 && box.along_high <= 1.0;
    if (is_end) capsule.thickness_m = 0.0;
    return capsule;
}

}  // namespace touchline
