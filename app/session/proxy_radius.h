// How large the proxy is in every picture. Threads: constants.
#pragma once

namespace touchline {

/// Radius of the proxy: 1.4 F / K at 0.7 N and 700 N/m, so that the force stays continuous around
/// corners in ordinary exploration. A softer wall does so up to K times a millimetre only.
inline constexpr double proxy_radius_m = 0.0014;

}  // namespace touchline
