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

/// A motion from a moment on: the pivot's place, its move, and the share of the move that is left.
struct MotionLeft {
    Position pivot;
    const ProbeMove& move;
    double left;
};

/// The room of an edge's end beyond `reach` along a fixed direction. The end turns about the pivot,
/// so it speeds up towards it: by what points along the direction now, and what turns into it.
Falling falling(Position end, double reach, Direction n, const MotionLeft& motion) {
    const double turn = motion.move.turn_rad;
    const Position arm = end - motion.pivot;
    const double size = norm(arm);
    const double along = std::max(dot(n, arm), 0.0) + std::abs(turn) * motion.left * size;
    return {std::max(dot(n, end) - reach, 0.0), dot(n, motion.move.by) + turn * cross(arm, n),
            turn * turn * std::min(along, size)};
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

/// Returns the share over which the ends of the edge are not too near along a fixed direction;
/// infinity if that is all that is left. Most pairs are settled so, without a root.
double free_beside_line(const Segment& edge, const Segment& line, Direction n,
                        const MotionLeft& motion, double keep_m) {
    const double reach = std::max(dot(n, line.a), dot(n, line.b)) + keep_m;
    const Falling a = falling(edge.a, reach, n, motion);
    const Falling b = falling(edge.b, reach, n, motion);
    if (lasts(a, motion.left) && lasts(b, motion.left)) return never;
    return std::min(exhausted(a), exhausted(b));
}

/// Goes until the ends of the line are too near along a direction that turns with the edge.
double free_beside_edge(const Segment& edge, const Segment& line, Direction n,
                        const MotionLeft& motion, double keep_m) {
    const double reach = std::min(dot(n, edge.a), dot(n, edge.b)) - keep_m;
    const Position by = motion.move.by;
    const double turn = motion.move.turn_rad;
    const double way_m = norm(by);
    double free = never;
    for (const Position end : {line.a, line.b}) {
        const Position arm = end - motion.pivot;
        const double rate = dot(n, by) - turn * dot(left_of(n), arm);
        const double bend = -turn * (turn * dot(n, arm) + 2.0 * dot(left_of(n), by));
        const double more =
            turn * turn * (std::abs(turn) * (norm(arm) + way_m) + 3.0 * way_m) * motion.left;
        free = std::min(free, exhausted({std::max(reach - dot(n, end), 0.0), rate,
                                         std::max(bend, 0.0) + more}));
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

/// Returns how far the chord of a shape, in its frame, is from a line along a direction: at most
/// their distance.
double room_along(Direction n, const ProbePlacement& shape, const Segment& chord,
                  const Segment& line) {
    const Direction m = shape.seen_by_shape(n);
    return dot(n, shape.origin()) + std::min(dot(m, chord.a), dot(m, chord.b)) -
           std::max(dot(n, line.a), dot(n, line.b));
}

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
        const MotionLeft motion{from.place() + move.pivot + share * move.by, move, most - share};
        const Direction n = at.normal;
        const double beside_line = free_beside_line(edge, pair.line, n, motion, keep_m);
        if (beside_line == never) return most;
        const double next =
            share + std::max(beside_line, free_beside_edge(edge, pair.line, n, motion, keep_m));
        if (next >= most) return most;
        if (!(next > share)) return share;
        share = next;
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
    look({shape, keep_m, reach_m, spender});
}

void ProbeFront::look_along(const ProbeMove& move, const ProbePlacement& shape, double keep_m,
                            Spender& spender) {
    look({shape, keep_m, move.reach_m(shape_->r_max_m()), spender, &move});
}

void ProbeFront::look(const Look& look) {
    near_.clear();
    unopened_m_ = INFINITY;
    const bool is_full = pairs_.size() > most_pairs - most_pairs / 4;
    if (is_stale_ || is_full || way_m_ + look.reach_m >= far_m_) remake(look.reach_m);
    const double limit = way_m_ + look.reach_m;
    for (std::size_t i = 0; i * block < due_m_.size(); ++i) {
        if (block_due_m_[i] <= limit) look_at_block(i * block, look);
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
    const double kept_m = probe.capsule.thickness_m + scene.thickness_m + look.keep_m;
    const double room_m = room_along(pair.at.normal, look.shape, probe.capsule.chord, scene.chord);
    bool is_past = is_apart(i, room_m - kept_m, look);
    if (!is_past && pair.seen != moves_) {
        pair.at = separation(look.shape(probe.capsule.chord), scene.chord);
        pair.seen = moves_;
        is_past = is_apart(i, pair.at.distance_m - kept_m, look);
    }
    if (is_past) {
        const bool is_far = due_m_[i] > far_m_;
        if (is_far) drop(i);
        return !is_far;
    }
    const double gap_m = pair.at.distance_m - kept_m;
    due_m_[i] = way_m_ + gap_m;
    if (is_end && probe.edge >= 0) {
        if (near_.size() < most_near) {
            const Segment& edge = shape_->edges()[static_cast<std::size_t>(probe.edge)];
            near_.push_back({{edge, scene.chord, pair.at}, pair.node});
            return true;
        }
        unopened_m_ = std::min(unopened_m_, gap_m);
        return true;
    }
    const bool is_scene =
        probe.edge >= 0 || (!is_end && half_size(scene) > half_size(probe.capsule));
    if (look.spender.spend(1) && split(i, is_scene)) return false;
    due_m_[i] = now;
    unopened_m_ = std::min(unopened_m_, gap_m);
    return true;
}

/// Returns whether pair i, `gap_m` off along its normal, stays apart. A point that turns falls
/// short of its rate at the start by at most `bend_m`.
bool ProbeFront::is_apart(std::size_t i, double gap_m, const Look& look) {
    due_m_[i] = way_m_ + gap_m;
    if (gap_m > look.reach_m) return true;
    if (look.move == nullptr || !(gap_m >= 0.0)) return false;
    const Pair& pair = pairs_[i];
    const Capsule& probe = shape_->nodes()[static_cast<std::size_t>(pair.probe)].capsule;
    const ProbeMove& move = *look.move;
    const double turn = move.turn_rad;
    const Direction n = look.shape.seen_by_shape(pair.at.normal);
    const double turned_m =
        std::min(turn * cross(probe.chord.a, n), turn * cross(probe.chord.b, n));
    const double left_m = gap_m + dot(pair.at.normal, move.origin_by()) + turned_m -
                          std::abs(turn) * probe.thickness_m - move.bend_m(shape_->r_max_m());
    return left_m >= 0.0;
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
    for (Pair& part : parts) part.at.normal = pair.at.normal;
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
