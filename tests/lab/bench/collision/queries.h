// One query a step, as renderers of run(): they move and judge nothing.
// Threads: one.
#pragma once

#include "haptics/collision/scene.h"
#include "tests/lab/bench/collision/crossing.h"

#include <optional>

namespace touchline::bench {

/// Asks for the crossing of the hand's own motion since the last step with the curve.
template <class Structure>
class CrossingQuery {
  public:
    /// `structure` must outlive the query.
    explicit CrossingQuery(const Structure& structure) : structure_(structure) {}

    void start(Position hand) { last_ = hand; }

    void reset(Position hand) { last_ = hand; }

    Position step(Position hand) {
        const bool is_crossed = structure_.first_crossing(last_, hand).has_value();
        const Position before = last_;
        last_ = hand;
        return is_crossed ? before : hand;
    }

  private:
    const Structure& structure_;
    Position last_;
};

/// Asks for the point of the curve that is nearest to the hand.
template <class Structure>
class NearestQuery {
  public:
    /// `structure` must outlive the query.
    explicit NearestQuery(const Structure& structure) : structure_(structure) {}

    void start(Position /*hand*/) {}

    void reset(Position /*hand*/) {}

    Position step(Position hand) { return structure_.nearest(hand).point; }

  private:
    const Structure& structure_;
};

/// Asks Touchline's collision tree at level 0 what the others are asked.
class FinestLevel {
  public:
    /// `scene` must outlive this object.
    explicit FinestLevel(const Scene& scene) : scene_(scene) {}

    /// Returns the share at which a point comes within the contact skin of the curve.
    [[nodiscard]] std::optional<double> first_crossing(Position from, Position to) const {
        const Hit hit =
            scene_.tree.first_hit(scene_.curves, {from, to, contact_skin_m, 0.0, {}}, {});
        return hit.is_hit ? std::optional(hit.clear) : std::nullopt;
    }

    [[nodiscard]] Nearest nearest(Position p) const {
        constexpr double anywhere_m = 1.0;
        const Closest found = scene_.tree.closest_point(scene_.curves, p, 0.0, anywhere_m);
        return {found.point, found.distance_m};
    }

  private:
    const Scene& scene_;
};

}  // namespace touchline::bench
