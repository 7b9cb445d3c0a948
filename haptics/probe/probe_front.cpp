#include "haptics/probe/probe_front.h"

#include "haptics/probe/kept_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace touchline {
namespace {

constexpr std::size_t most_pairs = 4096;
constexpr std::size_t most_near = 512;
constexpr std::size_t block = 16;
constexpr double margin_m = 4e-3;     // of the way, before a front is made anew
constexpr double straight_m = 1e-10;  // a node no thicker counts as the line that it holds
constexpr double now = -std::numeric_limits<double>::infinity();
constexpr std::int32_t rendered = -1;  // as a node's level

/// Returns the least of up to a block; infinity of none. In four chains, as no minimum waits for
/// the one before.
double least_of(std::span<const double> due_m) {
    using lanes::Pair;
    Pair low{INFINITY, INFINITY};
    Pair high{INFINITY, INFINITY};
    std::size_t i = 0;
    for (; i + 4 <= due_m.size(); i += 4) {
        const Pair a{due_m[i], due_m[i + 1]};
        const Pair b{due_m[i + 2], due_m[i + 3]};
        low = a < low ? a : low;
        high = b < high ? b : high;
    }
    const Pair both = low < high ? low : high;
    double least = std::min(both[0], both[1]);
    for (; i < due_m.size(); ++i) least = std::min(least, due_m[i]);
    return least;
}

double half_size(const Capsule& capsule) {
    return norm(capsule.chord.b - capsule.chord.a) + 2.0 * capsule.thickness_m;
}

}  // namespace

void ProbeFront::reserve() {
    due_m_.reserve(most_pairs);
    block_due_m_.reserve(most_pairs / block + 1);
    sights_.reserve(most_pairs);
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
    sights_.clear();
    pairs_.clear();
    way_m_ = 0.0;
    far_m_ = margin_m + 2.0 * reach_m;
    is_stale_ = false;
    if (!outlines_.scene().tree.has_nodes()) return;
    Pair top;
    see_scene(top, CollisionTree::top());
    add(top, {0.0, 0.0});
}

void ProbeFront::look(const ProbePlacement& shape, double keep_m, double reach_m,
                      Spender& spender) {
    look({shape, keep_m, reach_m, spender});
}

void ProbeFront::look_along(const ProbeMove& move, const ProbePlacement& shape, double keep_m,
                            Spender& spender) {
    const double r_max_m = shape_->r_max_m();
    look({shape, keep_m, move.reach_m(r_max_m) + probe_mind_m, spender, &move, move.origin_by(),
          move.bend_m(r_max_m), probe_mind_m});
}

void ProbeFront::look_again(const ProbePlacement& shape) {
    for (const std::uint32_t i : near_) {
        if (pairs_[i].seen != moves_) see(i, shape);
    }
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

/// Leaves a pair that stays apart until its allowance is used up. Returns false if it is so far off
/// that it is dropped.
inline bool ProbeFront::put_off(std::size_t i, double gap_m) {
    due_m_[i] = way_m_ + gap_m;
    const bool is_far = due_m_[i] > far_m_;
    if (is_far) drop(i);
    return !is_far;
}

void ProbeFront::look_at_block(std::size_t first, const Look& look) {
    const double limit = way_m_ + look.reach_m;
    const auto end = [&] { return std::min(first + block, due_m_.size()); };
    for (std::size_t i = first; i < end();) {
        if (due_m_[i] > limit) {
            ++i;
            continue;
        }
        const double gap_m = sights_[i].gap_m(look);
        if (sights_[i].leaves_room(gap_m, look) ? put_off(i, gap_m) : examine(i, look)) ++i;
    }
    block_due_m_[first / block] = least_of(std::span(due_m_).subspan(first, end() - first));
}

void ProbeFront::add(const Pair& pair, Direction normal) {
    const std::size_t i = due_m_.size();
    if (i / block == block_due_m_.size()) block_due_m_.push_back(now);
    block_due_m_[i / block] = now;
    due_m_.push_back(now);
    pairs_.emplace_back();
    sights_.emplace_back();
    put(i, pair, normal);
}

void ProbeFront::put(std::size_t i, const Pair& pair, Direction normal) {
    const Capsule& probe = shape_->nodes()[static_cast<std::size_t>(pair.probe)].capsule;
    due_m_[i] = now;
    pairs_[i] = pair;
    pairs_[i].ends.geometry.edge = probe.chord;
    sights_[i].chord = probe.chord;
    sights_[i].probe_thick_m = probe.thickness_m;
    sights_[i].thick_m = probe.thickness_m + pair.scene_thick_m;
    sights_[i].turn(normal, pair.ends.geometry.line);
}

void ProbeFront::see(std::size_t i, const ProbePlacement& shape) {
    EdgeAndLine& pair = pairs_[i].ends.geometry;
    pair.at = separation(shape(sights_[i].chord), pair.line);
    pairs_[i].seen = moves_;
    sights_[i].turn(pair.at.normal, pair.line);
}

bool ProbeFront::examine(std::size_t i, const Look& look) {
    const Sight& sight = sights_[i];
    const Pair& pair = pairs_[i];
    const bool is_new = pair.seen != moves_;
    if (is_new) see(i, look.shape);
    const double gap_m = pair.ends.geometry.at.distance_m - (sight.thick_m + look.keep_m);
    if (is_new && sight.leaves_room(gap_m, look)) return put_off(i, gap_m);
    due_m_[i] = way_m_ + gap_m;
    const ProbeNode& probe = shape_->nodes()[static_cast<std::size_t>(pair.probe)];
    if (pair.is_end && probe.edge >= 0) {
        if (near_.size() < most_near) {
            near_.push_back(static_cast<std::uint32_t>(i));
            return true;
        }
        unopened_m_ = std::min(unopened_m_, gap_m);
        return true;
    }
    const bool is_scene =
        probe.edge >= 0 ||
        (!pair.is_end &&
         half_size({pair.ends.geometry.line, pair.scene_thick_m}) > half_size(probe.capsule));
    if (look.spender.spend(1) && split(i, is_scene)) return false;
    due_m_[i] = now;
    unopened_m_ = std::min(unopened_m_, gap_m);
    return true;
}

/// Puts the parts of a pair in its place and behind the others. Returns false if they do not fit.
bool ProbeFront::split(std::size_t i, bool is_scene) {
    if (pairs_.size() + 3 > most_pairs) return false;
    Pair part = pairs_[i];
    part.seen = 0;
    const Direction normal = part.ends.geometry.at.normal;
    const auto give = [&](bool is_first) {
        if (is_first) {
            put(i, part, normal);
        } else {
            add(part, normal);
        }
    };
    if (!is_scene) {
        part.probe = shape_->nodes()[static_cast<std::size_t>(part.probe)].left;
        give(true);
        ++part.probe;
        give(false);
        return true;
    }
    const TreeChildren children = parts_of(part.ends.node);
    if (children.count == 0) drop(i);
    for (int k = 0; k < children.count; ++k) {
        see_scene(part, children.nodes[static_cast<std::size_t>(k)]);
        give(k == 0);
    }
    return true;
}

void ProbeFront::drop(std::size_t i) {
    sights_[i] = sights_.back();
    pairs_[i] = pairs_.back();
    due_m_[i] = due_m_.back();
    sights_.pop_back();
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

void ProbeFront::see_scene(Pair& pair, const TreeNode& node) {
    const Capsule scene = capsule(node, pair.is_end);
    pair.ends.node = node;
    pair.ends.geometry.line = scene.chord;
    pair.scene_thick_m = scene.thickness_m;
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
