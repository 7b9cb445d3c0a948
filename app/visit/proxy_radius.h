// How large the proxy is in every picture. Threads: constants.
#pragma once

namespace touchline {

/// Radius of the proxy: 1.4 F / K at 0.7 N and 700 N/m, so that the force stays continuous around
/// corners in ordinary exploration. With a softer wall it stays continuous only up to F = K × 1 mm.
inline constexpr double proxy_radius_m = 0.0014;

}  // namespace touchline
