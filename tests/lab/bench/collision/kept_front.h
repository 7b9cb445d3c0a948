// The boundary section kept from step to step, as in the paper (section 3), with the
// distance-scheduled updates that it names. The product's start grid is measured against it. Has
// its own copy of the boxes, so that a step reads nothing else. Threads: one; no allocation in a
// step.
#pragma once

#include "config/types/vec2.h"
#include "haptics/collision/scene.h"
#include "haptics/collision/tree_walk.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace touchline::bench {

/// Node `index` of a level of a piece: a stretch of the curve. Piece -1 is the hierarchy over the
/// coarsest nodes of all pieces, in their order; each node of its level 1 holds two of them.
struct FrontNode {
    std::int32_t piece, level, index;

    friend auto operator<=>(const FrontNode&, const FrontNode&) = default;
};

class KeptFront {
  public:
    struct Options {
        int level = 0;             // whole; fixed
        double radius_m = 0.0;     // of the disc
        double margin_m = 0.0;     // a node is merged once the handle is farther from its box
        bool is_scheduled = true;  // false: every step tests every node of the front
    };

    /// `scene` must outlive the front. O(N).
    KeptFront(const Scene& scene, const Options& options);

    /// Puts the handle somewhere, with the hierarchy's top as the front. O(1) and a step.
    void place(Position handle);

    /// Returns the first contact of the disc on its straight way to `to`, like
    /// CollisionTree::first_hit (does not set spare_m; boxes are those tested). The handle is at
    /// `to` afterwards, contact or not.
    [[nodiscard]] Hit first_hit(Position to) {
        const Position from = handle_;
        handle_ = to;
        odometer_m_ += norm(to - from);
        // Merging waits too, because it changes no answer.
        if (options_.is_scheduled && odometer_m_ < static_cast<double>(least_due_)) return {};
        return test_due(from, to);
    }

    /// Returns the front in no order; a node of the hierarchy becomes the coarsest nodes below it.
    /// With margin 0 and no schedule this is the boundary section of the handle.
    [[nodiscard]] std::vector<FrontNode> front() const;

  private:
    using Floats = float __attribute__((vector_size(16)));
    static constexpr std::size_t lanes = 4;

    /// A box about its centre, grown by the reach of the disc. Metres.
    struct CentredBox {
        Position centre;
        Direction axis;
        double half_along = -1.0, half_across = -1.0;
    };

    /// Four boxes of the front side by side, and the odometer's readings at which they matter.
    struct Block {
        Floats x, y, axis_x, axis_y, half_along, half_across, due;
    };

    /// How a node's box lies to the way of the step.
    struct Reach {
        bool is_met;
        double beyond_m;  // the end of the way is at least this far outside; negative: inside
    };

    struct Query {
        FirstTouch first;
        Position middle, half;  // of the way
        int boxes = 0;
    };

    [[nodiscard]] std::size_t number(const FrontNode& node) const;

    [[nodiscard]] bool is_leaf(const FrontNode& node) const {
        return node.level <= options_.level && node.piece >= 0;
    }

    [[nodiscard]] Reach reach(const FrontNode& node, Query& query) const;
    [[nodiscard]] std::array<FrontNode, 2> children(const FrontNode& node, int& count) const;
    [[nodiscard]] CentredBox copied_box(const FrontNode& node) const;
    void copy_boxes();
    void build_hierarchy();
    void start_again();
    [[nodiscard]] Hit test_due(Position from, Position to);
    void set_odometer_back();
    void test_block(std::size_t block, Query& query);
    void refine(std::size_t slot, Query& query);
    void test_leaf(const FrontNode& node, Query& query) const;
    void descend(const FrontNode& node, Query& query) const;
    void merge_passed();
    void drop_children(const FrontNode& node);
    void drop(const FrontNode& node);
    void put(std::size_t slot, const FrontNode& node);
    void append(const FrontNode& node);
    void remove(std::size_t slot);
    void set_due(std::size_t slot, double beyond_m);
    void set_merge_due(std::size_t slot, double beyond_m);
    [[nodiscard]] double beyond_m(const FrontNode& node) const;

    const Scene& scene_;
    Options options_;
    std::vector<CentredBox> boxes_;  // of all nodes, in the order of the curves' points
    std::vector<FrontNode> roots_;   // the coarsest nodes of all pieces
    // For each level of the hierarchy, from 1: where its boxes begin, behind those of the pieces.
    std::vector<std::size_t> first_bound_;
    std::vector<std::size_t> bound_count_;
    std::vector<std::int32_t> place_;  // per live node: slot of the front, or ~slot of the split
    std::vector<Block> blocks_;        // the front
    std::vector<FrontNode> front_nodes_;
    std::vector<FrontNode> split_nodes_;  // nodes above the front
    std::vector<float> merge_due_;        // when each may have to be merged
    Position handle_;
    double odometer_m_ = 0.0;  // set back now and then, with all readings
    float least_due_ = 0.0F;   // no node of the front is due before this
    float least_merge_due_ = 0.0F;
};

}  // namespace touchline::bench
