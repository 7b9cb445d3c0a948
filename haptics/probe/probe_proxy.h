// A shape in the hand, held back by lines: the paper's virtual handle with a place and an angle, as
// a constrained god-object (after Ortega, Redon and Coquillart 2007). Threads: one, the servo's. No
// allocation, lock, clock or log in step().
#pragma once

#include "config/types/hand_state.h"
#include "haptics/collision/collision_tree.h"
#include "haptics/contact/contact_machine.h"
#include "haptics/contact/proxy_state.h"
#include "haptics/probe/probe_front.h"
#include "haptics/probe/probe_shape.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace touchline {

// What touching lines allow a shape to do: the move that leaves the least energy in the coupling if
// contacts forbid some moves, and what one line allows to first and second order.

/// A move as (x, y, angle times the lever of the turning spring), all in metres: in these
/// coordinates the coupling's energy is K_t / 2 times the square of the distance left.
using Coupled = std::array<double, 3>;

[[nodiscard]] inline double dot3(const Coupled& a, const Coupled& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

[[nodiscard]] inline double square(const Coupled& move) {
    return dot3(move, move);
}

[[nodiscard]] inline Coupled operator*(double share, const Coupled& move) {
    return {share * move[0], share * move[1], share * move[2]};
}

/// Returns twice the energy that a move leaves, divided by the stiffness.
[[nodiscard]] inline double left_of_move(const Coupled& wanted, const Coupled& move) {
    return square({wanted[0] - move[0], wanted[1] - move[1], wanted[2] - move[2]});
}

/// A contact that allows moves with row . move + gap_m >= 0.
struct Constraint {
    Coupled row{};
    double gap_m = 0.0;
};

inline constexpr std::size_t most_constraints = 64;

inline constexpr int most_active = 3;  // contacts that can hold three freedoms

/// The allowed move nearest to the wanted one.
struct LeastMove {
    Coupled move{};
    std::array<int, most_active> active{-1, -1, -1};  // constraints that hold it back
    std::array<double, most_active> push_m{};         // each one's push, metres times its row, >= 0
    int active_count = 0;
};

/// Takes the most violated constraint first: the one that a move breaks most joins at most eight
/// candidates, of which the subsets of three or fewer that include the newest are tried (29 at
/// most). If it finds no allowed move, it returns one that breaks the constraints least late; the
/// caller's sweep stops that one. Tries first what held the move back in one like it.
[[nodiscard]] LeastMove least_move(std::span<const Constraint> constraints, const Coupled& wanted,
                                   const LeastMove& like = {});

/// Symmetric, in the coordinates of a Coupled move; per metre.
using Curvature = std::array<std::array<double, 3>, 3>;

class Touching {
  public:
    Touching() = default;

    /// `edge` is in W, of a shape at `origin`; lever of the turning spring > 0.
    Touching(const Segment& edge, const Segment& line, const Separation& at, Position origin,
             double lever_m);

    /// The distance's first derivative.
    [[nodiscard]] const Coupled& row() const { return row_; }

    /// The distance's second derivative.
    [[nodiscard]] Curvature curvature() const;

    /// Returns the distance after a move: `moved` is a shape at the origin after it.
    [[nodiscard]] double distance_m(const ProbePlacement& moved) const;

    /// Returns how far along the normal from the shape's origin a pivot lies under which a move
    /// does not bend the distance at first.
    [[nodiscard]] double pivot_m(const ProbeMove& move) const;

    [[nodiscard]] Direction normal() const { return at_.normal; }

  private:
    enum class Kind : std::uint8_t { end_on_line, edge_on_end, end_on_end };

    Kind kind_ = Kind::end_on_line;
    Separation at_;
    Position arm_;  // from the origin to the point that touches
    double lever_m_ = 1.0;
    Coupled row_{};
};

/// The coupling's energy along distances that curve, held back by the pushes of a least move; the
/// plain energy if the curved one has no clear least.
class CurvedEnergy {
  public:
    CurvedEnergy(std::span<const Touching> touching, const LeastMove& least);

    /// Turns constraints into those of a plain energy.
    void see(std::span<const Constraint> constraints, std::vector<Constraint>& seen) const;

    /// A wanted move as a plain energy sees it.
    [[nodiscard]] Coupled see(const Coupled& wanted) const;

    /// As least_move(), for this energy and what see() turned. `held`: what held back a move like
    /// it, and then this one.
    [[nodiscard]] Coupled least(std::span<const Constraint> seen, const Coupled& wanted_seen,
                                LeastMove& held) const;

  private:
    Curvature factor_{};  // lower triangle L, on the diagonal 1 / L; the energy is L L^T
};

struct ProbeSettings {
    double stiffness_N_per_m = 500.0;        // K_t, 0 < K_t <= 20000
    double turn_stiffness_Nm_per_rad = 0.0;  // K_r; 0: turn_stiffness() for the shape
};

/// Returns K_t r^2, with r the shape's r_max, at least 5 mm: the rim then feels as stiff as the
/// middle.
[[nodiscard]] double turn_stiffness_Nm_per_rad(const ProbeShape& shape, double stiffness_N_per_m);

/// What holds the shape back: one line at one point.
struct ProbeContact {
    SegmentRef segment;      // as rendered
    double parameter = 0.0;  // on it, 0 ... 1
    Side side = Side::left;  // the side of the outline on which the shape's edge lies there
    Position place;          // on the shape's edge
    Direction normal;        // from the line to the edge
    double force_N = 0.0;    // on the shape, >= 0
};

/// The result of one step.
struct ProbeReport {
    Force force;                              // on the hand: K_t (proxy - handle)
    double torque_Nm = 0.0;                   // on the hand: K_r (proxy - handle)
    double stored_J = 0.0;                    // in both springs
    ProbePose pose;                           // of the proxy
    bool is_placed = false;                   // false: there has been no room yet, and no force
    ContactState state = ContactState::free;  // edge: one contact, vertex: two or three
    double level = 0.0;                       // rendered
    std::array<ProbeContact, most_active> contacts{};
    int contact_count = 0;
    StateTrail transitions;
    double carried_m = 0.0;  // of the last wanted move, left for the next tick
    int boxes = 0;           // opened
    double clear = 1.0;      // smallest share of a move proven free of unopened nodes
};

class ProbeProxy {
  public:
    /// Allocates the memory that steps need, so that reset() allocates nothing.
    void reserve();

    /// Places the shape at the handle. If lines pass through the shape, or nearer than its radius,
    /// it is not placed: it follows the handle without force until it is clear of all of them.
    /// `shape` and `scene` must outlive the proxy's use of them. Allocates the first time.
    void reset(const ProbeShape& shape, const Scene& scene, const ProbePose& handle, double level);

    /// Advances one tick of `dt_s` > 0. The rendered level moves towards `level`. Then the proxy
    /// moves so that the energy K_t/2 |d|^2 + K_r/2 angle^2 falls as far as contacts allow:
    /// straight to its least under those that count, stopped where it reaches another line, and on
    /// from there, at most 16 times. No line passes through an edge of the shape at any moment. The
    /// energy never grows by that, except by a change of level, which the energy account covers. A
    /// handle that is not finite gives no force and moves nothing.
    [[nodiscard]] ProbeReport step(const ProbePose& handle, double level,
                                   const ProbeSettings& settings, const Budget& budget,
                                   double dt_s = 1e-3);

    [[nodiscard]] const ProbePose& pose() const { return pose_; }

    [[nodiscard]] double rendered_level() const { return front_.level(); }

    /// The number of pairs kept from step to step.
    [[nodiscard]] std::size_t pairs() const { return front_.size(); }

    /// Lets `path` hold poses of the latest step from the next one on, beginning with its start, as
    /// add_way() finds them. nullptr keeps none. For tests: it may allocate.
    void record_path(std::vector<ProbePose>* path) { path_ = path; }

  private:
    struct Springs {
        double k_N_per_m = 0.0;
        double lever_m = 0.0;  // sqrt(K_r / K_t)

        [[nodiscard]] double energy_J(const ProbeMove& to) const;
    };

    /// The longest single move: the front has no room for what a longer one may meet.
    static constexpr double longest_move_m = 5e-4;

    /// How a move follows what touches.
    struct Following {
        bool is_curved = true;
        double longest_m = longest_move_m;
    };

    /// Whether the lines may go to a level while the shape stays where it is.
    struct Room {
        bool is_free = false;      // they may
        bool is_possible = false;  // or could, if it made as little room as a tick allows
    };

    [[nodiscard]] Springs springs(const ProbeSettings& settings) const;
    [[nodiscard]] static ProbeMove move_of(const Coupled& move, const Springs& springs);
    void place(const ProbePose& handle, Spender& spender);
    void put(const ProbePose& pose);
    void press(const ProbePose& handle, const Springs& springs, Spender& spender,
               ProbeReport& report);
    [[nodiscard]] bool follow_otherwise(Following& following) const;
    void find_touching(const Springs& springs);
    [[nodiscard]] ProbeMove wanted_move(const ProbePose& handle, const Springs& springs,
                                        const Following& following, LeastMove& held);
    [[nodiscard]] bool curved_move(const Coupled& wanted, const Springs& springs,
                                   const Following& following, const LeastMove& held,
                                   ProbeMove& move);
    [[nodiscard]] Coupled curved_end(const CurvedEnergy& energy, const Coupled& wanted_seen,
                                     Coupled move, const Springs& springs, double most_bend_m,
                                     LeastMove held);
    [[nodiscard]] Position pivot_of(const ProbeMove& move, const LeastMove& held) const;
    [[nodiscard]] ProbeMove rolling(const Coupled& move, const Springs& springs,
                                    const LeastMove& held) const;
    [[nodiscard]] double sink_m(const ProbeMove& move) const;
    [[nodiscard]] double shortening(const Coupled& move, const Springs& springs,
                                    double longest_m) const;
    [[nodiscard]] double free_share_of(const ProbeMove& move, Spender& spender);
    [[nodiscard]] double clear_share_of(const ProbeMove& move, Spender& spender, bool can_shorten);
    double advance(const ProbeMove& move, const ProbePose& handle, const Springs& springs,
                   Spender& spender, bool can_shorten, ProbeReport& report);
    void change_level(double level, const ProbePose& handle, const Springs& springs,
                      Spender& spender);
    bool try_level(double level, const ProbePose& handle, const Springs& springs, Spender& spender);
    [[nodiscard]] Room room_at(double level, const Springs& springs, Spender& spender);
    void hold(const LeastMove& held, const Springs& springs, ProbeReport& report);
    [[nodiscard]] ProbeContact contact_at(const NearPair& pair);

    const ProbeShape* shape_ = nullptr;
    double keep_m_ = 0.0;  // the shape's radius, at least the gap
    ProbePose pose_;
    ProbePlacement placed_;  // there
    ProbeFront front_;
    ProbeFront wide_;  // of nodes, for a change of level
    std::vector<Constraint> constraints_;
    std::vector<Constraint> seen_;    // the same, as a curved energy sees them
    std::vector<Touching> touching_;  // for each constraint
    std::vector<NearPair> pairs_;     // the same
    double free_m_ = 0.0;             // in the last move, before the touching lines were asked
    double sunk_m_ = 0.0;             // by how much the deepest is nearer than kept, and stays so
    EnergyAccount account_;
    std::vector<ProbePose>* path_ = nullptr;
    ContactState state_ = ContactState::free;
    bool is_placed_ = false;
};

/// Returns what events, sounds and screens know of a contact. If there are several, the first
/// counts.
[[nodiscard]] ContactReport contact_of(const ProbeReport& report, const CurveSet& curves);

}  // namespace touchline
