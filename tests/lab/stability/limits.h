// What theory says about a sampled wall: limits of its stiffness in closed form, and passivity from
// the wall's transfer function.
// m, b: device (and hand); f_c Coulomb friction; Delta encoder step; T period; t_d delay.
// Threads: pure functions.
#pragma once

#include <complex>
#include <functional>

namespace touchline::stability {

/// Colgate and Schenkel: passive against any passive hand, with the raw difference and no delay.
/// K <= 2 (b - |B|) / T.
[[nodiscard]] double colgate_stiffness(double b_Ns_per_m, double wall_damping_Ns_per_m,
                                       double period_s);

/// Gil and others: linear stability for little damping and short delays. K < (b + B) / (T/2 + t_d).
[[nodiscard]] double linear_stiffness(double b_Ns_per_m, double wall_damping_Ns_per_m,
                                      double period_s, double delay_s);

/// Abbott and Okamura: what Coulomb friction needs to absorb the energy that quantisation makes.
/// K <= 2 f_c / Delta; infinity without quantisation.
[[nodiscard]] double quantiser_stiffness(double coulomb_N, double encoder_step_m);

/// Returns the speed of impact below which friction still calms a wall that is too stiff:
/// v* = 4 f_c / (pi (K (T/2 + t_d) - b)); infinity if the wall is not too stiff.
[[nodiscard]] double calmed_speed_m_per_s(double stiffness_N_per_m, double b_Ns_per_m,
                                          double coulomb_N, double period_s, double delay_s);

/// Returns the stiffness at which calmed_speed is `speed_m_per_s`.
[[nodiscard]] double calmed_stiffness(double speed_m_per_s, double b_Ns_per_m, double coulomb_N,
                                      double period_s, double delay_s);

/// A wall -F/x as a function of z^-1 (N/m).
using Transfer = std::function<std::complex<double>(std::complex<double> z_inverse)>;

/// K + B (1 - z^-1)/T, the difference low-passed to a share 0 < share <= 1 of each new one.
[[nodiscard]] Transfer damped_spring(double stiffness_N_per_m, double wall_damping_Ns_per_m,
                                     double period_s, double share = 1.0);

/// K + B (1 - z^-n)/(nT): the slope over n periods.
[[nodiscard]] Transfer slope_damped_spring(double stiffness_N_per_m, double wall_damping_Ns_per_m,
                                           double period_s, int periods);

/// Least b for which the wall, sampled, held and delayed, is passive: the general condition of
/// Colgate and Schenkel, here for any delay. 4000 frequencies.
///
/// A motion with components v_n at w + 2 pi n/T is sampled to q = sum v_n/w_n, and the held force
/// works on p = sum exp(j w_n t_d) v_n/w_n. So the work is a Hermitian form of rank 2 in v, whose
/// larger eigenvalue is the b wanted. With t_d = (n + tau) T, theta = wT,
///   R = T/2 / (1 - cos theta) (1 - e^-j theta) H e^-j n theta,  rho = 1 - tau + tau e^-j theta:
///   b >= max over theta of (Re(R rho) + sqrt(|R|^2 - Im(R rho)^2)) / 2.
/// At t_d = 0 this is max Re R, theirs. At a delay that is no whole number of periods it is up to
/// 6 % more than at low frequency, K (T/2 + t_d).
[[nodiscard]] double least_damping_Ns_per_m(const Transfer& wall, double period_s,
                                            double delay_s = 0.0);

/// Returns the largest K for which wall(K) is passive with b; 0 if there is none.
[[nodiscard]] double passive_stiffness(const std::function<Transfer(double stiffness)>& wall,
                                       double b_Ns_per_m, double period_s, double delay_s);

}  // namespace touchline::stability
