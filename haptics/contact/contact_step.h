// One servo step of the contact machine in wall mode. Threads: pure functions, and a value on the
// stack of ContactMachine::step(). No allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/collision/collision_tree.h"
#include "haptics/collision/scene.h"
#include "haptics/collision/touch.h"
#include "haptics/contact/contact_machine.h"
#include "haptics/contact/proxy_state.h"
#include "haptics/contact/rendered_outlines.h"
#include "haptics/contact/stride.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace touchline {

/// How the centre of a proxy that keeps `skin_m` from both edges gets past a vertex.
struct Passage {
    Position leave;        // beside the vertex, as far as it goes along the first edge
    Position enter;        // where it begins to go along the next; the same at a concave vertex
    Direction normal;      // of the next edge
    double inset_m = 0.0;  // of `enter`, along the next edge from the vertex
};

/// `before`, `after`: directions of travel, turning by less than a right angle. The way over a
/// convex vertex is a chord of at most 1.4 skins; at a concave one it turns where the lines at
/// `skin_m` from the two edges cross.
[[nodiscard]] Passage passage(Position vertex, Direction before, Direction after,
                              double side_of_travel, double skin_m);

inline constexpr double still_m = 1e-14;  // a motion this short is rounding

class ContactStep {
  public:
    /// `radius_m` is the proxy's now, at most the one in the settings. Way points are added to
    /// `path` if it is not null.
    ContactStep(RenderedOutlines& outlines, const ContactSettings& settings, double radius_m,
                const Budget& budget, ProxyState& proxy, std::vector<Position>* path)
        : outlines_(outlines),
          settings_(settings),
          budget_(budget),
          proxy_(proxy),
          path_(path),
          radius_m_(std::max(radius_m, contact_skin_m)) {}

    /// Moves the proxy and fills in transitions, carried motion, boxes and clear.
    void run(Position handle, ContactReport& report);

  private:
    /// Whether a state's move goes on or has ended the step.
    enum class Next { again, done };

    using Excluded = std::array<SegmentRef, 2>;

    /// The result of a sweep: the share of the way gone and, if something stopped it, the contact.
    struct Sweep {
        double share = 1.0;
        bool is_cut = false;   // by the budget
        double spare_m = 0.0;  // see Hit
        std::optional<Contact> contact;
    };

    /// How the handle pulls the proxy along the edge that it touches.
    struct Course {
        double pulled_m = 0.0;  // along the edge, with its sign
        bool is_forward = false;
        double depth_m = 0.0;  // of the handle behind the proxy's tangent
        double way_m = 0.0;    // that friction does not hold back
        double left_m = 0.0;   // to the end ahead

        [[nodiscard]] bool is_past_end() const { return depth_m >= 0.0 && way_m > left_m; }
    };

    /// Where a slide along a contact's edge ends, see go_in_line().
    struct InLine {
        Contact at;
        double way_m = 0.0;  // of it that is gone, with its sign
        int edges = 0;       // passed on the way
    };

    Next move_free();
    Next move_on_edge();
    Next slide(double way_m);
    [[nodiscard]] InLine go_in_line(double way_m);
    [[nodiscard]] bool is_thin(const Contact& at) const;
    [[nodiscard]] bool is_late() const;
    [[nodiscard]] Course course_on_edge();
    bool rest_on_edge(const Course& course);
    bool stride(const Course& course);
    bool rest_in_corner(const Course& course);
    bool lift_off(const Course& course);
    [[nodiscard]] Passage passage_after(int index, int step);

    Next let_go();
    Next move_round();
    Next move_at_corner();

    Next reach_end(bool is_forward);
    Next walk_or_hold(SegmentRef next, bool at_start, Direction away, Direction normal);
    Next arrive(const Sweep& sweep, double left_m);
    void leave_corner(std::size_t kept);

    [[nodiscard]] bool can_slide(const Contact& along_this, const Contact& other,
                                 double& pull_m) const;
    [[nodiscard]] Sweep sweep(Position to, double radius_m, const Excluded& excluded,
                              bool is_alone);
    [[nodiscard]] Sweep sweep_tree(Position to, double radius_m, const Excluded& excluded,
                                   SegmentRef start);
    [[nodiscard]] Sweep sweep_neighbours(Position to, double radius_m, const Excluded& excluded);
    [[nodiscard]] std::optional<Contact> too_near(Position centre, double radius_m);
    [[nodiscard]] Contact contact_of(SegmentRef segment, Touch touch);
    [[nodiscard]] double arc_to(const Contact& at, double turn, Contact& edge);

    Contact& first() { return proxy_.contacts[0]; }

    void enter(ContactState state);
    void mark(Position way_point);
    void mark(const Passage& passed);
    void place(Position centre);
    void place_at_contact();
    void place_at_contact(const Segment& segment);

    RenderedOutlines& outlines_;
    const ContactSettings& settings_;
    Budget budget_;
    ProxyState& proxy_;
    std::vector<Position>* path_;
    double radius_m_;
    Position handle_;
    Position last_corner_;  // the corner last visited and how often without moving away
    int visits_ = 0;
    int walks_ = 0;
    int queries_ = 0;          // by sweeps
    int overlap_queries_ = 0;  // by arcs of a disc
    ContactReport* report_ = nullptr;
};

// How a proxy gets round a vertex. A disc's centre moves round a convex vertex or the end of a line
// on an arc about it, between the normals of its two edges: with a radius of 1.4 F/K or more, the
// force turns there instead of jumping. At a sharp tip, tells which of the two edges is touched.

/// The longest chord of the arc walked at once, as an angle: 15 degrees, so that the chord passes
/// inside the arc by at most 1 % of the radius; 90 degrees for a radius of nanometres, where
/// nothing can be felt.
[[nodiscard]] double largest_arc_step_rad(double offset_m);

/// Returns n turned left by an angle.
[[nodiscard]] Direction turned(Direction n, double angle_rad);

/// Returns the angle in [0, 7/4 pi] from n to m, turning left (turn > 0) or right (turn < 0). A
/// larger one counts as 0: no arc is longer than half a turn, so n lies beyond its end m, where
/// touching the vertex and touching the edge are the same moment.
[[nodiscard]] double angle_between(Direction n, Direction m, double turn);

/// Where a proxy goes that slides round a vertex under the pull of the handle.
struct ArcGoal {
    enum class End { rest, edge, free } end = End::rest;
    double turn = 0.0;       // +1 left, -1 right, 0: stays
    double angle_rad = 0.0;  // still to go, >= 0
};

/// `n`: normal of the proxy now; `pull`: handle - vertex; `offset_m`: radius of the arc;
/// `to_left_rad`, `to_right_rad`: angles to the ends of the arc. The proxy rests where the force is
/// along the normal or inside the friction cone, leaves where the force becomes zero, and otherwise
/// goes on to the edge.
[[nodiscard]] ArcGoal arc_goal(Direction n, Position pull, double offset_m, double to_left_rad,
                               double to_right_rad, double friction);

/// Both edges of a sharp tip (under 25 degrees) are touched at the same moment within the tolerance
/// of a sweep. If the touched side of `segment` lies inside the tip, returns the contact with the
/// edge in front of it; else nothing. O(1).
[[nodiscard]] std::optional<Contact> contact_in_front(RenderedOutlines& outlines,
                                                      SegmentRef segment, const Touch& touch);

}  // namespace touchline
