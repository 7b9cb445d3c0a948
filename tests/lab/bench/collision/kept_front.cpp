#include "tests/lab/bench/collision/kept_front.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline::bench {
namespace {

constexpr std::size_t capacity = 65536;  // nodes of the front; it splits none beyond this
constexpr float never = std::numeric_limits<float>::infinity();

// Single precision in a field of 0.2 m: boxes are widened by the first and readings brought forward
// by the second, which includes the cost of setting the odometer back.
constexpr float rounding_m = 1e-7F;
constexpr double reading_m = 5e-7;
constexpr double odometer_end_m = 0.02;

/// More than the rounding of the copied boxes.
constexpr double copy_m = 1e-15;

template <class Vector>
Vector larger(Vector a, Vector b) {
    return a > b ? a : b;
}

template <class Vector>
Vector absolute(Vector a) {
    return larger(a, -a);
}

}  // namespace

KeptFront::KeptFront(const Scene& scene, const Options& options)
    : scene_(scene), options_(options) {
    copy_boxes();
    build_hierarchy();
    place_.resize(boxes_.size());
    blocks_.reserve(capacity / lanes + 1);
    front_nodes_.reserve(capacity);
    split_nodes_.reserve(capacity);
    merge_due_.reserve(capacity);
    start_again();
}

KeptFront::CentredBox KeptFront::copied_box(const FrontNode& node) const {
    const auto c = scene_.tree.box(scene_.curves, node.piece, node.level, node.index).corners;
    const Position along = c[1] - c[0];
    const Position across = c[3] - c[0];
    const bool is_turned = norm(across) > norm(along);
    const Direction axis = is_turned ? -left_of(direction_of(across)) : direction_of(along);
    const double grown_m = options_.radius_m + approach_tolerance_m + copy_m;
    return {0.5 * (c[0] + c[2]), axis, 0.5 * norm(along) + grown_m, 0.5 * norm(across) + grown_m};
}

void KeptFront::copy_boxes() {
    const CurveSet& curves = scene_.curves;
    boxes_.resize(curves.point_count());
    for (std::int32_t piece = 0; piece < static_cast<std::int32_t>(curves.pieces().size());
         ++piece) {
        const int coarsest = curves.pieces()[static_cast<std::size_t>(piece)].coarsest;
        for (int level = std::min(options_.level, coarsest); level <= coarsest; ++level) {
            for (int j = 0; j < curves.segment_count(piece, level); ++j) {
                const FrontNode node{piece, level, j};
                boxes_[number(node)] = copied_box(node);
                if (level == coarsest) roots_.push_back(node);
            }
        }
    }
}

/// The boxes are upright, each around its two parts.
void KeptFront::build_hierarchy() {
    std::size_t parts = roots_.size();
    for (std::int32_t level = 1; parts > 1; ++level) {
        const std::size_t count = (parts + 1) / 2;
        first_bound_.push_back(boxes_.size());
        bound_count_.push_back(count);
        for (std::size_t i = 0; i < count; ++i) {
            int held = 0;
            const auto below = children({-1, level, static_cast<std::int32_t>(i)}, held);
            Position low{INFINITY, INFINITY};
            Position high{-INFINITY, -INFINITY};
            for (int k = 0; k < held; ++k) {
                const CentredBox& box = boxes_[number(below[static_cast<std::size_t>(k)])];
                const double x = std::abs(box.axis.x) * box.half_along +
                                 std::abs(box.axis.y) * box.half_across + copy_m;
                const double y = std::abs(box.axis.y) * box.half_along +
                                 std::abs(box.axis.x) * box.half_across + copy_m;
                low = {std::min(low.x, box.centre.x - x), std::min(low.y, box.centre.y - y)};
                high = {std::max(high.x, box.centre.x + x), std::max(high.y, box.centre.y + y)};
            }
            const Position half = 0.5 * (high - low);
            boxes_.push_back({low + half, {1.0, 0.0}, half.x, half.y});
        }
        parts = count;
    }
}

