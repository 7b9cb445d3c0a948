// Touchline's servo step as a renderer of run(): level choice, collision and contact, as the kiosk
// and `feel` do them; wall mode, 500 N/m, a point proxy, no friction.
// Threads: one.
#pragma once

#include "haptics/contact/contact_machine.h"
#include "haptics/resolution/level_rule.h"
#include "tests/lab/bench/collision/crossing.h"
#include "tests/lab/bench/collision/run.h"

#include <limits>
#include <vector>

namespace touchline::bench {

/// Returns the limits of the level rule for a scene on the default device.
[[nodiscard]] LevelLimits limits_of(const CurveSet& curves);

/// Returns the mean length of the segments rendered at a level, over all pieces. O(N).
[[nodiscard]] double mean_spacing_m(const CurveSet& curves, double level);

/// Does the step at one level, with a budget of boxes and, from the start of each step, of time.
class FixedLevel {
  public:
    struct Options {
        double level = 0.0;
        int boxes = std::numeric_limits<int>::max();
        std::int64_t deadline_ns = 0;  // after the step's start; 0: none
        int walks = Budget{}.walks;
    };

    /// `scene` must outlive this object.
    FixedLevel(const Scene& scene, const Options& options) : scene_(scene), options_(options) {}

    void start(Position hand) { machine_.reset(scene_, hand, options_.level); }

    void reset(Position hand) { start(hand); }

    Position step(Position hand);

    [[nodiscard]] ContactMachine& machine() { return machine_; }

    [[nodiscard]] const ContactReport& report() const { return report_; }

    [[nodiscard]] double wanted_level() const { return options_.level; }

  private:
    const Scene& scene_;
    Options options_;
    ContactSettings settings_;
    ContactMachine machine_;
    ContactReport report_;
};

/// Does the step with the level chosen by the hand's speed.
class AutoLevel {
  public:
    /// `scene` must outlive this object.
    explicit AutoLevel(const Scene& scene) : scene_(scene), rule_(limits_of(scene.curves)) {}

    void start(Position hand);

    void reset(Position hand) { machine_.reset(scene_, hand, rule_.level()); }

    Position step(Position hand);

    [[nodiscard]] ContactMachine& machine() { return machine_; }

    [[nodiscard]] double wanted_level() const { return rule_.level(); }

  private:
    const Scene& scene_;
    LevelRule rule_;
    ContactSettings settings_;
    ContactMachine machine_;
};

/// The result of a pass without a clock that judges every way exactly.
struct Verdict {
    std::size_t let_through = 0;  // steps whose way met the curve as rendered at that step
    std::size_t coarser = 0;      // steps rendered at a coarser level than the rule asked for
    std::vector<double> levels;   // rendered, of each step
};

/// Repeats the steps of a run, with its resets.
template <class Renderer>
[[nodiscard]] Verdict judged(Renderer& renderer, const CurveSet& curves, const Hand& hand,
                             const HandRun& run);

/// How far one run's proxy was from another's, over the steps that both did.
struct Deviation {
    double rms_m = 0.0, max_m = 0.0;
};

[[nodiscard]] Deviation deviation(const HandRun& run, const HandRun& reference);

}  // namespace touchline::bench
