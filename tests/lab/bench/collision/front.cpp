// One collision query a step: from the top, from the start grid, and from a kept front.
#include "haptics/collision/collision_tree.h"
#include "haptics/collision/tree_walk.h"
#include "tests/lab/bench/collision/kept_front.h"
#include "tests/lab/bench/collision/report.h"
#include "tests/lab/bench/collision/touchline_rows.h"

#include <algorithm>
#include <cmath>

namespace touchline::bench {
namespace {

constexpr double margin_m = 5e-4;  // tested the fewest boxes of 0, 0.02, 0.1, 0.5 and 2 mm
constexpr double wanted_spacing_m = 5e-4;

/// Walks down from the hierarchy over all pieces, as the tree does for long motions.
class FromTheTop {
  public:
    static constexpr bool asks_leaf_boxes = false;

    explicit FromTheTop(const Motion& motion) : first_(motion) {}

    Sifted sift(const Fan& fan) { return first_.sift(fan); }

    [[nodiscard]] std::optional<double> near(const Box& box) { return first_.near(box); }

    [[nodiscard]] double cut() const { return first_.cut(); }

    bool spend(int boxes) { return spender_.spend(boxes); }

    void leaf(SegmentRef ref, const Segment& segment) { first_.test(ref, segment); }

    [[nodiscard]] Hit result(double unopened) { return first_.result(unopened, spender_.opened()); }

  private:
    FirstTouch first_;
    Spender spender_{Budget{}};
};

/// The query of a motion, at every step.
struct Descent {
    const Scene& scene;
    double level;

    void place(Position /*handle*/) const {}

    [[nodiscard]] Hit first_hit(Position from, Position to) const {
        const Motion motion{from, to, contact_skin_m, level, {}};
        FromTheTop visitor(motion);
        return visitor.result(TreeWalk(scene.tree, scene.curves, level, visitor).run());
    }
};

struct FromTheGrid {
    const Scene& scene;
    double level;

    void place(Position /*handle*/) const {}

    [[nodiscard]] Hit first_hit(Position from, Position to) const {
        return scene.tree.first_hit(scene.curves, {from, to, contact_skin_m, level, {}}, {});
    }
};

class WithAllowance {
  public:
    WithAllowance(const Scene& scene, double level) : grid_{scene, level} {}

    void place(Position /*handle*/) { spare_m_ = 0.0; }

    [[nodiscard]] Hit first_hit(Position from, Position to) {
        spare_m_ -= norm(to - from);
        if (spare_m_ > 0.0) return {};
        const Hit hit = grid_.first_hit(from, to);
        spare_m_ = hit.spare_m;
        return hit;
    }

  private:
    FromTheGrid grid_;
    double spare_m_ = 0.0;
};

class OfAFront {
  public:
    OfAFront(const Scene& scene, const KeptFront::Options& options) : front_(scene, options) {}

    void place(Position handle) { front_.place(handle); }

    [[nodiscard]] Hit first_hit(Position /*from*/, Position to) { return front_.first_hit(to); }

  private:
    KeptFront front_;
};

/// A renderer for run() that moves nothing and counts what its query looks at.
template <class Way>
class Counted {
  public:
    explicit Counted(Way& way) : way_(way) {}

    void start(Position hand) {
        way_.place(hand);
        last_ = hand;
        boxes_ = 0;
        most_boxes_ = 0;
        hits_ = 0;
    }

    void reset(Position hand) { start(hand); }

    Position step(Position hand) {
        const Hit hit = way_.first_hit(last_, hand);
        boxes_ += hit.boxes;
        most_boxes_ = std::max(most_boxes_, hit.boxes);
        hits_ += hit.is_hit ? 1 : 0;
        last_ = hand;
        return hand;
    }

    /// Returns "mean,largest,hits" of the last pass.
    [[nodiscard]] std::string counts(std::size_t steps) const {
        return fmt::format("{:.2f},{},{}", static_cast<double>(boxes_) / static_cast<double>(steps),
                           most_boxes_, hits_);
    }

  private:
    Way& way_;
    Position last_;
    std::int64_t boxes_ = 0;
    int most_boxes_ = 0;
    int hits_ = 0;
};

/// Returns the whole level whose segments are nearest to the wanted spacing, by ratio.
int level_of_spacing(const CurveSet& curves) {
    int best = 0;
    double least = INFINITY;
    for (int level = 0; level <= curves.coarsest(); ++level) {
        const double off = std::abs(std::log(mean_spacing_m(curves, level) / wanted_spacing_m));
        if (off < least) best = level;
        least = std::min(least, off);
    }
    return best;
}

class FrontRows {
  public:
    FrontRows(workload::Kind kind, std::size_t edges, const BenchOptions& options, CsvFile& csv)
        : kind_(kind),
          edges_(edges),
          limits_(options.limits),
          csv_(csv),
          positions_(workload::hand(kind, options.steps)) {}

    void write() {
        const Scene scene =
            build_scene(workload::map_of(workload::curve(kind_, edges_)), {}, 0.0).value();
        write_level(scene, 0);
        const int level = level_of_spacing(scene.curves);
        if (level > 0) write_level(scene, level);
    }

  private:
    void write_level(const Scene& scene, int level) {
        write_row("from the top", scene, level, Descent{scene, static_cast<double>(level)});
        write_row("start grid", scene, level, FromTheGrid{scene, static_cast<double>(level)});
        write_row("start grid with allowance", scene, level,
                  WithAllowance(scene, static_cast<double>(level)));
        write_row("kept front", scene, level,
                  OfAFront(scene, {level, contact_skin_m, margin_m, false}));
        write_row("kept front with schedule", scene, level,
                  OfAFront(scene, {level, contact_skin_m, margin_m, true}));
    }

    template <class Way>
    void write_row(std::string_view name, const Scene& scene, int level, Way way) {
        Counted<Way> query(way);
        const HandRun done = run(query, {positions_, {}}, limits_);
        csv_.line(fmt::format("{},{},{},{},{:.5f},{},{},{}", name, name_of(kind_), edges_, level,
                              mean_spacing_m(scene.curves, level) * 1e3, done.least_ticks.size(),
                              times_of(done), query.counts(done.least_ticks.size())));
    }

    workload::Kind kind_;
    std::size_t edges_;
    RunLimits limits_;
    CsvFile& csv_;
    std::vector<Position> positions_;
};

}  // namespace

void run_front(const BenchOptions& options) {
    CsvFile csv(options.folder, "front.csv",
                "row,curve,edges,level,spacing_mm,steps,median_ns,p99_ns,max_ns,raw_p99_ns,"
                "boxes_mean,boxes_max,hits");
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        for (const std::size_t edges : {512U, 4096U, 65536U, 1048576U}) {
            if (edges <= options.largest) FrontRows(kind, edges, options, csv).write();
        }
    }
}

}  // namespace touchline::bench