std::size_t KeptFront::number(const FrontNode& node) const {
    const auto index = static_cast<std::size_t>(node.index);
    if (node.piece < 0) return first_bound_[static_cast<std::size_t>(node.level - 1)] + index;
    return scene_.curves.first_point(node.piece, node.level) + index;
}

void KeptFront::start_again() {
    blocks_.clear();
    front_nodes_.clear();
    split_nodes_.clear();
    merge_due_.clear();
    odometer_m_ = 0.0;
    least_due_ = 0.0F;
    least_merge_due_ = never;
    if (!first_bound_.empty()) {
        append({-1, static_cast<std::int32_t>(first_bound_.size()), 0});
    } else if (!roots_.empty()) {
        append(roots_[0]);
    }
}

void KeptFront::place(Position handle) {
    start_again();
    handle_ = handle;
    (void)first_hit(handle);
}

Hit KeptFront::test_due(Position from, Position to) {
    if (odometer_m_ > odometer_end_m) set_odometer_back();
    const Motion motion{from, to, options_.radius_m, static_cast<double>(options_.level), {}};
    Query query{FirstTouch(motion), 0.5 * (from + to), 0.5 * (to - from)};
    least_due_ = never;
    // The split itself tests the nodes that it appends, in double precision.
    const std::size_t blocks = blocks_.size();
    for (std::size_t b = 0; b < blocks; ++b) test_block(b, query);
    merge_passed();
    return query.first.result(INFINITY, query.boxes);
}

/// Readings are single precision, so the odometer is set back before it grows too coarse for them.
void KeptFront::set_odometer_back() {
    const auto back = static_cast<float>(odometer_m_);
    for (Block& block : blocks_) block.due -= back;
    for (float& due : merge_due_) due -= back;
    least_merge_due_ -= back;
    odometer_m_ -= static_cast<double>(back);
}

void KeptFront::test_block(std::size_t b, Query& query) {
    Block& block = blocks_[b];
    const auto now = static_cast<float>(odometer_m_);
    const auto is_due = block.due <= now;
    const auto any = [](auto mask) { return ((mask[0] | mask[1]) | (mask[2] | mask[3])) != 0; };
    unsigned met = 0;
    if (!options_.is_scheduled || any(is_due)) {
        query.boxes += static_cast<int>(lanes);
        const Floats x = static_cast<float>(query.middle.x) - block.x;
        const Floats y = static_cast<float>(query.middle.y) - block.y;
        const auto half_x = static_cast<float>(query.half.x);
        const auto half_y = static_cast<float>(query.half.y);
        const Floats s = block.axis_x * x + block.axis_y * y;
        const Floats n = block.axis_x * y - block.axis_y * x;
        const Floats ds = block.axis_x * half_x + block.axis_y * half_y;
        const Floats dn = block.axis_x * half_y - block.axis_y * half_x;
        const Floats reach_s = absolute(ds);
        const Floats reach_n = absolute(dn);
        const Floats gap = larger(absolute(s) - (reach_s + block.half_along),
                                  absolute(n) - (reach_n + block.half_across));
        const Floats beyond =
            larger(absolute(s + ds) - block.half_along, absolute(n + dn) - block.half_across);
        const auto is_apart =
            (gap > 0.0F) |
            (absolute(ds * n - dn * s) > reach_s * block.half_across + reach_n * block.half_along);
        const float soonest = now - static_cast<float>(reading_m);
        block.due = soonest + larger(beyond, Floats{});
        if (any(~is_apart)) {
            for (std::size_t k = 0; k < lanes; ++k) met |= is_apart[k] == 0 ? 1U << k : 0U;
        }
    }
    for (std::size_t k = 0; k < lanes; ++k) {
        if ((met & (1U << k)) != 0) {
            refine(b * lanes + k, query);
        } else {
            least_due_ = std::min(least_due_, block.due[k]);
        }
    }
}

