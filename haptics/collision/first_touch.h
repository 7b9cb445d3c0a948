// Finds the first of several segments that a motion touches. Threads: a value on the stack of the
// query.
#pragma once

#include "haptics/collision/collision_tree.h"
#include "haptics/collision/sift.h"
#include "haptics/collision/touch.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace touchline {

/// Collects the first of several touches; ties go to the lowest segment.
class FirstTouch {
  public:
    explicit FirstTouch(const Motion& motion) : motion_(motion), way_(way_of(motion)) {}

    [[nodiscard]] const Way& way() const { return way_; }

    /// Boxes not looked at stay at least this far out of reach.
    void spare(double margin_m) { least_gap2_m2_ = std::min(least_gap2_m2_, margin_m * margin_m); }

    Sifted sift(const Fan& fan) {
        const Sifted found = touchline::sift(fan, way_);
        least_gap2_m2_ = std::min(least_gap2_m2_, static_cast<double>(found.gap2_m2));
        return found;
    }

    /// Returns the share of the way at which a box is entered; nothing if the box cannot matter.
    [[nodiscard]] std::optional<double> near(const Box& box) {
        const Approach found = approach(box, way_);
        if (found.is_met) return found.entry;
        least_gap2_m2_ = std::min(least_gap2_m2_, found.gap2_m2);
        return {};
    }

    [[nodiscard]] double cut() const { return hit_.is_hit ? hit_.clear + tie_ : 1.0; }

    void test(SegmentRef ref, const Segment& segment) {
        if (ref == motion_.excluded[0] || ref == motion_.excluded[1]) return;
        least_gap2_m2_ = 0.0;
        tie_ = tie_of(motion_);
        const auto found = touch(motion_.from, motion_.to, motion_.radius_m, segment);
        if (!found) return;
        if (hit_.is_hit && found->fraction > hit_.clear + tie_) return;
        const bool is_tie = hit_.is_hit && found->fraction >= hit_.clear - tie_;
        const bool is_kept = is_tie && hit_.segment < ref;
        const double clear = is_tie ? std::min(hit_.clear, found->fraction) : found->fraction;
        if (!is_kept) hit_ = {true, clear, ref, *found, 0};
        hit_.clear = clear;
    }

    /// `unopened` is the earliest moment at which a box left unopened is met. A hit counts only
    /// before it.
    [[nodiscard]] Hit result(double unopened, int opened) {
        if (unopened <= cut()) {
            const double clear = std::min(unopened, hit_.is_hit ? hit_.clear : 1.0);
            hit_ = {};
            hit_.clear = clear;
        } else if (!hit_.is_hit) {
            hit_.spare_m = std::sqrt(least_gap2_m2_);
        }
        hit_.boxes = opened;
        return hit_;
    }

  private:
    /// The tolerance is larger than all rounding: no box is entered later than its content is
    /// touched.
    static Way way_of(const Motion& motion) {
        return {motion.from, motion.to - motion.from, motion.radius_m + approach_tolerance_m};
    }

    /// The share of the motion within which two contacts count as one moment.
    static double tie_of(const Motion& motion) {
        constexpr double few_ulp = 8.9e-16;
        if (motion.radius_m == 0.0) return few_ulp;
        return approach_tolerance_m / std::max(norm(motion.to - motion.from), 1e-30);
    }

    const Motion& motion_;
    Way way_;
    double tie_ = 0.0;  // worked out at the first segment
    double least_gap2_m2_ = INFINITY;
    Hit hit_;
};

}  // namespace touchline
