// A hand that knows nothing of the picture: it feels the force on the handle, knows where the
// handle is, and remembers where it has been. Threads: plain values. Deterministic.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"
#include "haptics/device/simulated/simulated_pantograph.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace touchline::bench {

/// What a follower remembers of where it has felt a line: cells of a millimetre, and how far it had
/// followed lines by then.
class FeltPath {
  public:
    /// Remembers a line felt at p, after `followed_m` of following in all.
    void add(Position p, double followed_m) {
        double& first_m = cells_[index(cell(p.x), cell(p.y))];
        first_m = std::min(first_m, followed_m);
    }

    /// Whether a line was felt within `reach_m` of p, after at most `followed_m` of following.
    [[nodiscard]] bool is_known(Position p, double reach_m, double followed_m) const {
        const int reach = static_cast<int>(std::ceil(reach_m / cell_m));
        for (int dx = -reach; dx <= reach; ++dx) {
            for (int dy = -reach; dy <= reach; ++dy) {
                if (std::hypot(dx, dy) * cell_m > reach_m) continue;
                if (cells_[index(cell(p.x) + dx, cell(p.y) + dy)] <= followed_m) return true;
            }
        }
        return false;
    }

  private:
    static constexpr double cell_m = 5e-4;
    static constexpr int half = 200;  // 100 mm to each side

    static int cell(double x_m) { return static_cast<int>(std::floor(x_m / cell_m)) + half; }

    static std::size_t index(int x, int y) {
        const auto at = [](int i) { return static_cast<std::size_t>(std::clamp(i, 0, 2 * half)); };
        return at(y) * (2 * half + 1) + at(x);
    }

    std::vector<double> cells_ = std::vector<double>((2 * half + 1) * (2 * half + 1),
                                                     std::numeric_limits<double>::infinity());
};

/// A systematic search to and fro across the drawing area: every fourth row first, then those
/// between.
class Sweep {
  public:
    explicit Sweep(const Area& area)
        : half_x_m_(0.5 * area.width_m), half_y_m_(0.5 * area.height_m) {
        constexpr double apart_m = 0.0044;  // a groove that reaches 3 mm pulls between any two
        constexpr double margin_m = 0.004;
        const double half_x = 0.5 * area.width_m - margin_m;
        const double half_y = 0.5 * area.height_m - margin_m;
        const int rows = static_cast<int>(std::ceil(2.0 * half_y / apart_m)) + 1;
        const auto y_of = [&](int row) { return -half_y + 2.0 * half_y * row / (rows - 1); };
        bool is_right = true;
        for (const int first : {0, 2, 1, 3}) {
            for (int i = first; i < rows; i += 4) {
                // Upwards in one pass, downwards in the next.
                const int in_pass = (rows - 1 - first) / 4 * 4;
                const int row = first % 2 == 0 ? i : first + in_pass - (i - first);
                ends_.push_back({is_right ? -half_x : half_x, y_of(row)});
                ends_.push_back({is_right ? half_x : -half_x, y_of(row)});
                is_right = !is_right;
            }
        }
    }

    /// False where the hand feels the frame of the drawing area.
    [[nodiscard]] bool is_inside(Position p) const {
        constexpr double edge_m = 2e-4;
        return std::abs(p.x) < half_x_m_ - edge_m && std::abs(p.y) < half_y_m_ - edge_m;
    }

    [[nodiscard]] bool is_over() const { return next_ == ends_.size(); }

    /// Returns where it goes now. Precondition: not over.
    [[nodiscard]] Position goal() const { return ends_[next_]; }

    void arrive() { ++next_; }

  private:
    double half_x_m_;
    double half_y_m_;
    std::vector<Position> ends_;  // the rows' ends, from one to the next
    std::size_t next_ = 0;
};

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
