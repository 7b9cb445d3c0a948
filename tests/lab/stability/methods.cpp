#include "tests/lab/stability/methods.h"

#include "tests/lab/stability/controllers.h"
#include "tests/lab/stability/limits.h"
#include "tests/lab/stability/linear_loop.h"

#include <algorithm>
#include <array>

namespace touchline::stability {
namespace {

template <WallController Controller>
ForceLaw law(Controller controller) {
    return [controller](double x_m) mutable { return controller.step(x_m); };
}

ForceLaw low_passed(double stiffness, double damping, const WallLoop& loop, double start_m,
                    double cutoff_Hz) {
    const double share = low_pass_share(cutoff_Hz, loop.period_s);
    return law(DampedWall(stiffness, damping, FilteredDifference(loop.period_s, start_m, share)));
}

ForceLaw observed(double stiffness, const WallLoop& loop, double start_m, double most_damping) {
    return law(EnergyObserverWall(stiffness, loop.period_s, start_m, most_damping));
}

ForceLaw spring(double stiffness, double, const WallLoop&, double) {
    return law(SpringWall(stiffness));
}

ForceLaw difference(double stiffness, double damping, const WallLoop& loop, double start_m) {
    return law(DampedWall(stiffness, damping, FilteredDifference(loop.period_s, start_m)));
}

ForceLaw low_pass(double stiffness, double damping, const WallLoop& loop, double start_m) {
    return low_passed(stiffness, damping, loop, start_m, 100.0);
}

ForceLaw window(double stiffness, double damping, const WallLoop& loop, double start_m) {
    return law(DampedWall(stiffness, damping,
                          AdaptiveWindow(loop.period_s, start_m, loop.encoder_step_m)));
}

constexpr int local_rate = 4;

ForceLaw local_model(double stiffness, double, const WallLoop&, double) {
    return [wall = LocalModelWall(stiffness, local_rate)](double x_m) mutable {
        return wall.step(x_m);
    };
}

/// A damper of more than half the mass per period overshoots.
ForceLaw observer(double stiffness, double, const WallLoop& loop, double start_m) {
    const double mass_kg = loop.tip.mass_kg + (loop.hand.skin ? 0.0 : loop.hand.mass_kg);
    return observed(stiffness, loop, start_m, 0.5 * mass_kg / loop.period_s);
}

ForceLaw observer_30(double stiffness, double, const WallLoop& loop, double start_m) {
    return observed(stiffness, loop, start_m, 30.0);
}

ForceLaw slope_bound(double stiffness, double, const WallLoop& loop, double start_m) {
    const double slope = linear_stiffness(damping_counted(loop), 0.0, loop.period_s, loop.delay_s);
    return law(SlopeBoundWall(stiffness, start_m, slope));
}

}  // namespace

double damping_counted(const WallLoop& loop) {
    const double hand = loop.hand.skin
                            ? std::min(loop.hand.skin->damping_Ns_per_m, loop.hand.damping_Ns_per_m)
                            : loop.hand.damping_Ns_per_m;
    return loop.tip.viscous_Ns_per_m + hand;
}

std::span<const Method> methods() {
    static const std::array all = {
        Method{"spring", 0.0, 1, spring},
        Method{"spring + difference", 2.0, 1, difference},
        Method{"spring + LP100", 2.0, 1, low_pass},
        Method{"spring + LP100, B = 5", 5.0, 1, low_pass},
        Method{"spring + FOAW16", 2.0, 1, window},
        Method{"local model", 0.0, local_rate, local_model},
        Method{"energy observer", 0.0, 1, observer},
        Method{"energy observer, cap 30", 0.0, 1, observer_30},
        Method{"slope bound", 0.0, 1, slope_bound},
    };
    return all;
}

const Method& method(std::string_view name) {
    return *std::find_if(methods().begin(), methods().end(),
                         [&](const Method& each) { return each.name == name; });
}

WallLoop force_loop(const Method& method, const WallLoop& loop) {
    WallLoop inner = loop;
    inner.period_s /= method.local_rate;
    inner.delay_s /= method.local_rate;
    return inner;
}

WallTrace render(const Method& method, double stiffness_N_per_m, const WallLoop& loop,
                 const Excitation& excitation, double span_s) {
    const WallLoop inner = force_loop(method, loop);
    const double start_m = quantised(excitation.start_m, loop.encoder_step_m);
    return run(inner, excitation,
               method.make(stiffness_N_per_m, method.damping_Ns_per_m, inner, start_m), span_s);
}

}  // namespace touchline::stability
