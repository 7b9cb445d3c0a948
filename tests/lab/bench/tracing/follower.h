// A hand that knows nothing of the picture: it feels the force on the handle, knows where the
// handle is, and remembers where it has been. Threads: plain values. Deterministic.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"
#include "haptics/device/hand.h"
#include "tests/lab/bench/tracing/felt_path.h"
#include "tests/lab/bench/tracing/sweep.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace touchline::bench {

/// What the follower senses.
struct Touched {
    Position handle;
    Force force;  // on the hand
};

/// Follows a groove. Goes on in its last direction and turns with the force across its way. Where
/// the force holds it back it feels around in a small circle for where the line goes on. At an end
/// it turns to what it has left out, and then sweeps for what it has not felt yet.
class GrooveFollower {
  public:
    GrooveFollower(const Area& area, Position start);

    /// Does one tick of dt_s > 0. Returns where the hand means to be.
    [[nodiscard]] Intention step(const Touched& touched, double dt_s);

    /// Whether it believed in its last step that it was on a line.
    [[nodiscard]] bool is_on_line() const { return doing_ == Doing::follow; }

    [[nodiscard]] bool is_done() const { return doing_ == Doing::done; }

  private:
    enum class Doing : std::uint8_t { sweep, settle, probe, follow, travel, done };

    /// A way along a line that is still to be followed.
    struct Branch {
        Position from;
        Direction along;
    };

    /// What the hand felt on a circle.
    struct Sample {
        double angle = 0.0;
        Force force;
    };

    void sweep(const Touched& touched, double dt_s);
    void settle(const Touched& touched, double dt_s);
    void probe(const Touched& touched, double dt_s);
    void follow(const Touched& touched, double dt_s);
    void travel(const Touched& touched, double dt_s);

    void begin_settling();
    void begin_probe(Position around);
    void probe_again_at(Position around);
    void choose_branch();
    void take_next_branch();
    void take(const Branch& branch);
    [[nodiscard]] bool is_worth(const Branch& branch) const;
    [[nodiscard]] std::vector<Direction> branches() const;
    bool go_to(Position target, double speed_m_per_s, double dt_s);

    Doing doing_ = Doing::sweep;
    Sweep sweep_;
    Position meant_;
    Velocity meant_speed_;
    Direction ahead_{1.0, 0.0};
    FeltPath felt_;
    std::vector<Branch> left_;
    std::optional<Branch> next_;
    bool probes_there_ = false;  // at the end of its travel
    double followed_m_ = 0.0;
    double known_m_ = 0.0;  // of the way, along what it knows already
    double begun_m_ = 0.0;  // followed when the branch began
    double slack_m_ = 0.0;  // of the way, without any force of a line
    double held_s_ = 0.0;
    double waited_s_ = 0.0;
    Position last_;
    Position touched_;  // where it last touched the line
    std::vector<Position> probed_;
    Position centre_;  // of the circle
    double turned_ = 0.0;
    double turn_from_ = 0.0;
    std::vector<Sample> samples_;
};

}  // namespace touchline::bench
