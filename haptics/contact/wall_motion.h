// Changes the level under the hand as a motion of the wall: the rendered curve moves a little way
// from one level towards another and carries the proxy along, on the side it had. If it finds no
// consistent place, nothing moves and the change waits. Threads: one, the servo's. No allocation.
#pragma once

#include "haptics/contact/proxy_state.h"
#include "haptics/contact/rendered_outlines.h"

#include <optional>

namespace touchline {

/// The result for a proxy in contact. Its segments are numbered at a single rendered level.
struct Carried {
    ProxyState proxy;
    double moved_m = 0.0;  // with the slide to the handle's foot that follows
};

class WallMotion {
  public:
    /// `to` is the level after the motion; it lies within one octave with that of `outlines`.
    WallMotion(const RenderedOutlines& outlines, double to, double radius_m, const Budget& budget);

    /// Returns the proxy after the motion, with no line crossed on the way. Returns nothing if
    /// there is no such place or the budget ended. A free proxy that a wall reaches becomes a
    /// contact. At most 6 queries.
    [[nodiscard]] std::optional<Carried> carry(const ProxyState& proxy, Position handle);

    /// The outlines after the motion.
    [[nodiscard]] const RenderedOutlines& after() const { return after_; }

    [[nodiscard]] int boxes() const { return boxes_; }

  private:
    using Excluded = std::array<SegmentRef, 2>;

    /// A vertex after the motion: the edge of a contact there and the edge beside it.
    struct Joint {
        SegmentRef beside;       // none at a line's end
        Direction own, other;    // normals on the contact's side
        Direction outward;       // along the own edge, out of it
        bool is_convex = false;  // seen from that side

        [[nodiscard]] bool holds(Direction normal) const;
    };

    [[nodiscard]] double way_m(const ProxyState& from, const ProxyState& to, Position handle) const;
    [[nodiscard]] std::optional<ProxyState> carry_free(const ProxyState& proxy);
    [[nodiscard]] std::optional<ProxyState> pushed(const ProxyState& proxy, const WallHit& hit);
    [[nodiscard]] std::optional<ProxyState> carry_edge(const ProxyState& proxy);
    [[nodiscard]] std::optional<ProxyState> carry_round(const ProxyState& proxy);
    [[nodiscard]] std::optional<ProxyState> carry_corner(const ProxyState& proxy);
    [[nodiscard]] std::optional<ProxyState> carry_between(const ProxyState& proxy);
    [[nodiscard]] Joint joint_of(const Contact& at, bool at_end);

    [[nodiscard]] bool is_way_free(Position from, Position to, const Excluded& before,
                                   const Excluded& halves, const Excluded& after);
    [[nodiscard]] bool is_free(RenderedOutlines& at, Position from, Position to,
                               const Excluded& excluded);
    [[nodiscard]] bool is_swept(Position p, const Excluded& halves);
    [[nodiscard]] WallHit first_wall(Position p, const Excluded& halves);

    [[nodiscard]] Contact halved(Contact contact) const;
    [[nodiscard]] Contact joined(Contact half) const;
    [[nodiscard]] bool is_pair(SegmentRef half) const;

    RenderedOutlines before_;
    RenderedOutlines after_;
    LevelChange change_;
    double radius_m_;
    Budget budget_;
    int boxes_ = 0;
    bool is_cut_ = false;
};

}  // namespace touchline
