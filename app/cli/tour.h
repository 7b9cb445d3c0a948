// touchline tour: a simulated hand explores a picture or map on a simulated pantograph, through the
// production servo step, on a virtual clock. It needs no display and gives the same bits every
// time.
// Threads: one.
#pragma once

#include "app/cli/options.h"
#include "config/types/hand_state.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "config/types/vec2.h"
#include "haptics/collision/scene.h"
#include "haptics/device/simulated/simulated_pantograph.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace touchline {

// A simulated hand that explores a map like somebody who knows it: it goes to each outline in turn,
// follows it by feel with a light pressure, and leaves it. It decides where the hand means to be;
// the servo decides what the hand then feels. Deterministic.

struct ExplorerOptions {
    double follow_m_per_s = 0.05;    // along an outline: comfortable tracing is 30-60 mm/s
    double search_m_per_s = 0.01;    // along it, while the hand has lost it and turns back
    double travel_m_per_s = 0.15;    // between outlines, lifted
    double approach_m_per_s = 0.03;  // towards an outline and away from it
    double clearance_m = 0.003;      // beside the outline before and after; above the proxy radius
    double press_m = 0.0053;         // beyond the proxy: 1 N of a pen grip (300 N/m) on 500 N/m
    double leash_m = 0.008;          // ahead of the proxy: the hand waits if something holds it up
    double reaction_s = 0.02;        // to the felt direction
    double lost_m = 0.005;           // of the proxy from its place on the outline
    double lost_s = 0.5;             // without contact for this long: the outline is lost
};

/// Whether the map is felt.
enum class MapForce : std::uint8_t { off, changing, on };

/// What the hand feels.
struct Felt {
    Position proxy;
    Force force;  // the force on the hand
    bool is_in_contact = false;
    MapForce map_force = MapForce::off;
};

/// A place on an outline, and the side on which the hand stays.
struct RoutePoint {
    Position on;
    Direction outward;
};

/// The route along an outline, with points about half a millimetre apart. It follows closed
/// outlines on their outside for a little more than a full turn, and open ones on their left.
[[nodiscard]] std::vector<RoutePoint> route_along(const Outline& outline);

class Explorer {
  public:
    /// Map and scene must outlive the explorer. Outlines come in the order of the map.
    Explorer(const TactileMap& map, const Scene& scene, const ExplorerOptions& options);

    /// Where a tour starts.
    [[nodiscard]] Position start() const { return hand_.position; }

    /// One tick, dt_s > 0 after the last.
    void step(const Felt& felt, double dt_s);

    [[nodiscard]] const Intention& intention() const { return hand_; }

    /// Lifted: the hand moves between outlines, and nothing is felt.
    [[nodiscard]] bool is_lifted() const { return phase_ == Phase::travel; }

    [[nodiscard]] bool is_done() const { return phase_ == Phase::done; }

    /// How many outlines the hand has visited.
    [[nodiscard]] int visited() const { return visited_; }

  private:
    enum class Phase : std::uint8_t { travel, settle, approach, follow, leave, done };

    [[nodiscard]] Position beside(const RoutePoint& point) const;
    [[nodiscard]] bool is_open_place(const RoutePoint& point) const;
    void take_outline();
    void next_outline();
    void lift_to_next_place();

    bool move_to(Position target, double speed_m_per_s, double dt_s);
    void travel(const Felt& felt, double dt_s);
    void settle(const Felt& felt, double dt_s);
    void follow(const Felt& felt, double dt_s);
    void leave(double dt_s);

    void turn_to(const Felt& felt, double dt_s);
    void note_progress(Position proxy);
    [[nodiscard]] bool is_lost(const Felt& felt, double dt_s);

    const TactileMap& map_;
    const Scene& scene_;
    ExplorerOptions options_;
    Intention hand_;
    Phase phase_ = Phase::travel;
    std::size_t outline_ = 0;
    std::vector<RoutePoint> route_;  // along the current outline
    double press_m_ = 0.0;           // for this outline
    double turn_ = 1.0;              // ahead = turn_ * left_of(outward): 1 or -1
    std::size_t at_ = 0;             // index in the route of the place nearest to the proxy
    Direction outward_;              // as felt
    Position off_;                   // where the hand goes when it leaves
    double waited_s_ = 0.0;          // for the hand to arrive, or for the map to turn on
    double free_s_ = 0.0;            // without contact while following
    bool is_visited_ = false;        // the current outline
    int visited_ = 0;
};

/// One tick of a tour.
struct TourTick {
    HandState hand;
    bool is_lifted = false;  // between outlines, nothing is felt
};

/// The result of a tour.
struct TourRun {
    std::vector<TourTick> ticks;
    double period_s = 0.0;
    int outlines = 0;  // how many the map has
    int visited = 0;   // how many the hand visited
    double contact_s = 0.0;
    double mean_force_N = 0.0;  // on the hand, while in contact
    double largest_force_N = 0.0;
};

/// A pen grip explores every outline of the map in wall mode, with the level set by hand speed.
/// `scene` must belong to the map, and its map_version must not be 0.
[[nodiscard]] TourRun take_tour(const TactileMap& map, const Scene& scene);

/// In words, a sentence or two per line.
[[nodiscard]] std::vector<std::string> describe_tour(const TourRun& run);

/// Writes the picture of the tour whole or not at all, and prints the result.
[[nodiscard]] Result<void> run_tour(const TourArguments& arguments);

}  // namespace touchline
