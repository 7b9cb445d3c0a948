#include "tests/lab/stability/linear_loop.h"

#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <unsupported/Eigen/MatrixFunctions>

namespace touchline::stability {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

/// d/dt [state, u] of the plant with u constant. The state begins with the tip's position.
MatrixXd plant_matrix(const TipParameters& tip, const HandModel& hand) {
    if (!hand.skin) {
        const double mass_kg = tip.mass_kg + hand.mass_kg;
        MatrixXd rates = MatrixXd::Zero(3, 3);
        rates(0, 1) = 1.0;
        rates(1, 0) = -hand.stiffness_N_per_m / mass_kg;
        rates(1, 1) = -(tip.viscous_Ns_per_m + hand.damping_Ns_per_m) / mass_kg;
        rates(1, 2) = 1.0 / mass_kg;
        return rates;
    }
    const double k = hand.skin->stiffness_N_per_m;
    const double b = hand.skin->damping_Ns_per_m;
    MatrixXd rates = MatrixXd::Zero(5, 5);
    rates(0, 1) = rates(2, 3) = 1.0;
    rates.row(1) << -k, -(tip.viscous_Ns_per_m + b), k, b, 1.0;
    rates.row(1) /= tip.mass_kg;
    rates.row(3) << k, b, -(k + hand.stiffness_N_per_m), -(b + hand.damping_Ns_per_m), 0.0;
    rates.row(3) /= hand.mass_kg;
    return rates;
}

/// Plant state after some time of constant force: motion * state + push * u.
struct Propagation {
    MatrixXd motion;
    VectorXd push;
};

Propagation propagate(const MatrixXd& rates, double span_s) {
    const MatrixXd all = (rates * span_s).exp();
    const Index n = rates.rows() - 1;
    return {all.topLeftCorner(n, n), all.topRightCorner(n, 1)};
}

/// One period on the state [plant, x_{k-1}, v_{k-1}, u_{k-1} ... u_{k-n-1}].
MatrixXd period_matrix(const MatrixXd& rates, const SampledWall& wall, double stiffness_N_per_m) {
    const double whole_periods = std::floor(wall.delay_s / wall.period_s + 1e-9);
    const double rest_s = std::max(0.0, wall.delay_s - whole_periods * wall.period_s);
    const auto delayed = static_cast<Index>(whole_periods);
    const Propagation first = propagate(rates, rest_s);
    const Propagation then = propagate(rates, wall.period_s - rest_s);
    const Index plant = rates.rows() - 1;
    const Index size = plant + 2 + delayed + 1;

    const double share = low_pass_share(wall.cutoff_Hz, wall.period_s);
    RowVectorXd velocity = RowVectorXd::Zero(size);
    velocity(0) = share / wall.period_s;
    velocity(plant) = -share / wall.period_s;
    velocity(plant + 1) = 1.0 - share;
    RowVectorXd force = -wall.damping_Ns_per_m * velocity;
    force(0) -= stiffness_N_per_m;
    const auto commanded = [&](Index periods_ago) {
        if (periods_ago == 0) return force;
        return RowVectorXd(RowVectorXd::Unit(size, plant + 1 + periods_ago));
    };

    MatrixXd period = MatrixXd::Zero(size, size);
    period.topLeftCorner(plant, plant) = then.motion * first.motion;
    period.topRows(plant) +=
        then.motion * first.push * commanded(delayed + 1) + then.push * commanded(delayed);
    period(plant, 0) = 1.0;
    period.row(plant + 1) = velocity;
    period.row(plant + 2) = force;
    for (Index j = 1; j <= delayed; ++j) period(plant + 2 + j, plant + 1 + j) = 1.0;
    return period;
}

}  // namespace

double low_pass_share(double cutoff_Hz, double period_s) {
    return -std::expm1(-2.0 * std::numbers::pi * cutoff_Hz * period_s);
}

LinearLoop::LinearLoop(const TipParameters& tip, const HandModel& hand, const SampledWall& wall)
    : without_spring_(period_matrix(plant_matrix(tip, hand), wall, 0.0)),
      per_stiffness_(period_matrix(plant_matrix(tip, hand), wall, 1.0) - without_spring_) {}

double LinearLoop::spectral_radius(double stiffness_N_per_m) const {
    const MatrixXd period = without_spring_ + stiffness_N_per_m * per_stiffness_;
    return Eigen::EigenSolver<MatrixXd>(period, false).eigenvalues().cwiseAbs().maxCoeff();
}

double LinearLoop::largest_stiffness(double most_N_per_m) const {
    const auto is_stable = [&](double stiffness) {
        return spectral_radius(stiffness) < 1.0 - 1e-13;
    };
    double stable = 0.0;
    double next = 1.0;
    for (; next < most_N_per_m && is_stable(next); next *= 1.02) stable = next;
    if (stable == 0.0) return 0.0;
    if (next >= most_N_per_m) return std::numeric_limits<double>::infinity();
    for (int halving = 0; halving < 40; ++halving) {
        const double middle = 0.5 * (stable + next);
        (is_stable(middle) ? stable : next) = middle;
    }
    return stable;
}

}  // namespace touchline::stability
