// The wavelets that the paper's is measured against, which only the bench has, and the simplifiers
// that maps use. Threads: pure functions.
#pragma once

#include "config/types/vec2.h"
#include "haptics/curve/wavelet.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace touchline::bench {

/// 13/7 is the product's own transform. Each low-pass has gain 1, so that its scaling coefficients
/// are points of the coarser curve. `subsample` keeps every second point; its details are the
/// others.
enum class Filter { paper_13_7, haar, cdf_5_3, cdf_9_7, subsample };

inline constexpr std::array all_filters{Filter::paper_13_7, Filter::haar, Filter::cdf_5_3,
                                        Filter::cdf_9_7, Filter::subsample};

[[nodiscard]] std::string_view name_of(Filter filter);

/// Returns where coarse point 0 of a level lies, in steps of level 0: 0, except for Haar, whose
/// points are in the middle of what they average.
[[nodiscard]] double first_parameter(Filter filter, int level);

/// Does one step on a closed curve; points.size() must be even. O(n).
[[nodiscard]] WaveletLevel analyze_closed(Filter filter, const std::vector<Position>& points);

/// Inverts the step, to rounding. O(n).
[[nodiscard]] std::vector<Position> synthesize_closed(Filter filter, const WaveletLevel& level);

/// Returns the points of the next coarser level of an open curve of an even number of segments; its
/// ends stay. 13/7 works as in the product. The others see the curve, less its chord, turned over
/// about both ends, as their symmetry needs. Not for Haar, whose points are not those of the curve.
/// O(n).
[[nodiscard]] std::vector<Position> coarser_open(Filter filter,
                                                 const std::vector<Position>& points);

/// Returns the closed curve with its details shrunk as the product does (wavelet.h) for white noise
/// of `sigma_m` a coordinate, down to `levels` levels. Measures each filter's own noise gains by
/// impulses. O(n^2).
[[nodiscard]] std::vector<Position> denoised(Filter filter, const std::vector<Position>& points,
                                             double sigma_m, int levels);

// The two simplifiers that maps use, to a given number of points: what is possible without levels.

/// Returns which points stay, ascending: `count` of them, 2 <= count <= points.size(), first and
/// last included. Douglas and Peucker: adds the point farthest from its chord next. O(n count).
[[nodiscard]] std::vector<std::size_t> douglas_peucker(const std::vector<Position>& points,
                                                       std::size_t count);

/// Visvalingam and Whyatt: removes the point that spans the smallest triangle with its neighbours
/// next. O(n log n).
[[nodiscard]] std::vector<std::size_t> visvalingam(const std::vector<Position>& points,
                                                   std::size_t count);

}  // namespace touchline::bench
