// Three ways to make a force from a line and a hand: Touchline's contact machine, the plain proxy
// of the benchmark, and penalty forces. Threads: one.
#pragma once

#include "config/types/pinned.h"
#include "haptics/contact/contact_machine.h"
#include "tests/lab/bench/collision/brute_force.h"
#include "tests/lab/bench/collision/crossing.h"

#include <vector>

namespace touchline::bench {

inline constexpr double wall_N_per_m = 1000.0;

struct Felt {
    Force force;
    Position place;  // the proxy, or the hand for penalty forces, which have none
};

class Renderer : public Interface {
  public:
    virtual void start(Position hand) = 0;
    [[nodiscard]] virtual Felt step(Position hand) = 0;
};

/// Runs at level 0; radius 0 is a point.
class Machine final : public Renderer {
  public:
    /// `scene` must outlive the machine.
    Machine(const Scene& scene, double radius_m)
        : scene_(scene), settings_{Mode::wall, wall_N_per_m, 0.0, radius_m, 0.003} {}

    void start(Position hand) override { machine_.reset(scene_, hand, 0.0); }

    Felt step(Position hand) override;

  private:
    const Scene& scene_;
    ContactSettings settings_;
    ContactMachine machine_;
};

/// The plain proxy of crossing.h over every edge of a closed curve.
class PlainProxy final : public Renderer {
  public:
    /// `curve` must outlive the proxy.
    explicit PlainProxy(ClosedCurve curve) : edges_(curve), proxy_(edges_, curve) {}

    void start(Position hand) override { proxy_.start(hand); }

    Felt step(Position hand) override;

  private:
    BruteForce edges_;
    PlaneProxy<BruteForce> proxy_;
};

/// Every edge pushes away from its nearest point with K (band - distance) within its band; the
/// forces add up. Has no memory.
class Penalty final : public Renderer {
  public:
    Penalty(std::vector<Segment> edges, double band_m)
        : edges_(std::move(edges)), band_m_(band_m) {}

    void start(Position) override {}

    Felt step(Position hand) override;

  private:
    std::vector<Segment> edges_;
    double band_m_;
};

/// Returns the segments of all pieces at level 0.
[[nodiscard]] std::vector<Segment> edges_of(const CurveSet& curves);

}  // namespace touchline::bench
