#include "tests/lab/bench/collision/touchline_rows.h"

#include "haptics/pantograph/profile.h"
#include "tests/lab/bench/collision/level_judge.h"

#include <cmath>

namespace touchline::bench {
namespace {

constexpr double step_s = 1e-3;

std::int64_t steady_ns() {
    return static_cast<std::int64_t>(now_s() * 1e9);
}

}  // namespace

LevelLimits limits_of(const CurveSet& curves) {
    const DeviceProfile& device = default_profile();
    return {curves.finest_spacing_m(), encoder_step_m(device), device.bandwidth_Hz, 0.0,
            static_cast<double>(curves.coarsest())};
}

double mean_spacing_m(const CurveSet& curves, double level) {
    double length_m = 0.0;
    double edges = 0.0;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        const int count = curves.rendered_count(piece, level);
        edges += count;
        for (int j = 0; j < count; ++j) {
            const Segment s = curves.rendered_segment(piece, level, j);
            length_m += norm(s.b - s.a);
        }
    }
    return length_m / edges;
}

Position FixedLevel::step(Position hand) {
    Budget budget{.boxes = options_.boxes, .walks = options_.walks};
    if (options_.deadline_ns > 0) budget.deadline_ns = steady_ns() + options_.deadline_ns;
    report_ = machine_.step(hand, options_.level, settings_, budget);
    return report_.p_WP;
}

void AutoLevel::start(Position hand) {
    rule_ = LevelRule(limits_of(scene_.curves));
    machine_.reset(scene_, hand, rule_.level());
}

Position AutoLevel::step(Position hand) {
    const double level = rule_.step(hand, step_s);
    return machine_.step(hand, level, settings_, {}).p_WP;
}

template <class Renderer>
Verdict judged(Renderer& renderer, const CurveSet& curves, const Hand& hand, const HandRun& run) {
    LevelJudge judge(curves);
    Verdict verdict;
    std::vector<Position> path;
    renderer.machine().record_path(&path);
    renderer.start(hand.positions[0]);
    for (std::size_t i = 0; i < run.proxies.size(); ++i) {
        if (run.is_reset[i]) renderer.reset(hand.positions[i]);
        renderer.step(hand.positions[i]);
        const double level = renderer.machine().rendered_level();
        verdict.levels.push_back(level);
        verdict.coarser += level > renderer.wanted_level() ? 1U : 0U;
        verdict.let_through += judge.is_free(path, level) ? 0U : 1U;
    }
    renderer.machine().record_path(nullptr);
    return verdict;
}

template Verdict judged(FixedLevel&, const CurveSet&, const Hand&, const HandRun&);
template Verdict judged(AutoLevel&, const CurveSet&, const Hand&, const HandRun&);

Deviation deviation(const HandRun& run, const HandRun& reference) {
    const std::size_t count = std::min(run.proxies.size(), reference.proxies.size());
    Deviation found;
    for (std::size_t i = 0; i < count; ++i) {
        const double apart_m = norm(run.proxies[i] - reference.proxies[i]);
        found.rms_m += apart_m * apart_m;
        found.max_m = std::max(found.max_m, apart_m);
    }
    found.rms_m = std::sqrt(found.rms_m / static_cast<double>(count));
    return found;
}

}  // namespace touchline::bench
