// Writes contact.csv into a folder: what each renderer does on each torture geometry.
#include "tests/haptics/contact/judge.h"
#include "tests/haptics/tick.h"
#include "tests/lab/bench/collision/report.h"
#include "tests/lab/bench/contact/renderers.h"
#include "tests/lab/bench/contact/torture.h"

#include <memory>

namespace touchline::bench {
namespace {

constexpr double disc_m = 2e-3;
constexpr double band_m = 1e-3;
constexpr double hung_m = 1e-6;  // the proxy hangs if it could be nearer to the hand by more
constexpr int look_every = 10;   // ticks, because the judge is slow

struct Outcome {
    int let_through = 0;  // times
    int hung = 0;         // of the ticks checked
    double jump_N = 0.0;
};

/// `judge` is nullptr if there is no proxy without thickness.
Outcome press(Renderer& renderer, const Torture& torture, const Judge* judge) {
    scenarios::Plant plant({}, torture.hand);
    renderer.start(plant.position());
    Outcome outcome;
    Position before = plant.position();
    Force force_before;
    for (std::size_t k = 0; static_cast<double>(k) * tick_s < torture.end_s; ++k) {
        const Position hand = plant.position();
        const Felt felt = renderer.step(hand);
        if (torture.is_through(before, felt.place)) ++outcome.let_through;
        const bool is_looked_at = judge != nullptr && k % look_every == 0;
        if (is_looked_at && judge->possible_gain_m(felt.place, hand) > hung_m) ++outcome.hung;
        outcome.jump_N = std::max(outcome.jump_N, norm(felt.force - force_before));
        before = felt.place;
        force_before = felt.force;
        plant.tick(k, felt.force);
    }
    return outcome;
}

void compare(const Torture& torture, CsvFile& csv) {
    CurveOptions whole_edges;
    whole_edges.spacing_m = 1.0;
    const Scene scene = scenarios::scene_of(torture.lines, disc_m, whole_edges);
    const Judge judge(scene.curves, 0.0, 2e-3);
    const auto row = [&](const char* name, Renderer&& renderer, const Judge* judged) {
        const Outcome outcome = press(renderer, torture, judged);
        csv.line(fmt::format(
            "{},{},{},{},{},{:.4f}", torture.group, torture.name, name, outcome.let_through,
            judged != nullptr ? std::to_string(outcome.hung) : "", outcome.jump_N));
    };
    row("Touchline (point)", Machine(scene, 0.0), &judge);
    if (torture.has_room) row("Touchline (disc of 2 mm)", Machine(scene, disc_m), nullptr);
    row("plain proxy", PlainProxy(torture.ring), &judge);
    row("penalty forces", Penalty(edges_of(scene.curves), band_m), nullptr);
}

}  // namespace
}  // namespace touchline::bench

int main(int argc, char** argv) {
    using namespace touchline::bench;
    if (argc != 2) {
        fmt::print(stderr, "usage: contact_bench FOLDER\n");
        return 2;
    }
    CsvFile csv(argv[1], "contact.csv", "group,torture,row,let_through,hung,max_jump_N");
    for (const Torture& torture : tortures()) compare(torture, csv);
    return 0;
}
