// The paper's three-state contact machine (section 4) for a disc-shaped proxy, and what it does
// beside the paper: a wall lets a determined hand through, and the force fades over where the
// machine itself has changed it. Threads: one, the servo's. No allocation, lock, clock or log in
// step().
#pragma once

#include "config/types/hand_state.h"
#include "config/types/vec2.h"
#include "haptics/collision/scene.h"
#include "haptics/contact/groove.h"
#include "haptics/contact/proxy_state.h"
#include "haptics/contact/rendered_outlines.h"

#include <optional>
#include <vector>

namespace touchline {

// A level changes under the hand as a motion of the wall: the rendered curve moves a little way
// from one level towards another and carries the proxy along, on the side it had. If it finds no
// consistent place, nothing moves and the change waits.

/// What a motion of the wall may do to the hand in a tick.
struct WallAllowance {
    double stiffness_N_per_m = 0.0;
    double push_N = 0.0;
    double work_J = 0.0;
};

/// Where a motion of the wall takes the proxy. Its segments are numbered at a single rendered
/// level.
struct Carried {
    ProxyState proxy;
    double push_N = 0.0;  // on the hand, with the slide to the handle's foot that follows
    double work_J = 0.0;
    bool is_allowed = true;  // false: more than allowed, and whether the way is free is not known
};

class MovingWall {
  public:
    /// `to` is the level after the motion; it lies within one octave with that of `outlines`.
    MovingWall(const RenderedOutlines& outlines, double to, double radius_m, const Budget& budget);

    /// Returns the proxy after the motion, with no line crossed on the way if it is allowed.
    /// Returns nothing if there is no such place or the budget ended. A free proxy that a wall
    /// reaches becomes a contact. At most 6 queries; none for a contact that may not be taken so
    /// far, or whose edges are alone.
    [[nodiscard]] std::optional<Carried> carry(const ProxyState& proxy, Position handle,
                                               const WallAllowance& allowance);

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

    /// A contact's edges: as rendered before the motion, in the octave's finer level, and after.
    struct Edges {
        Excluded before, halves, after;
    };

    [[nodiscard]] double way_m(const ProxyState& from, const ProxyState& to) const;
    [[nodiscard]] Carried effect(const ProxyState& from, const ProxyState& to) const;
    [[nodiscard]] std::optional<Carried> reached(const ProxyState& from, const ProxyState& to,
                                                 const Edges& own);
    [[nodiscard]] std::optional<Carried> carry_free(const ProxyState& proxy);
    [[nodiscard]] std::optional<Carried> pushed(const ProxyState& proxy, const WallHit& hit);
    [[nodiscard]] std::optional<Carried> carry_edge(const ProxyState& proxy);
    [[nodiscard]] std::optional<Carried> carry_round(const ProxyState& proxy);
    [[nodiscard]] std::optional<Carried> carry_corner(const ProxyState& proxy);
    [[nodiscard]] std::optional<Carried> carry_between(const ProxyState& proxy);
    [[nodiscard]] Joint joint_of(const Contact& at, bool at_end);

    [[nodiscard]] bool is_way_free(Position from, Position to, const Edges& own);
    [[nodiscard]] bool is_free(RenderedOutlines& at, Position from, Position to,
                               const Excluded& excluded);
    [[nodiscard]] bool is_swept(Position p, const Excluded& halves);
    [[nodiscard]] bool is_alone(const Excluded& halves) const;
    [[nodiscard]] bool is_way_free_alone(Position from, Position to, const Edges& own);
    [[nodiscard]] bool is_free_alone(RenderedOutlines& at, Position from, Position to,
                                     const Excluded& excluded);
    [[nodiscard]] bool is_swept_alone(Position p, const Excluded& halves) const;
    [[nodiscard]] WallHit first_wall(Position p, const Excluded& halves);

    [[nodiscard]] Contact halved(Contact contact) const;
    [[nodiscard]] Contact joined(Contact half) const;
    [[nodiscard]] bool is_pair(SegmentRef half) const;

    RenderedOutlines before_;
    RenderedOutlines after_;
    LevelChange change_;
    double radius_m_;
    Budget budget_;
    Position handle_;
    WallAllowance allowance_;
    int boxes_ = 0;
    bool is_cut_ = false;
};

/// Joins the forces before and after a change that the hand did not make: a switch of mode, or a
/// wall that lets the hand through. What is missing from the force before the change shrinks by 20
/// N/s: 0.02 N a tick, 50 ms for 1 N. Its work on a hand at speed v is at most gap^2 v / (40 N/s).
class GapFade {
  public:
    /// From here on the force continues from `before`, although the change made it `after`.
    void start(Force before, Force after) {
        gap_ = is_finite(before - after) ? before - after : Force{};
    }

    /// Returns the force to add in this tick.
    [[nodiscard]] Force step(double dt_s) {
        const Force now = gap_;
        const double size_N = norm(gap_);
        const double step_N = rate_N_per_s * dt_s;
        gap_ = size_N > step_N ? (1.0 - step_N / size_N) * gap_ : Force{};
        return now;
    }

    [[nodiscard]] bool is_open() const { return gap_ != Force{}; }

  private:
    static constexpr double rate_N_per_s = 20.0;

