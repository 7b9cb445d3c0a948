// A curve with fewer points, by any of the methods, and how far it lies from the original curve.
// Curves are polylines; a closed one ends on its first point. Threads: pure functions.
#pragma once

#include "tests/lab/bench/curve/filters.h"

#include <string_view>
#include <vector>

namespace touchline::bench {

enum class Method { paper_13_7, haar, cdf_5_3, cdf_9_7, subsample, douglas_peucker, visvalingam };

inline constexpr std::array all_methods{Method::paper_13_7, Method::haar,
                                        Method::cdf_5_3,    Method::cdf_9_7,
                                        Method::subsample,  Method::douglas_peucker,
                                        Method::visvalingam};

[[nodiscard]] std::string_view name_of(Method method);

/// Whether the method is one of the five that halve their points level by level; the rest are the
/// simplifiers.
[[nodiscard]] constexpr bool is_filter(Method method) {
    return method < Method::douglas_peucker;
}

/// Returns the filter of such a method.
[[nodiscard]] constexpr Filter filter_of(Method method) {
    return static_cast<Filter>(method);
}

struct CoarseCurve {
    std::vector<Position> points;
    std::vector<double> parameters;  // where each lies on the fine curve, in its edges; ascending
};

[[nodiscard]] bool is_closed(const std::vector<Position>& line);

/// Returns a curve of the line's segments divided by 2^level, of which their number must be a
/// multiple. An open line keeps its ends; not for Haar.
[[nodiscard]] CoarseCurve coarse_curve(Method method, const std::vector<Position>& line, int level);

/// Returns the diagonal of the points' bounds: the size of a curve.
[[nodiscard]] double diagonal_m(const std::vector<Position>& points);

/// Shares of the fine curve's diagonal, except for the angle.
struct CurveError {
    double rms = 0.0;        // of the fine points from the coarse curve
    double hausdorff = 0.0;  // largest distance between the two, either way
    double slope_rad = 0.0;  // root mean square angle between a fine edge and its coarse segment
    double box = 0.0;  // mean half-width of the error boxes: each is aligned to a coarse segment
                       // and holds it and the fine curve over the same stretch
};

/// Returns how far `coarse` lies from `fine`, whose edges its parameters count. O(fine x coarse).
[[nodiscard]] CurveError curve_error(const std::vector<Position>& fine, const CoarseCurve& coarse);

}  // namespace touchline::bench
