// Whether the step keeps its budget of time and boxes when it must read everything from memory.
#include "tests/lab/bench/collision/report.h"
#include "tests/lab/bench/collision/touchline_rows.h"

#include <algorithm>
#include <limits>

namespace touchline::bench {
namespace {

constexpr std::int64_t deadline_ns = 10000;
constexpr std::size_t steps_per_flush = 333;  // flushing is slow
constexpr std::size_t start_before = 20;      // steps of 1 ms from a cold start's hand to its step

/// Writes to more memory than the caches hold, so that they hold nothing else.
class CacheFlush {
  public:
    void operator()() {
        for (std::size_t i = 0; i < memory_.size(); i += line_bytes) ++memory_[i];
    }

  private:
    static constexpr std::size_t line_bytes = 64;
    std::vector<unsigned char> memory_ = std::vector<unsigned char>(std::size_t{256} << 20U);
};

struct Kept {
    std::vector<std::uint64_t> ticks;
    std::size_t cut = 0;  // steps that the budget ended
};

/// Runs steps spread over the hand with flushed caches, each from a proxy that was reset at the
/// hand 20 ms earlier. Takes the least time of three.
Kept cold_starts(const Scene& scene, std::span<const Position> hand, CacheFlush& flush) {
    FixedLevel renderer(scene, {0.0, std::numeric_limits<int>::max(), deadline_ns});
    Kept kept;
    for (std::size_t i = start_before; i < hand.size(); i += steps_per_flush) {
        auto least = std::numeric_limits<std::uint64_t>::max();
        for (int repeat = 0; repeat < 3; ++repeat) {
            renderer.start(hand[i - start_before]);
            flush();
            const std::uint64_t begin = ticks();
            renderer.step(hand[i]);
            least = std::min(least, ticks() - begin);
        }
        kept.ticks.push_back(least);
        kept.cut += renderer.report().clear < 1.0 ? 1U : 0U;
    }
    return kept;
}

/// Runs the whole hand with warm caches. Takes the least time of three passes.
Kept warm_steps(const Scene& scene, std::span<const Position> hand) {
    FixedLevel renderer(scene, {0.0, std::numeric_limits<int>::max(), deadline_ns});
    Kept kept;
    kept.ticks.assign(hand.size(), std::numeric_limits<std::uint64_t>::max());
    for (int pass = 0; pass < 3; ++pass) {
        renderer.start(hand[0]);
        kept.cut = 0;
        for (std::size_t i = 0; i < hand.size(); ++i) {
            const std::uint64_t begin = ticks();
            renderer.step(hand[i]);
            kept.ticks[i] = std::min(kept.ticks[i], ticks() - begin);
            kept.cut += renderer.report().clear < 1.0 ? 1U : 0U;
        }
    }
    return kept;
}

void write_time(std::string_view name, workload::Kind kind, std::size_t edges, const Kept& kept,
                CsvFile& csv) {
    const auto within = std::count_if(kept.ticks.begin(), kept.ticks.end(), [](std::uint64_t t) {
        return ns_per_tick() * static_cast<double>(t) <= static_cast<double>(deadline_ns);
    });
    const StepTimes times = step_times(kept.ticks);
    csv.line(fmt::format("{},{},{},10 us,{},{:.0f},{:.0f},{:.0f},{:.5f},{},", name, name_of(kind),
                         edges, kept.ticks.size(), times.median_ns, times.p99_ns, times.max_ns,
                         static_cast<double>(within) / static_cast<double>(kept.ticks.size()),
                         kept.cut));
}

void write_boxes(workload::Kind kind, std::size_t edges, const Scene& scene,
                 std::span<const Position> hand, CsvFile& csv) {
    for (const int boxes : {1, 4, 16, 64, 256}) {
        FixedLevel renderer(scene, {0.0, boxes, 0});
        renderer.start(hand[0]);
        std::vector<std::uint64_t> spent;
        std::size_t kept = 0;
        std::size_t cut = 0;
        int most = 0;
        for (const Position at : hand) {
            const std::uint64_t begin = ticks();
            renderer.step(at);
            spent.push_back(ticks() - begin);
            kept += renderer.report().boxes <= boxes ? 1U : 0U;
            cut += renderer.report().clear < 1.0 ? 1U : 0U;
            most = std::max(most, renderer.report().boxes);
        }
        const StepTimes times = step_times(spent);
        csv.line(fmt::format("budget of boxes,{},{},{} {},{},{:.0f},{:.0f},{:.0f},{:.5f},{},{}",
                             name_of(kind), edges, boxes, boxes == 1 ? "box" : "boxes",
                             spent.size(), times.median_ns, times.p99_ns, times.max_ns,
                             static_cast<double>(kept) / static_cast<double>(spent.size()), cut,
                             most));
    }
}

}  // namespace

void run_deadline(const BenchOptions& options) {
    CsvFile csv(options.folder, "deadline.csv",
                "row,curve,edges,budget,steps,median_ns,p99_ns,max_ns,share_within_budget,"
                "cut_steps,most_boxes");
    CacheFlush flush;
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        const std::size_t edges = options.largest;
        const Scene scene =
            build_scene(workload::map_of(workload::curve(kind, edges)), {}, 0.0).value();
        const auto hand = workload::hand(kind, options.steps);
        write_time("deadline warm", kind, edges, warm_steps(scene, hand), csv);
        write_time("deadline cold start", kind, edges, cold_starts(scene, hand, flush), csv);
        write_boxes(kind, edges, scene, hand, csv);
    }
}

}  // namespace touchline::bench