KeptFront::Reach KeptFront::reach(const FrontNode& node, Query& query) const {
    ++query.boxes;
    const CentredBox& box = boxes_[number(node)];
    const Position w = query.middle - box.centre;
    const double s = dot(box.axis, w);
    const double n = cross(box.axis, w);
    const double ds = dot(box.axis, query.half);
    const double dn = cross(box.axis, query.half);
    const double reach_s = std::abs(ds);
    const double reach_n = std::abs(dn);
    const bool is_apart =
        (std::abs(s) > reach_s + box.half_along) | (std::abs(n) > reach_n + box.half_across) |
        (std::abs(ds * n - dn * s) > reach_s * box.half_across + reach_n * box.half_along);
    return {!is_apart,
            std::max(std::abs(s + ds) - box.half_along, std::abs(n + dn) - box.half_across)};
}

double KeptFront::beyond_m(const FrontNode& node) const {
    const CentredBox& box = boxes_[number(node)];
    const Position w = handle_ - box.centre;
    return std::max(std::abs(dot(box.axis, w)) - box.half_along,
                    std::abs(cross(box.axis, w)) - box.half_across);
}

std::array<FrontNode, 2> KeptFront::children(const FrontNode& node, int& count) const {
    const FrontNode first{node.piece, node.level - 1, 2 * node.index};
    const FrontNode second{node.piece, node.level - 1, 2 * node.index + 1};
    if (node.piece >= 0) {
        count = second.index < scene_.curves.segment_count(node.piece, first.level) ? 2 : 1;
        return {first, second};
    }
    const auto at = static_cast<std::size_t>(first.index);
    const std::size_t below =
        first.level == 0 ? roots_.size() : bound_count_[static_cast<std::size_t>(first.level - 1)];
    count = at + 1 < below ? 2 : 1;
    if (first.level > 0) return {first, second};
    return {roots_[at], roots_[count == 2 ? at + 1 : at]};
}

/// Tests a node that the way meets, or nearly, and splits it if the handle stays near it.
void KeptFront::refine(std::size_t slot, Query& query) {
    const FrontNode node = front_nodes_[slot];
    const Reach found = reach(node, query);
    const bool is_passed = found.beyond_m > options_.margin_m;
    if (!found.is_met || is_leaf(node) || is_passed || front_nodes_.size() == capacity) {
        if (found.is_met && is_leaf(node)) test_leaf(node, query);
        if (found.is_met && !is_leaf(node)) descend(node, query);
        set_due(slot, found.beyond_m);
        return;
    }
    int count = 0;
    const auto parts = children(node, count);
    place_[number(node)] = ~static_cast<std::int32_t>(split_nodes_.size());
    split_nodes_.push_back(node);
    merge_due_.push_back(0.0F);
    set_merge_due(split_nodes_.size() - 1, found.beyond_m);
    put(slot, parts[0]);
    const std::size_t second = front_nodes_.size();
    if (count == 2) append(parts[1]);
    refine(slot, query);
    if (count == 2) refine(second, query);
}

void KeptFront::test_leaf(const FrontNode& node, Query& query) const {
    query.first.test({node.piece, node.index},
                     scene_.curves.rendered_segment(node.piece, options_.level, node.index));
}

/// Looks at a node that the way only passes through, and leaves it as it is.
void KeptFront::descend(const FrontNode& node, Query& query) const {
    int count = 0;
    const auto parts = children(node, count);
    for (int i = 0; i < count; ++i) {
        const FrontNode& part = parts[static_cast<std::size_t>(i)];
        if (!reach(part, query).is_met) continue;
        if (is_leaf(part)) {
            test_leaf(part, query);
        } else {
            descend(part, query);
        }
    }
}

/// Returns nodes to the front once the handle has left them by more than the margin.
void KeptFront::merge_passed() {
    if (odometer_m_ < static_cast<double>(least_merge_due_)) return;
    least_merge_due_ = never;
    for (std::size_t slot = split_nodes_.size(); slot-- > 0;) {
        if (slot >= split_nodes_.size()) continue;  // removed with a node above it
        if (odometer_m_ < static_cast<double>(merge_due_[slot])) {
            least_merge_due_ = std::min(least_merge_due_, merge_due_[slot]);
            continue;
        }
        const FrontNode node = split_nodes_[slot];
        const double outside_m = beyond_m(node);
        if (outside_m <= options_.margin_m) {
            set_merge_due(slot, outside_m);
            continue;
        }
        drop_children(node);
        drop(node);
        append(node);
        set_due(front_nodes_.size() - 1, outside_m);
    }
}

