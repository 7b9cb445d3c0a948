// The first hit by the hierarchy alone, as a TreeWalk visitor. It does for any motion what
// CollisionTree::first_hit() does for long ones, and counts what it looks at. Threads: a value.
#pragma once

#include "haptics/collision/box.h"
#include "haptics/collision/scene.h"
#include "haptics/collision/touch.h"
#include "haptics/collision/tree_walk.h"

#include <limits>
#include <optional>

namespace touchline {

class HierarchyHit {
  public:
    static constexpr bool asks_leaf_boxes = false;

    explicit HierarchyHit(const Motion& motion, int most_boxes = std::numeric_limits<int>::max())
        : motion_(motion),
          way_{motion.from, motion.to - motion.from, motion.radius_m + approach_tolerance_m},
          most_boxes_(most_boxes) {}

    /// Returns the share of the motion up to the nearest box left unopened.
    double walk(const Scene& scene) {
        return TreeWalk(scene.tree, scene.curves, motion_.level, *this).run();
    }

    [[nodiscard]] Sifted sift(const Fan& fan) const { return touchline::sift(fan, way_); }

    [[nodiscard]] std::optional<double> near(const Box& box) const {
        const Approach found = approach(box, way_);
        return found.is_met ? std::optional(found.entry) : std::nullopt;
    }

    [[nodiscard]] double cut() const { return is_hit_ ? share_ : 1.0; }

    bool spend(int boxes) {
        if (boxes_ + boxes > most_boxes_) return false;
        boxes_ += boxes;
        return true;
    }

    void leaf(SegmentRef /*ref*/, const Segment& segment) {
        ++leaves_;
        const auto found = touch(motion_.from, motion_.to, motion_.radius_m, segment);
        if (!found || (is_hit_ && found->fraction >= share_)) return;
        is_hit_ = true;
        share_ = found->fraction;
    }

    [[nodiscard]] bool is_hit() const { return is_hit_; }

    /// The share of the motion at the first touch; 1 if there is none.
    [[nodiscard]] double share() const { return share_; }

    [[nodiscard]] int boxes() const { return boxes_; }

    [[nodiscard]] int leaves() const { return leaves_; }

  private:
    Motion motion_;
    Way way_;
    int most_boxes_;
    bool is_hit_ = false;
    double share_ = 1.0;
    int boxes_ = 0;
    int leaves_ = 0;
};

}  // namespace touchline