    Force gap_;
};

/// A wall that lets a determined hand through: one that pushes hard, for a while, at one place.
class PopThrough {
  public:
    /// Advances one tick of `dt_s`, before the proxy moves. Once K |handle - proxy| has been at
    /// least settings.pop_through_N for pop_through_s, and the proxy has not slid further than 0.5
    /// mm, puts the proxy on the other side of its edge, at the same parameter, free and as small
    /// as a point, and returns true. It never goes through a second line, nor where the line turns
    /// by a corner: there the proxy stays, and the push may go on elsewhere. Off (false) if
    /// pop_through_N is not above 0.
    [[nodiscard]] bool step(RenderedOutlines& outlines, Position handle,
                            const ContactSettings& settings, const Budget& budget, double dt_s,
                            ProxyState& proxy, int& boxes);

  private:
    double pushed_s_ = 0.0;
    Position place_;  // of the proxy when the push began
};

inline constexpr int max_tree_queries = 4;  // in a step; as many again where a disc rounds
                                            // vertices among other lines

/// The result of one step.
struct ContactReport {
    Force force;  // K (proxy - handle) in wall mode: the contact force itself, no limits; fading
                  // from the one before for a while after a switch of mode or a pop through
    double stored_J = 0.0;  // what the spring, or the groove's law, could give back
    Position p_WP;          // proxy
    ContactState state = ContactState::free;
    double level = 0.0;       // rendered level of the contact's piece, else the wanted one
    int outline = -1;         // touched, -1 when free
    int piece = -1;           // of it
    bool is_at_end = false;   // of an open outline, or slid off it in this step
    bool has_popped = false;  // through a wall
    double parameter = 0.0;   // on the outline, in level-0 segments
    Side side = Side::left;
    StateTrail transitions;
    double carried_m = 0.0;  // left over: along the line where a slide was cut, else to the handle
    int boxes = 0;           // opened
    double clear = 1.0;      // smallest fraction of a motion proven free
};

class ContactMachine {
  public:
    /// Starts free at the handle; if that is exactly on a line, the proxy starts on the line's
    /// left. A disc that has no room there stays narrower until there is more. The machine uses
    /// `scene`, which must outlive that use.
    void reset(const Scene& scene, Position handle, double level);

    /// Continues among the lines of `scene`, with the proxy where it is, free, at the level that is
    /// rendered as far as the scene has it; the next step finds the line again that held it. The
    /// machine uses `scene`, which must outlive that use.
    void move_to(const Scene& scene);

    /// Advances one tick of `dt_s` > 0. First the rendered level moves towards `level`. If the
    /// proxy is free and outside all boxes of the coarser of both levels, it moves there at once;
    /// else by at most half an octave and 0.015 N a tick, as a motion of the wall that takes the
    /// proxy along (moving_wall.cpp). It waits if there is no place for the proxy or the energy
    /// account does not cover it.
    /// Then the proxy moves towards the handle, with the budget's walks and 4 tree queries at most;
    /// the rest of the way is carried to the next tick. |handle - proxy| never grows by that. A
    /// handle that is not finite gives zero force and moves nothing. For the other modes see
    /// Groove::step(). A new mode takes over at once, a wall with the proxy at the handle, and the
    /// force fades over (GapFade). After that, and after a pop through, the proxy is as small as
    /// the place is.
    [[nodiscard]] ContactReport step(Position handle, double level, const ContactSettings& settings,
                                     const Budget& budget, double dt_s = 1e-3);

    [[nodiscard]] const ProxyState& proxy() const { return proxy_; }

    [[nodiscard]] double rendered_level() const { return outlines_.level(); }

    /// For a machine that was copied byte by byte: continues with `scene`, which is the same as
    /// before but elsewhere in memory, or null for no scene until reset(). Returns false if the
    /// machine's state does not fit it.
    [[nodiscard]] bool rebind(const Scene* scene);

    /// From the next step on, `path` holds the way points of the latest step, beginning with its
    /// start; nullptr keeps none. For tests: it may allocate.
    void record_path(std::vector<Position>* path) { path_ = path; }

  private:
    /// Makes the disc as wide as `wanted_m`, or as wide as the room allows while it is free.
    /// Returns the number of boxes opened.
    int widen(double wanted_m, const Budget& budget);
    /// Moves to `level`, which differs from the rendered one. Returns the number of boxes opened.
    int change_level(double level, Position handle, const ContactSettings& settings,
                     const Budget& budget, double dt_s);
    void book(Position handle, Position start, double stiffness_N_per_m, double dt_s);
    int move_wall(double level, Position handle, const ContactSettings& settings,
                  const Budget& budget, double dt_s);
    void press(Position handle, double level, const ContactSettings& settings, const Budget& budget,
               double dt_s, ContactReport& report);
    void start_free(Position handle);
    void take_mode(Position handle, Mode mode);
    void hold(Position handle, double level, const ContactSettings& settings, const Budget& budget,
              double dt_s, ContactReport& report);
    void join(ContactReport& report, double dt_s);
    void fill(ContactReport& report);
    [[nodiscard]] bool is_beyond_end(int piece);

    RenderedOutlines outlines_;
    ProxyState proxy_;
    double radius_m_ = 0.0;  // as wide as the disc is; less than set where it had no room
    Position handle_;        // of the last step
    std::vector<Position>* path_ = nullptr;
    Groove groove_;
    PopThrough pop_through_;
    GapFade gap_;
    Force force_;          // of the last step
    bool is_gap_ = false;  // between that and the one to come
    EnergyAccount account_;
    double pace_octaves_ = largest_octaves;  // of a change of level, in the next tick
    int touched_piece_ = -1;                 // in the last step
    Mode mode_ = Mode::wall;
    bool is_fresh_ = true;  // no step since reset()
};

}  // namespace touchline