void KeptFront::drop_children(const FrontNode& node) {
    int count = 0;
    const auto parts = children(node, count);
    for (int i = 0; i < count; ++i) {
        const FrontNode& part = parts[static_cast<std::size_t>(i)];
        const std::int32_t at = place_[number(part)];
        if (at >= 0) {
            remove(static_cast<std::size_t>(at));
        } else {
            drop_children(part);
            drop(part);
        }
    }
}

/// Removes a node from the split ones; the last takes its slot.
void KeptFront::drop(const FrontNode& node) {
    const std::int32_t at = place_[number(node)];
    const auto slot = static_cast<std::size_t>(~at);
    split_nodes_[slot] = split_nodes_.back();
    merge_due_[slot] = merge_due_.back();
    place_[number(split_nodes_[slot])] = at;
    split_nodes_.pop_back();
    merge_due_.pop_back();
}

void KeptFront::put(std::size_t slot, const FrontNode& node) {
    const CentredBox& box = boxes_[number(node)];
    Block& block = blocks_[slot / lanes];
    const std::size_t k = slot % lanes;
    block.x[k] = static_cast<float>(box.centre.x);
    block.y[k] = static_cast<float>(box.centre.y);
    block.axis_x[k] = static_cast<float>(box.axis.x);
    block.axis_y[k] = static_cast<float>(box.axis.y);
    block.half_along[k] = static_cast<float>(box.half_along) + rounding_m;
    block.half_across[k] = static_cast<float>(box.half_across) + rounding_m;
    block.due[k] = 0.0F;
    front_nodes_[slot] = node;
    place_[number(node)] = static_cast<std::int32_t>(slot);
}

void KeptFront::append(const FrontNode& node) {
    const std::size_t slot = front_nodes_.size();
    if (slot % lanes == 0) {
        constexpr Floats zero{};
        const Floats none = zero - 1.0F;  // a box that nothing meets
        blocks_.push_back(Block{zero, zero, zero, zero, none, none, zero + never});
    }
    front_nodes_.push_back(node);
    put(slot, node);
}

void KeptFront::remove(std::size_t slot) {
    const std::size_t last = front_nodes_.size() - 1;
    const float due = blocks_[last / lanes].due[last % lanes];
    put(slot, front_nodes_[last]);
    blocks_[slot / lanes].due[slot % lanes] = due;
    front_nodes_.pop_back();
    Block& block = blocks_[last / lanes];
    block.half_along[last % lanes] = -1.0F;
    block.half_across[last % lanes] = -1.0F;
    block.due[last % lanes] = never;
    if (last % lanes == 0) blocks_.pop_back();
}

void KeptFront::set_due(std::size_t slot, double beyond_m) {
    const auto due = static_cast<float>(odometer_m_ + std::max(beyond_m, 0.0) - reading_m);
    blocks_[slot / lanes].due[slot % lanes] = due;
    least_due_ = std::min(least_due_, due);
}

/// A node at the margin would be looked at in every step, so it is left for a quarter of the
/// margin.
void KeptFront::set_merge_due(std::size_t slot, double beyond_m) {
    const double left_m = std::max(options_.margin_m - beyond_m, 0.25 * options_.margin_m);
    merge_due_[slot] = static_cast<float>(odometer_m_ + left_m - reading_m);
    least_merge_due_ = std::min(least_merge_due_, merge_due_[slot]);
}

std::vector<FrontNode> KeptFront::front() const {
    std::vector<FrontNode> open = front_nodes_;
    std::vector<FrontNode> found;
    while (!open.empty()) {
        const FrontNode node = open.back();
        open.pop_back();
        if (node.piece >= 0) {
            found.push_back(node);
            continue;
        }
        int count = 0;
        const auto parts = children(node, count);
        open.insert(open.end(), parts.begin(), parts.begin() + count);
    }
    return found;
}

}  // namespace touchline::bench
